// Starts dipwright-reader, a process of its own that may do nothing but compute, lets it read one
// foreign model or some pictures, and looks at what it hands back before anything is made of it.
// Private to this folder.
#pragma once

#include "base/Progress.h"
#include "import/trusted/ReaderMessages.h"
#include "import/trusted/UntrustedFiles.h"

namespace dipwright {

// ms until what is computed for files of these many bytes counts as hanging, by the clock: their
// budget of time, and more, as others may have the processor.
qint64 patienceWith(qint64 fileBytes);

// The model file and what it names come to the process through `files` alone. `path` names the
// model for `files` and in messages. Throws Error for what the process refuses, and where it
// breaks, runs out of memory or time, or hands back what cannot be; Cancelled, at once. Any thread,
// and several at a time.
UntrustedModel readModelInProcess(const QString& path, bool withTextures, UntrustedFiles& files,
                                  const Progress& progress);

// Pictures, RGBA8888 in sRGB or wide (base/WideGamut.h); `files` knows them by the same names as
// the user.
std::vector<QImage> readPicturesInProcess(const QStringList& names, UntrustedFiles& files);

struct ReadPhoto {
    QImage picture;   // upright
    PhotoFacts facts; // within their limits, but of whatever sense
};
ReadPhoto readPhotoInProcess(const QString& name, UntrustedFiles& files, const Progress& progress);

} // namespace dipwright
