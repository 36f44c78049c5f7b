#include "base/InkPicture.h"

#include "base/ImageRows.h"

#include <QCryptographicHash>

#include <algorithm>

namespace dipwright {
namespace {

constexpr qsizetype headerBytes = 128;
constexpr qsizetype identityDigits = 32;

} // namespace

QString iccIdentity(const QByteArray& profile) {
    if (profile.isEmpty()) {
        return {};
    }
    // Takes only class, colour space and connection space from the header (ICC.1, 7.2).
    const QByteArray counted = profile.mid(12, 12) + profile.mid(headerBytes);
    return QString::fromLatin1(QCryptographicHash::hash(counted, QCryptographicHash::Md5).toHex());
}

QImage inkPicture(QSize size, const QString& space) {
    QImage picture(size, QImage::Format_RGBA8888);
    if (!picture.isNull()) {
        picture.fill(Qt::transparent); // all bytes 0
        picture.setText(QString::fromLatin1(inkSpaceKey), space);
    }
    return picture;
}

QString inkSpace(const QImage& picture) {
    const QString space = picture.text(QString::fromLatin1(inkSpaceKey));
    const bool isIdentity =
        space.size() == identityDigits && std::all_of(space.begin(), space.end(), [](QChar digit) {
            return (digit >= u'0' && digit <= u'9') || (digit >= u'a' && digit <= u'f');
        });
    return isIdentity ? space : QString();
}

InkPlanes inkPlanes(const QImage& inks) {
    if (inks.isNull()) {
        return {};
    }
    InkPlanes planes{blankImage(inks.size(), QImage::Format_RGBA8888),
                     blankImage(inks.size(), QImage::Format_RGBA8888), inkSpace(inks)};
    for (int y = 0; y < inks.height(); ++y) {
        const uchar* from = inks.constScanLine(y);
        uchar* colours = planes.colours.scanLine(y);
        uchar* black = planes.black.scanLine(y);
        for (int x = 0; x < inks.width(); ++x, from += 4, colours += 4, black += 4) {
            std::copy_n(from, 3, colours);
            colours[3] = 255;
            black[0] = from[3];
            black[1] = 255;
            black[3] = 255;
        }
    }
    return planes;
}

} // namespace dipwright
