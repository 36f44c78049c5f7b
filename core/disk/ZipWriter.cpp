#include "disk/ZipWriter.h"

#include "base/Error.h"

#include <QCoreApplication>
#include <quazip.h>
#include <quazipfile.h>

#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Archive)
};

constexpr qint64 pieceBytes = qint64(1) << 20; // packed between two reports

// Returns false if the entry cannot be written.
bool writePieces(QuaZipFile& entry, const QByteArray& contents,
                 const std::function<void(qint64)>& packed) {
    for (qint64 begin = 0; begin < contents.size(); begin += pieceBytes) {
        const qint64 length = std::min(pieceBytes, contents.size() - begin);
        if (entry.write(contents.constData() + begin, length) != length) {
            return false;
        }
        if (packed) {
            packed(length);
        }
    }
    return true;
}

} // namespace

ZipWriter::ZipWriter() {
    buffer_.open(QIODevice::ReadWrite);
    zip_ = std::make_unique<QuaZip>(&buffer_);
    zip_->setAutoClose(false);
    zip_->setUtf8Enabled(true);
    zip_->setDataDescriptorWritingEnabled(false);
    zip_->open(QuaZip::mdCreate);
}

ZipWriter::~ZipWriter() = default;

void ZipWriter::add(const QString& name, const QByteArray& contents, Packing packing,
                    const std::function<void(qint64)>& packed) {
    QuaZipNewInfo info(name);
    info.dateTime = QDateTime(QDate(1980, 1, 1), QTime(0, 0));
    const bool stored = packing == Packing::Stored;
    QuaZipFile entry(zip_.get());
    const bool written = entry.open(QIODevice::WriteOnly, info, nullptr, 0, stored ? 0 : Z_DEFLATED,
                                    stored ? 0 : Z_DEFAULT_COMPRESSION) &&
                         writePieces(entry, contents, packed);
    entry.close();
    if (!written || entry.getZipError() != ZIP_OK) {
        throw Error(Text::tr("The file cannot be packed"), name);
    }
    ++entries_;
    unpackedBytes_ += contents.size();
}

QByteArray ZipWriter::finish() {
    zip_->close();
    const bool closed = zip_->getZipError() == ZIP_OK;
    // Read the archive back, so that no broken file replaces the one on disk. QuaZip brings its own
    // minizip. If the system's minizip was loaded first, nothing is written here and no error is
    // reported.
    if (!closed || !zip_->open(QuaZip::mdUnzip) || zip_->getEntriesCount() != entries_) {
        throw Error(Text::tr("The file cannot be packed"), {});
    }
    zip_->close();
    return buffer_.data();
}

} // namespace dipwright
