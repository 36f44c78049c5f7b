#include "import/sandboxed/PhotoFacts.h"

#include "import/sandboxed/PictureFile.h"

#include <QtEndian>

namespace dipwright {

namespace {

enum Tag : quint16 {
    Orientation = 0x112,
    ExifFolder = 0x8769,
    Taken = 0x9003,
    FocalLength35 = 0xa405
};

class Tags {
public:
    explicit Tags(QByteArray bytes)
        : bytes_(std::move(bytes)), isLittle_(bytes_.startsWith("II")) {}

    // Returns 0 if the number is not entirely within the bytes.
    template <typename Number>
    Number number(qint64 at) const {
        if (at < 0 || at + qint64(sizeof(Number)) > bytes_.size()) {
            return 0;
        }
        return isLittle_ ? qFromLittleEndian<Number>(bytes_.constData() + at)
                         : qFromBigEndian<Number>(bytes_.constData() + at);
    }

    qint64 first() const { return number<quint32>(4); } // where the first directory begins

    // Returns where the TIFF directory (IFD) that begins at `folder` stores the value of a tag. For
    // a long value, that place holds the offset of the value. Returns −1 if there is no such tag.
    qint64 value(qint64 folder, Tag tag) const {
        const int entries = folder > 0 ? number<quint16>(folder) : 0;
        for (qint64 at = folder + 2; at < folder + 2 + 12LL * entries; at += 12) {
            if (number<quint16>(at) == tag) {
                return at + 8;
            }
        }
        return -1;
    }

    QByteArray text(qint64 value) const {
        constexpr qint64 longest = 64;
        const qint64 length = number<quint32>(value - 4), at = number<quint32>(value);
        const bool isThere = length > 4 && length <= longest && at + length <= bytes_.size();
        return isThere ? bytes_.mid(at, length) : QByteArray();
    }

private:
    QByteArray bytes_;
    bool isLittle_;
};

} // namespace

PhotoFacts photoFacts(const QByteArray& file) {
    constexpr int mostFocalLength = 5000; // mm
    const Tags tags(exifOf(file));
    const auto exif = tags.number<quint32>(tags.value(tags.first(), ExifFolder));
    const int focalLength = tags.number<quint16>(tags.value(exif, FocalLength35));
    return {QString::fromLatin1(tags.text(tags.value(exif, Taken)).left(19)),
            focalLength <= mostFocalLength ? double(focalLength) : 0};
}

int exifOrientation(const QByteArray& file) {
    const Tags tags(exifOf(file));
    const int orientation = tags.number<quint16>(tags.value(tags.first(), Orientation));
    return orientation >= 1 && orientation <= 8 ? orientation : 1;
}

} // namespace dipwright
