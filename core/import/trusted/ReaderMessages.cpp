#include "import/trusted/ReaderMessages.h"

#include "base/ColourNote.h"
#include "base/InkPicture.h"
#include "base/WideGamut.h"

#include <QDataStream>
#include <QIODevice>
#include <QtEndian>

namespace dipwright {

namespace {

constexpr int spaceBytes = 16;

template <typename Write>
QByteArray streamed(const Write& write) {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream.setVersion(QDataStream::Qt_6_4);
    stream.setByteOrder(QDataStream::LittleEndian);
    write(stream);
    return bytes;
}

// Reads what streamed() has written.
class ReadStream : public QDataStream {
public:
    explicit ReadStream(const QByteArray& bytes) : QDataStream(bytes) {
        setVersion(Qt_6_4);
        setByteOrder(LittleEndian);
    }
};

} // namespace

QByteArray headerBytes(ReaderMessage kind, qint64 length) {
    return streamed([&](QDataStream& stream) { stream << quint8(kind) << quint64(length); });
}

std::pair<ReaderMessage, qint64> readHeader(const QByteArray& header) {
    const auto length = qFromLittleEndian<quint64>(header.constData() + 1);
    return {ReaderMessage(header[0]), qint64(std::min(length, quint64(1) << 62))};
}

QByteArray jobBytes(const ReaderJob& job) {
    return streamed([&](QDataStream& stream) {
        const Tessellation& cad = job.tessellation;
        stream << quint8(job.kind) << job.names << job.withTextures << job.language << cad.tolerance
               << cad.unitMillimetres << cad.longestEdge;
    });
}

ReaderJob readJob(const QByteArray& bytes) {
    ReadStream stream(bytes);
    ReaderJob job;
    quint8 kind = 0;
    Tessellation& cad = job.tessellation;
    stream >> kind >> job.names >> job.withTextures >> job.language >> cad.tolerance >>
        cad.unitMillimetres >> cad.longestEdge;
    job.kind = ReaderJob::Kind(kind);
    return job;
}

QByteArray factsBytes(const PhotoFacts& facts) {
    return streamed(
        [&](QDataStream& stream) { stream << facts.taken.toUtf8() << facts.focalLength; });
}

PhotoFacts readFacts(const QByteArray& bytes) {
    ReadStream stream(bytes);
    PhotoFacts facts;
    QByteArray taken;
    stream >> taken >> facts.focalLength;
    facts.taken = QString::fromUtf8(taken);
    return facts;
}

QByteArray cadBytes(const CadFacts& facts) {
    return streamed(
        [&](QDataStream& stream) { stream << facts.unit.toUtf8() << facts.tessellation; });
}

CadFacts readCadFacts(const QByteArray& bytes) {
    ReadStream stream(bytes);
    CadFacts facts;
    QByteArray unit;
    stream >> unit >> facts.tessellation;
    facts.unit = QString::fromUtf8(unit);
    return facts;
}

QByteArray pictureHeaderBytes(const QImage& picture) {
    const ColourNote note = colourNote(picture);
    return streamed([&](QDataStream& stream) {
        stream << qint32(picture.width()) << qint32(picture.height())
               << qint32(picture.dotsPerMeterX()) << qint32(picture.dotsPerMeterY())
               << qint32(isWide(picture)) << qint32(note.assumesInks) << qint32(note.isTurned)
               << qint32(note.assumesSrgb) << note.clipped;
        const QByteArray space = QByteArray::fromHex(inkSpace(picture).toLatin1());
        stream.writeRawData(space.leftJustified(spaceBytes, '\0', true).constData(), spaceBytes);
    });
}

QImage emptyPicture(const QByteArray& header) {
    ReadStream stream(header);
    qint32 width = 0, height = 0, dotsPerMeterX = 0, dotsPerMeterY = 0, wide = 0, inks = 0,
           turned = 0, srgb = 0;
    ColourNote note;
    stream >> width >> height >> dotsPerMeterX >> dotsPerMeterY >> wide >> inks >> turned >> srgb >>
        note.clipped;
    note.assumesInks = inks != 0;
    note.isTurned = turned != 0;
    note.assumesSrgb = srgb != 0;
    const QByteArray space = header.right(spaceBytes);
    if (width <= 0 || height <= 0) {
        return QImage();
    }
    if (space.count('\0') < spaceBytes) {
        return inkPicture({width, height}, QString::fromLatin1(space.toHex()));
    }
    QImage picture(width, height, wide ? QImage::Format_RGBA64 : QImage::Format_RGBA8888);
    if (wide) {
        picture.setColorSpace(wideSpace());
    }
    if (!picture.isNull() && dotsPerMeterX > 0 && dotsPerMeterY > 0) {
        picture.setDotsPerMeterX(dotsPerMeterX);
        picture.setDotsPerMeterY(dotsPerMeterY);
    }
    return note.isEmpty() || picture.isNull() ? picture : withColourNote(picture, note);
}

} // namespace dipwright
