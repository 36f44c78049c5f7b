// Decodes pictures from untrusted bytes.
#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>
#include <map>

namespace dipwright {

// Decodes pictures one by one and counts all their pixels against one budget. A picture counts each
// time that it is decoded. Use an object from one thread at a time.
class PictureReader {
public:
    // Loads all libraries for pictures. In the sandbox no file can be opened, so they cannot be
    // loaded later.
    static void prepare();

    // `Upright` is for photos that people look at. They are always in sRGB, and rotated as the file
    // says that the camera was held.
    enum class Turned { AsStored, Upright };
    // Decodes to RGBA8888 in sRGB, or to wide (base/WideGamut.h) for a texture with colours outside
    // sRGB. Reads PNG, JPEG, BMP, TIFF and WebP by their content, and HEIF if Qt has a plugin for
    // it. Throws Error, naming `where`, if the bytes are not such a picture, have no pixels or
    // exceed Budgets.h. The size is checked before anything is decoded.
    QImage read(const QByteArray& bytes, const QString& where, Turned turned = Turned::AsStored);

    // Returns the amounts of ink of a picture that read() returned and that has not been changed
    // since, if its file is in CMYK with an ICC profile (base/InkPicture.h); otherwise null.
    QImage inksOf(const QImage& picture) const;

    // Takes pixels that were not in a file of their own. Checks them like other pictures and
    // converts them to RGBA8888.
    QImage take(QImage image, const QString& where);

private:
    QImage decoded(const QByteArray& bytes, const QString& where, Turned turned);
    QImage readInLab(const QByteArray& bytes, const QSize& announced, const QString& where);
    void count(const QSize& size, qint64 fileBytes, const QString& where);

    qint64 pixels_ = 0, fileBytes_ = 0;
    std::map<qint64, QImage> inks_; // by the picture's cache key
};

} // namespace dipwright
