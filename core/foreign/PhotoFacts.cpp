#include "foreign/PhotoFacts.h"

#include <QtEndian>

#include <optional>

namespace dipwright {

namespace {

enum Tag : quint16 { ExifFolder = 0x8769, Taken = 0x9003, FocalLength35 = 0xa405 };

constexpr int mostEntries = 1000;

// The TIFF structure in which the tags are, at the begin of a TIFF file or in a segment of a JPEG.
QByteArrayView tagsOf(const QByteArray& file) {
    const QByteArrayView view(file);
    if (file.startsWith("II") || file.startsWith("MM")) {
        return view;
    }
    const auto byte = [&](qsizetype at) { return uchar(view[at]); };
    qsizetype at = 2;
    while (file.startsWith("\xff\xd8") && at + 4 <= view.size() && byte(at) == 0xff) {
        const qsizetype length = byte(at + 2) << 8 | byte(at + 3);
        const bool isPicture = byte(at + 1) == 0xda; // from here on there are pixels
        if (isPicture || length < 2 || at + 2 + length > view.size()) {
            break;
        }
        const QByteArrayView segment = view.sliced(at + 4, length - 2);
        if (byte(at + 1) == 0xe1 && segment.startsWith(QByteArrayView("Exif\0\0", 6))) {
            return segment.sliced(6);
        }
        at += 2 + length;
    }
    return {};
}

class Tags {
public:
    explicit Tags(QByteArrayView bytes) : bytes_(bytes), isLittle_(bytes.startsWith("II")) {}

    std::optional<quint32> firstFolder() const { return long_(4); }

    // Where the entry of that tag is in a folder.
    std::optional<quint32> entry(quint32 folder, quint16 tag) const {
        const int entries = std::min(int(short_(folder).value_or(0)), mostEntries);
        for (int i = 0; i < entries; ++i) {
            const qint64 at = qint64(folder) + 2 + 12 * i;
            if (short_(at) == tag) {
                return quint32(at);
            }
        }
        return std::nullopt;
    }

    std::optional<quint16> shortOf(quint32 entry) const { return short_(entry + 8LL); }
    std::optional<quint32> longOf(quint32 entry) const { return long_(entry + 8LL); }
    QByteArray textOf(quint32 entry) const {
        constexpr quint32 longest = 64;
        const quint32 length = long_(entry + 4LL).value_or(0);
        const qint64 at = long_(entry + 8LL).value_or(0);
        const bool isThere = length > 4 && length <= longest && at + length <= bytes_.size();
        return isThere ? bytes_.sliced(at, length).toByteArray() : QByteArray();
    }

private:
    std::optional<quint16> short_(qint64 at) const {
        if (at < 0 || at + 2 > bytes_.size()) {
            return std::nullopt;
        }
        return isLittle_ ? qFromLittleEndian<quint16>(bytes_.data() + at)
                         : qFromBigEndian<quint16>(bytes_.data() + at);
    }
    std::optional<quint32> long_(qint64 at) const {
        if (at < 0 || at + 4 > bytes_.size()) {
            return std::nullopt;
        }
        return isLittle_ ? qFromLittleEndian<quint32>(bytes_.data() + at)
                         : qFromBigEndian<quint32>(bytes_.data() + at);
    }

    QByteArrayView bytes_;
    bool isLittle_;
};

} // namespace

PhotoFacts photoFacts(const QByteArray& file) {
    constexpr int mostFocalLength = 5000; // mm
    const Tags tags(tagsOf(file));
    PhotoFacts facts;
    const auto folder = tags.firstFolder();
    const auto pointer = folder ? tags.entry(*folder, ExifFolder) : std::nullopt;
    const auto exif = pointer ? tags.longOf(*pointer) : std::nullopt;
    if (!exif) {
        return facts;
    }
    if (const auto taken = tags.entry(*exif, Taken)) {
        facts.taken = QString::fromLatin1(tags.textOf(*taken).left(19));
    }
    if (const auto focal = tags.entry(*exif, FocalLength35)) {
        const int length = tags.shortOf(*focal).value_or(0);
        facts.focalLength = length <= mostFocalLength ? length : 0;
    }
    return facts;
}

} // namespace dipwright
