#include "pipeline/ResultFolder.h"

#include "base/Bytes.h"
#include "base/Error.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(ResultFolder)
};

// Set aside inside the temporary folder, so that what is replaced can be put back.
const QString asideName = QStringLiteral("replaced");

// Renamings that can be taken back.
class Renames {
public:
    bool add(const QString& from, const QString& to) {
        if (!QDir().rename(from, to)) {
            return false;
        }
        done_.append({from, to});
        return true;
    }
    void undo() {
        for (; !done_.isEmpty(); done_.removeLast()) {
            QDir().rename(done_.last().second, done_.last().first);
        }
    }

private:
    QList<std::pair<QString, QString>> done_;
};

QString nearestFolder(QString path) {
    while (!QFileInfo::exists(path)) {
        const QString parent = QFileInfo(path).absolutePath();
        if (parent == path) {
            break;
        }
        path = parent;
    }
    return path;
}

} // namespace

ResultFolder::ResultFolder(const QString& target)
    : target_(QDir::cleanPath(QDir().absoluteFilePath(target))) {
    const QString home = nearestFolder(target_);
    if (!QFileInfo(home).isDir()) {
        throw Error(Text::tr("The results cannot be written, %1 is not a folder").arg(home),
                    target_);
    }
    // In the same file system as the target: moving is then a renaming, and takes no space.
    temporary_ = std::make_unique<QTemporaryDir>(home + QStringLiteral("/.dipwright-XXXXXX"));
    if (!temporary_->isValid()) {
        throw Error(Text::tr("The folder cannot be written: %1").arg(temporary_->errorString()),
                    target_);
    }
}

ResultFolder::~ResultFolder() = default;

QString ResultFolder::path() const {
    return temporary_->path();
}

void ResultFolder::write(const QString& name, const QByteArray& contents) const {
    QFile file(temporary_->filePath(name));
    if (!QDir().mkpath(QFileInfo(file).path()) || !file.open(QIODevice::WriteOnly) ||
        !writeAll(file, contents)) {
        throw Error(Text::tr("The results cannot be written: %1").arg(file.errorString()), target_);
    }
}

// Nothing that stands in the way of a file, or of its folder, is the results' to remove.
void ResultFolder::refuseOthers(const QString& name) const {
    const QFileInfo file(target_ + QLatin1Char('/') + name);
    const QFileInfo folder(file.path());
    if (file.isDir() || (folder.exists() && !folder.isDir())) {
        throw Error(Text::tr("%1 is in the way of the results; move it, or choose another folder")
                        .arg(file.isDir() ? file.fileName() : folder.fileName()),
                    target_);
    }
}

void ResultFolder::commit(const QStringList& names) {
    const QDir target(target_);
    const QDir source(temporary_->path());
    const auto folderOf = [](const QString& name) { return QFileInfo(name).path(); };
    for (const QString& name : names) {
        refuseOthers(name);
    }
    Renames renames;
    bool good = QDir().mkpath(target_);
    for (const QString& name : names) {
        const QString aside = asideName + QLatin1Char('/') + name;
        if (good && target.exists(name)) {
            good = source.mkpath(folderOf(aside)) &&
                   renames.add(target.filePath(name), source.filePath(aside));
        }
        if (good && source.exists(name)) {
            good = target.mkpath(folderOf(name)) &&
                   renames.add(source.filePath(name), target.filePath(name));
        }
    }
    if (!good) {
        renames.undo();
    }
    for (const QString& name : names) {
        if (folderOf(name) != QLatin1String(".")) {
            target.rmdir(folderOf(name)); // where nothing is left in it
        }
    }
    if (!good) {
        throw Error(
            Text::tr("The results cannot be moved into the folder, is a file there in use?"),
            target_);
    }
}

} // namespace dipwright
