// Pictures from files of users and out of projects.
#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>
#include <vector>

namespace dipwright {

// A picture file in memory, and what the user knows it by, its name.
struct PackedPicture {
    QByteArray bytes; // PNG, JPEG, BMP, TIFF or WebP
    QString where;
};

// All of them, RGBA8888 in sRGB or wide (base/WideColour.h), unpacked by dipwright-reader in a
// process of its own. Those of one name are one picture: they share their pixels and count as often
// as they come. Throws Error for what cannot be read or is more than Budgets.h allows together.
std::vector<QImage> readPictures(const std::vector<PackedPicture>& pictures);

// One from a file that the user has chosen.
QImage readPictureFile(const QString& path);

} // namespace dipwright
