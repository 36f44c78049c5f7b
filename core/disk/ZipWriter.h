// Zips, written the same way every time.
#pragma once

#include <QBuffer>
#include <QByteArray>
#include <QString>
#include <memory>

class QuaZip;

namespace dipwright {

// A zip written into memory: no time stamps, so that equal contents give equal bytes.
class ZipWriter {
public:
    enum class Packing { Stored, Deflated };

    ZipWriter();
    ~ZipWriter();
    void add(const QString& name, const QByteArray& contents, Packing packing);
    // Of all contents, before they were packed.
    qint64 unpackedBytes() const { return unpackedBytes_; }
    // Throws Error unless all of it is in the bytes.
    QByteArray finish();

private:
    QBuffer buffer_;
    std::unique_ptr<QuaZip> zip_;
    int entries_ = 0;
    qint64 unpackedBytes_ = 0;
};

} // namespace dipwright
