// Runs dipwright-reader, a sandboxed process that reads one untrusted model or some pictures, and
// checks its results. Private to this folder.
#pragma once

#include "base/Progress.h"
#include "import/trusted/ReadPictures.h"
#include "import/trusted/ReaderMessages.h"
#include "import/trusted/UntrustedFiles.h"

namespace dipwright {

// Reads a model. The process receives the model file and the files that it names only through
// `files`. `path` names the model for `files` and in messages. Throws Error if the process refuses
// the model, crashes, runs out of memory or time, or returns invalid data. Throws Cancelled
// immediately. May be called from any thread; several calls may run at once.
UntrustedModel readModelInProcess(const QString& path, bool withTextures, UntrustedFiles& files,
                                  const Progress& progress);

// Reads a CAD file in the same way. The triangles are in mm by the file's unit, unscaled. Also
// throws Error if this program was built without the reader for CAD files.
UntrustedModel readCadInProcess(const QString& path, const Tessellation& tessellation,
                                UntrustedFiles& files, const Progress& progress);

// Reads pictures, as RGBA8888 in sRGB or as wide (base/WideGamut.h). `names` are their names in
// `files` and in messages.
std::vector<ReadPicture> readPicturesInProcess(const QStringList& names, UntrustedFiles& files);

struct ReadPhoto {
    QImage picture;   // upright
    PhotoFacts facts; // within their limits, but not otherwise checked
};
// Reads a photo from the file `name`.
ReadPhoto readPhotoInProcess(const QString& name, UntrustedFiles& files, const Progress& progress);

} // namespace dipwright
