// Reads models of all formats from untrusted bytes.
#pragma once

#include "base/Progress.h"
#include "import/trusted/UntrustedFiles.h"

namespace dipwright {

// Reads the model file `path` and the files that it names, all through `files`. `path` appears in
// messages and also gives the format if the content does not. `withTextures` is false if another
// picture will replace the model's own. Throws Error if the file is no model, is damaged or exceeds
// Budgets.h.
UntrustedModel readUntrustedModel(const QString& path, UntrustedFiles& files, bool withTextures,
                                  const Progress& progress);

} // namespace dipwright
