// Connects the reader to the program that started it, over the standard streams
// (core/import/trusted/ReaderMessages.h).
#pragma once

#include "base/Error.h"
#include "import/trusted/ReaderMessages.h"
#include "import/trusted/UntrustedFiles.h"
#include "reader/Sandbox.h"

#include <QFile>

namespace dipwright {

class Pipe : public UntrustedFiles {
public:
    // Each file that is read raises the process's limits, as `limits` says. From now on, text that
    // libraries print is discarded.
    explicit Pipe(const ReaderLimits& limits);

    // Returns the first message. Like all functions here, it ends the process if the other side has
    // closed the streams.
    ReaderJob readJob();

    void report(double share, const QString& text);
    // `inks` are the picture's amounts of ink; null if it has none.
    void hand(const QImage& picture, const QImage& inks = {});
    void hand(const PhotoFacts& facts);     // call before sending its picture
    void hand(const UntrustedModel& model); // call after sending its pictures
    void fail(const Error& error);

private:
    // Requests a file from the program that started the reader.
    std::optional<QByteArray> fetch(const QString& name) override;
    QByteArray take(qint64 length);
    void write(const QByteArray& bytes);
    void sendPixels(ReaderMessage kind, const QImage& picture);
    void send(ReaderMessage kind, const QByteArray& bytes);

    ReaderLimits limits_;
    QFile in_, out_;
    qint64 allowedFor_ = 0;
};

} // namespace dipwright
