// Reads pictures from the user's files and from projects.
#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>
#include <vector>

namespace dipwright {

// A picture file in memory, and its name for the user.
struct PackedPicture {
    QByteArray bytes; // PNG, JPEG, BMP, TIFF or WebP
    QString where;
};

// A picture, and the amounts of ink (base/InkPicture.h) if its file is in CMYK with an ICC profile.
struct ReadPicture {
    QImage colours;
    QImage inks; // null: none
};

// Counts the pictures that are opened together, such as in one project, against Budgets.h. A
// picture counts each time that it is named. A picture in wide colour counts twice, since its
// pixels take twice the bytes.
class PictureCount {
public:
    // Adds a picture. `packedBytes` is the size of its file. Throws Error if the budget is
    // exceeded.
    void add(const QImage& picture, qint64 packedBytes, const QString& where);

private:
    qint64 pixels_ = 0, packedBytes_ = 0;
};

// Decodes all pictures in the sandboxed process dipwright-reader. The results are RGBA8888 in sRGB,
// or pictures in wide colour (base/WideGamut.h). Pictures with the same name share their pixels,
// but each counts. Throws Error if one cannot be read or if together they exceed Budgets.h. Read
// pictures that belong together in one call.
std::vector<QImage> readPictures(const std::vector<PackedPicture>& pictures);

// Reads one picture from a file that the user has chosen.
QImage readPictureFile(const QString& path);
// The same, with the picture's amounts of ink.
ReadPicture readPictureAndInks(const QString& path);

} // namespace dipwright
