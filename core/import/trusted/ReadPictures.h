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

// Counts the pictures of one project, or of whatever else is opened at once, against what Budgets.h
// allows together: each as often as it is named, and a wide one twice, as it takes twice the bytes.
class PictureCount {
public:
    // `packedBytes`: of its file. Throws Error where it is one too many.
    void add(const QImage& picture, qint64 packedBytes, const QString& where);

private:
    qint64 pixels_ = 0, packedBytes_ = 0;
};

// All of them, RGBA8888 in sRGB or wide (base/WideGamut.h), unpacked by dipwright-reader in a
// process of its own. Those of one name are one picture: they share their pixels and count as often
// as they come. Throws Error for what cannot be read or is more than Budgets.h allows together:
// what belongs together is read by one call.
std::vector<QImage> readPictures(const std::vector<PackedPicture>& pictures);

// One from a file that the user has chosen.
QImage readPictureFile(const QString& path);

} // namespace dipwright
