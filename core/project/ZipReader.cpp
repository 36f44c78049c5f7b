#include "project/ZipReader.h"

#include "base/Budgets.h"
#include "base/Error.h"
#include "disk/PlainFile.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <quazip.h>
#include <quazipfile.h>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Archive)
};

constexpr quint16 encryptedFlag = 1;
constexpr quint64 largestSize = quint64(1) << 40; // above any real size; keeps sums from overflow

bool isSafeName(const QString& name) {
    if (name.isEmpty() || name.startsWith(QLatin1Char('/')) || name.contains(QLatin1Char('\\')) ||
        name.contains(QLatin1Char(':')) || name.contains(QChar(0))) {
        return false;
    }
    const QStringList parts = name.split(QLatin1Char('/'));
    return !parts.contains(QStringLiteral("..")) && !parts.contains(QStringLiteral("."));
}

} // namespace

ZipReader::ZipReader(const QString& path) : path_(path), file_(path) {
    const QFileInfo info(path);
    if (!info.exists()) {
        throw Error(Text::tr("The file does not exist"), path);
    }
    if (const QString failure = openToRead(file_); !failure.isEmpty()) {
        throw Error(Text::tr("The file cannot be read: %1").arg(failure), path);
    }
    if (file_.size() == 0) {
        throw Error(Text::tr("The file is empty"), path);
    }
    requireWithin(Budget::FileBytes, file_.size(), path);
    zip_ = std::make_unique<QuaZip>(&file_);
    if (!zip_->open(QuaZip::mdUnzip)) {
        throw Error(
            Text::tr("This is not a Dipwright project, or the file is truncated or damaged"), path);
    }
    checkDirectory();
}

ZipReader::~ZipReader() {
    if (zip_) {
        zip_->close();
    }
}

void ZipReader::checkDirectory() {
    requireWithin(Budget::Entries, zip_->getEntriesCount(), path_);
    const QList<QuaZipFileInfo64> entries = zip_->getFileInfoList64();
    if (entries.isEmpty() || entries.size() != zip_->getEntriesCount()) {
        throw Error(Text::tr("The file is truncated or damaged"), path_);
    }
    qint64 unpacked = 0;
    for (const QuaZipFileInfo64& entry : entries) {
        if (!isSafeName(entry.name)) {
            throw Error(
                Text::tr("The file contains an entry with an unsafe path and is not opened"),
                path_);
        }
        if (names_.contains(entry.name)) {
            throw Error(Text::tr("The file contains the entry %1 twice").arg(entry.name), path_);
        }
        if ((entry.flags & encryptedFlag) != 0) {
            throw Error(Text::tr("The file is encrypted; save it without a password"), path_);
        }
        unpacked += qint64(std::min(entry.uncompressedSize, largestSize));
        requireWithin(Budget::UnpackedBytes, unpacked, path_, file_.size());
        names_.insert(entry.name);
    }
}

QByteArray ZipReader::read(const QString& name) {
    QuaZipFileInfo64 info;
    if (!zip_->setCurrentFile(name, QuaZip::csSensitive) || !zip_->getCurrentFileInfo(&info)) {
        throw Error(Text::tr("The project does not contain %1").arg(name), path_);
    }
    QuaZipFile entry(zip_.get());
    QByteArray contents;
    if (entry.open(QIODevice::ReadOnly)) {
        // Reads no more bytes than the entry announces, even if its compressed data yields more.
        contents = entry.read(qint64(info.uncompressedSize));
        const bool complete = contents.size() == qint64(info.uncompressedSize) && entry.atEnd();
        entry.close();
        if (complete && entry.getZipError() == UNZ_OK) {
            return contents;
        }
    }
    throw Error(Text::tr("%1 in the project is truncated or damaged").arg(name), path_);
}

} // namespace dipwright
