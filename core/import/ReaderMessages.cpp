#include "import/ReaderMessages.h"

#include <QDataStream>
#include <QIODevice>
#include <QtEndian>

namespace dipwright {

namespace {

template <typename Write>
QByteArray streamed(const Write& write) {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream.setVersion(QDataStream::Qt_6_4);
    stream.setByteOrder(QDataStream::LittleEndian);
    write(stream);
    return bytes;
}

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
        stream << quint8(job.kind) << job.names << job.withTextures << job.language;
    });
}

ReaderJob readJob(const QByteArray& bytes) {
    QDataStream stream(bytes);
    stream.setVersion(QDataStream::Qt_6_4);
    stream.setByteOrder(QDataStream::LittleEndian);
    ReaderJob job;
    quint8 kind = 0;
    stream >> kind >> job.names >> job.withTextures >> job.language;
    job.kind = ReaderJob::Kind(kind);
    return job;
}

QByteArray pictureHeaderBytes(const QImage& picture) {
    return streamed([&](QDataStream& stream) {
        stream << qint32(picture.width()) << qint32(picture.height())
               << qint32(picture.dotsPerMeterX()) << qint32(picture.dotsPerMeterY());
    });
}

QImage emptyPicture(const QByteArray& header) {
    const auto number = [&](int place) {
        return qFromLittleEndian<qint32>(header.constData() + 4 * place);
    };
    if (number(0) <= 0 || number(1) <= 0) {
        return QImage();
    }
    QImage picture(number(0), number(1), QImage::Format_RGBA8888);
    if (!picture.isNull() && number(2) > 0 && number(3) > 0) {
        picture.setDotsPerMeterX(number(2));
        picture.setDotsPerMeterY(number(3));
    }
    return picture;
}

} // namespace dipwright
