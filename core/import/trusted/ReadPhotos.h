// Photos of users, with what the camera has written into them.
#pragma once

#include "base/Progress.h"

#include <QDateTime>
#include <QImage>
#include <QStringList>
#include <optional>

namespace dipwright {

struct Photo {
    QString where;                  // the file
    QImage picture;                 // upright, RGBA8888 in sRGB
    QString sha256;                 // of the file, hexadecimal
    std::optional<QDateTime> taken; // by the camera's clock, to the second, of no time zone
    // Of the lens, in half diagonals of the picture.
    std::optional<double> focalLength;
};

// For file dialogs: "*.jpg" and the like, of photos that can be read here.
QStringList photoPatterns();

// From a file that the user has chosen, read by dipwright-reader in a process of its own.
// Throws Error for what cannot be read or is more than Budgets.h allows; Cancelled.
Photo readPhotoFile(const QString& path, const Progress& progress = {});

} // namespace dipwright
