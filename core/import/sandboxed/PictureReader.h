// Pictures from bytes that nobody has looked at yet.
#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>

namespace dipwright {

// Decodes one after the other and counts their pixels together, as often as each comes. One thread.
class PictureReader {
public:
    // Loads all libraries that reading pictures takes. They cannot be loaded later where files
    // cannot be opened.
    static void prepare();

    // To RGBA8888 in sRGB or, a texture with colours that this does not hold, wide. PNG, JPEG, BMP,
    // TIFF and WebP by their content, and HEIF where Qt has a plugin for it; nothing else is tried.
    // Throws Error, naming `where`, for what is no such picture, has no pixels or more than
    // Budgets.h allows; nothing is decoded before its size is known to do. Upright: a photo, to be
    // looked at; in sRGB, turned as the camera was held, where the file says how.
    enum class Turned { AsStored, Upright };
    QImage read(const QByteArray& bytes, const QString& where, Turned turned = Turned::AsStored);

    // Pixels that came in no file of their own: checks them as the others and brings them to
    // RGBA8888.
    QImage take(QImage image, const QString& where);

private:
    QImage readInLab(const QByteArray& bytes, const QSize& announced, const QString& where);
    void count(const QSize& size, qint64 fileBytes, const QString& where);

    qint64 pixels_ = 0, fileBytes_ = 0;
};

} // namespace dipwright
