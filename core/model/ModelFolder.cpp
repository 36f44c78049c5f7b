#include "model/ModelFolder.h"

#include <QFile>
#include <QFileInfo>
#include <QUrl>

namespace dipwright {

namespace {

// The entry of `folder` with this name, whatever its case; empty where there is none.
QString entryIgnoringCase(const QDir& folder, const QString& name) {
    for (const QString& entry : folder.entryList(QDir::AllEntries | QDir::NoDotAndDotDot)) {
        if (entry.compare(name, Qt::CaseInsensitive) == 0) {
            return entry;
        }
    }
    return QString();
}

} // namespace

ModelFolder::ModelFolder(const QString& modelFile) : folder_(QFileInfo(modelFile).absoluteDir()) {}

QString ModelFolder::find(const QString& name) const {
    const QString path = QDir::cleanPath(QString(name).replace(u'\\', u'/').trimmed());
    const QString decoded = QUrl::fromPercentEncoding(path.toUtf8());
    for (const QString& candidate : {path, decoded, path.section(u'/', -1)}) {
        if (QString found = findRelative(candidate); !found.isEmpty()) {
            return found;
        }
    }
    return QString();
}

QString ModelFolder::findRelative(const QString& path) const {
    if (path.isEmpty() || path.startsWith(QStringLiteral("//"))) { // another computer's share
        return QString();
    }
    if (const QFileInfo exact(folder_.filePath(path)); exact.isFile()) {
        return exact.absoluteFilePath();
    }
    if (QDir::isAbsolutePath(path)) {
        return QString();
    }
    QDir folder = folder_;
    QStringList parts = path.split(u'/', Qt::SkipEmptyParts);
    const QString last = parts.isEmpty() ? QString() : parts.takeLast();
    for (const QString& part : parts) {
        const bool isStep = part == QStringLiteral(".") || part == QStringLiteral("..");
        const QString entry = isStep ? part : entryIgnoringCase(folder, part);
        if (entry.isEmpty() || !folder.cd(entry)) {
            return QString();
        }
    }
    const QFileInfo file(folder.filePath(entryIgnoringCase(folder, last)));
    return file.isFile() ? file.absoluteFilePath() : QString();
}

std::optional<QByteArray> readFile(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return std::nullopt;
    }
    QByteArray bytes = file.readAll();
    if (file.error() != QFileDevice::NoError) {
        return std::nullopt;
    }
    return bytes;
}

} // namespace dipwright
