// Reads photos from files, with the camera's data in them.
#pragma once

#include "base/Progress.h"

#include <QDateTime>
#include <QImage>
#include <QStringList>
#include <optional>

namespace dipwright {

struct Photo {
    QString where;                  // path of the file
    QImage picture;                 // upright, RGBA8888 in sRGB
    QString sha256;                 // SHA-256 of the file, hexadecimal
    std::optional<QDateTime> taken; // time by the camera's clock, to the second; no time zone
    // Focal length of the lens, in units of half the diagonal of the picture.
    std::optional<double> focalLength;
};

// Returns file patterns for dialogs, such as "*.jpg", of photos that this computer can read.
QStringList photoPatterns();

// Reads a file that the user has chosen, by the sandboxed process dipwright-reader. Throws Error if
// it cannot be read or exceeds Budgets.h. Throws Cancelled.
Photo readPhotoFile(const QString& path, const Progress& progress = {});

} // namespace dipwright
