// Reading models of all formats, from bytes that nobody has looked at yet.
#pragma once

#include "base/Progress.h"
#include "import/trusted/UntrustedFiles.h"

namespace dipwright {

// Reads the model file `path` and what it names, all of it through `files`. `path` also tells the
// format, where its content does not, and stands in messages. `withTextures`: false where another
// picture will replace the model's own. Throws Error for what is no model, is damaged or asks for
// more than Budgets.h allows.
UntrustedModel readUntrustedModel(const QString& path, UntrustedFiles& files, bool withTextures,
                                  const Progress& progress);

} // namespace dipwright
