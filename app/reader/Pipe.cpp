#include "reader/Pipe.h"

#include "model/StoredModel.h"
#include "reader/Sandbox.h"

#include <QDataStream>

#if defined(Q_OS_UNIX)
#include <fcntl.h>
#include <unistd.h>
#endif

#include <cstdlib>

namespace dipwright {

namespace {

// Returns the stream to the program that started the reader, which libraries cannot reach.
int ownOutput() {
#if defined(Q_OS_UNIX)
    const int own = dup(1);
    const int nowhere = open("/dev/null", O_WRONLY);
    if (own >= 0 && nowhere >= 0 && dup2(nowhere, 1) >= 0) {
        return own;
    }
#endif
    return 1;
}

} // namespace

Pipe::Pipe(const ReaderLimits& limits) : limits_(limits) {
    if (!in_.open(0, QIODevice::ReadOnly | QIODevice::Unbuffered) ||
        !out_.open(ownOutput(), QIODevice::WriteOnly | QIODevice::Unbuffered)) {
        std::_Exit(EXIT_FAILURE);
    }
}

ReaderJob Pipe::readJob() {
    const auto [kind, length] = readHeader(take(readerHeaderBytes));
    if (kind != ReaderMessage::Job) {
        std::_Exit(EXIT_FAILURE);
    }
    return dipwright::readJob(take(length));
}

void Pipe::report(double share, const QString& text) {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream << share << text.toUtf8();
    send(ReaderMessage::Progress, bytes);
}

void Pipe::hand(const QImage& picture, const QImage& inks) {
    if (!inks.isNull()) {
        sendPixels(ReaderMessage::Inks, inks);
    }
    sendPixels(ReaderMessage::Picture, picture);
}

void Pipe::sendPixels(ReaderMessage kind, const QImage& picture) {
    write(headerBytes(kind, pictureHeaderLength + picture.sizeInBytes()));
    write(pictureHeaderBytes(picture));
    write(QByteArray::fromRawData(reinterpret_cast<const char*>(picture.constBits()),
                                  picture.sizeInBytes()));
}

void Pipe::hand(const PhotoFacts& facts) {
    send(ReaderMessage::Photo, factsBytes(facts));
}

void Pipe::hand(const UntrustedModel& model) {
    QStringList lines;
    for (const QString& warning : model.warnings) {
        lines << warning.simplified();
    }
    if (model.cad) {
        send(ReaderMessage::Cad, cadBytes(*model.cad));
    }
    send(ReaderMessage::Model, lines.join(u'\n').toUtf8());
    TexturedMesh bare = withoutPictures(model.mesh);
    bare.chart.resize(bare.mesh.triangles.size()); // the receiving program computes the charts
    send(ReaderMessage::Mesh, writeModel(bare));
}

void Pipe::fail(const Error& error) {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream << error.message().toUtf8() << error.where().toUtf8();
    send(ReaderMessage::Failed, bytes);
}

std::optional<QByteArray> Pipe::fetch(const QString& name) {
    send(ReaderMessage::Ask, name.toUtf8());
    const auto [kind, length] = readHeader(take(readerHeaderBytes));
    if (kind != ReaderMessage::File) {
        return std::nullopt;
    }
    allowedFor_ += length;
    raiseLimits(limits_, allowedFor_);
    return take(length);
}

QByteArray Pipe::take(qint64 length) {
    QByteArray bytes(length, Qt::Uninitialized);
    for (qint64 done = 0; done < length;) {
        const qint64 got = in_.read(bytes.data() + done, length - done);
        if (got <= 0) {
            std::_Exit(EXIT_FAILURE);
        }
        done += got;
    }
    return bytes;
}

void Pipe::write(const QByteArray& bytes) {
    if (out_.write(bytes) != bytes.size()) {
        std::_Exit(EXIT_FAILURE);
    }
}

void Pipe::send(ReaderMessage kind, const QByteArray& bytes) {
    write(headerBytes(kind, bytes.size()));
    write(bytes);
}

} // namespace dipwright
