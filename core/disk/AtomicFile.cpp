#include "disk/AtomicFile.h"

#include "base/Bytes.h"
#include "base/Error.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QFileInfo>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(AtomicFile)
};

constexpr int longestName = 255; // bytes, the limit for a file name on common systems
const QString newPrefix = QStringLiteral(".~new.");
const QString lockPrefix = QStringLiteral(".~lock.");

// Returns what a link points to, whether that exists or not.
QString linkTarget(const QString& path) {
    QFileInfo file(path);
    for (int links = 0; file.isSymLink() && links < 40; ++links) {
        file = QFileInfo(file.symLinkTarget());
    }
    return file.absoluteFilePath();
}

} // namespace

QString hiddenFilePath(const QString& path, Beside what) {
    const QFileInfo file(path);
    const QString prefix = what == Beside::Lock ? lockPrefix : newPrefix;
    QString name = prefix + file.fileName();
    if (name.toUtf8().size() > longestName) {
        const QByteArray hash =
            QCryptographicHash::hash(file.fileName().toUtf8(), QCryptographicHash::Sha1);
        name = prefix + QString::fromLatin1(hash.toHex());
    }
    return file.absolutePath() + QLatin1Char('/') + name;
}

bool isHiddenFile(const QString& path) {
    const QString name = QFileInfo(path).fileName();
    return name.startsWith(newPrefix) || name.startsWith(lockPrefix);
}

void removeAbandoned(const QString& temporary) {
    LockedFile file;
    if (QFileInfo::exists(temporary) && file.open(temporary) == LockedFile::Outcome::Opened) {
        file.remove();
    }
}

AtomicFile::AtomicFile(const QString& path)
    : target_(linkTarget(path)), beside_(hiddenFilePath(target_, Beside::NewContents)) {}

AtomicFile::~AtomicFile() {
    if (!file_.remove()) {
        note_->leave();
    }
}

QString AtomicFile::open() {
    const QFileInfo target(target_);
    if (target.isDir()) {
        return Text::tr("it is a folder");
    }
    if (target.isSymLink()) {
        return Text::tr("its symbolic links form a loop");
    }
    if (target.exists() && !target.isFile()) { // a pipe or a device, which other programs have open
        return Text::tr("it is not a regular file");
    }
    if (target.exists() && !target.isWritable()) {
        return Text::tr("it is write-protected");
    }
    note_ = std::make_unique<UnfinishedWrite>(beside_);
    switch (file_.open(beside_)) {
    case LockedFile::Outcome::HeldByAnother:
        return Text::tr("another program is writing it now; try again");
    case LockedFile::Outcome::Failed:
        return file_.errorString();
    case LockedFile::Outcome::Opened:
        break;
    }
    if (!device().resize(0)) { // removes what a crashed writer left
        return device().errorString();
    }
    if (target.exists()) {
        device().setPermissions(target.permissions());
    }
    return {};
}

QString AtomicFile::commit() {
    if (!syncToDisk(device())) {
        return Text::tr("the disk did not accept its data: %1").arg(device().errorString());
    }
    if (!file_.moveOver(target_)) {
        removeAbandoned(beside_);
        if (QFileInfo::exists(beside_)) {
            note_->leave();
        }
        return file_.errorString();
    }
    syncFolder(QFileInfo(target_).path());
    note_.reset();
    return {};
}

QString replaceFile(const QString& path, const QByteArray& bytes,
                    const std::function<void()>& beforeReplacing) {
    AtomicFile file(path);
    if (QString failure = file.open(); !failure.isEmpty()) {
        return failure;
    }
    if (!writeAll(file.device(), bytes)) {
        return file.device().errorString();
    }
    if (beforeReplacing) {
        beforeReplacing();
    }
    return file.commit();
}

namespace {

void throwIf(const QString& failure, const QString& path) {
    if (!failure.isEmpty()) {
        throw Error(Text::tr("The file cannot be written: %1").arg(failure), path);
    }
}

} // namespace

void writeAtomically(const QString& path, const std::function<void(QIODevice&)>& write) {
    throwIf(replaceFile(path, bytesOf(write)), path);
}

void checkWritable(const QString& path) {
    throwIf(AtomicFile(path).open(), path);
}

} // namespace dipwright
