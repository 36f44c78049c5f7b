// Writes zip archives whose bytes depend only on their contents.
#pragma once

#include <QBuffer>
#include <QByteArray>
#include <QString>
#include <functional>
#include <memory>

class QuaZip;

namespace dipwright {

// A zip archive in memory. It has no time stamps, so that equal contents give equal bytes.
class ZipWriter {
public:
    enum class Packing { Stored, Deflated };

    ZipWriter();
    ~ZipWriter();
    // Calls `packed` after each megabyte or less, with the number of bytes since its last call.
    // What it throws ends the work; the archive cannot be finished then.
    void add(const QString& name, const QByteArray& contents, Packing packing,
             const std::function<void(qint64)>& packed = {});
    // Size of all contents before compression.
    qint64 unpackedBytes() const { return unpackedBytes_; }
    // Returns the archive. Throws Error if it is not complete.
    QByteArray finish();

private:
    QBuffer buffer_;
    std::unique_ptr<QuaZip> zip_;
    int entries_ = 0;
    qint64 unpackedBytes_ = 0;
};

} // namespace dipwright
