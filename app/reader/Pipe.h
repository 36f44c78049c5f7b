// The way to the program that has started this one (core/import/trusted/ReaderMessages.h): over the
// standard streams.
#pragma once

#include "base/Error.h"
#include "import/trusted/ReaderMessages.h"
#include "import/trusted/UntrustedFiles.h"

#include <QFile>

namespace dipwright {

class Pipe : public UntrustedFiles {
public:
    Pipe();

    // The first message. Ends the process where there is none, as all here does where the other
    // side is gone.
    ReaderJob readJob();

    void report(double share, const QString& text);
    void hand(const QImage& picture);
    void hand(const PhotoFacts& facts);     // before its picture
    void hand(const UntrustedModel& model); // after its pictures
    void fail(const Error& error);

private:
    // Asks the other side.
    std::optional<QByteArray> fetch(const QString& name) override;
    QByteArray take(qint64 length);
    void write(const QByteArray& bytes);
    void send(ReaderMessage kind, const QByteArray& bytes);

    QFile in_, out_;
    qint64 allowedFor_ = 0;
};

} // namespace dipwright
