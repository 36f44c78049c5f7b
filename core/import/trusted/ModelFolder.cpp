#include "import/trusted/ModelFolder.h"

#include "base/Budgets.h"
#include "disk/PlainFile.h"

#include <QFile>
#include <QFileInfo>
#include <QUrl>

namespace dipwright {

namespace {

// Returns the entry of `folder` with this name in upper or lower case; empty if there is none.
QString entryIgnoringCase(const QDir& folder, const QString& name) {
    for (const QString& entry : folder.entryList(QDir::AllEntries | QDir::NoDotAndDotDot)) {
        if (entry.compare(name, Qt::CaseInsensitive) == 0) {
            return entry;
        }
    }
    return QString();
}

// Some programs put names that contain spaces in quotes, above all in material files of OBJ.
QString withoutQuotes(const QString& name) {
    const bool isQuoted = name.size() > 2 && name.startsWith(u'"') && name.endsWith(u'"');
    return isQuoted ? name.mid(1, name.size() - 2) : name;
}

// Whether a path is on this computer. For a model the network is never accessed, not even to check
// whether a file exists.
bool isLocal(const QString& path) {
    return !path.isEmpty() && !path.startsWith(QStringLiteral("//")) && !path.contains(QChar(0));
}

} // namespace

ModelFolder::ModelFolder(const QString& modelFile, bool allowOutside,
                         const QStringList& allowedFiles)
    : modelFile_(modelFile), folder_(QFileInfo(modelFile).absoluteDir()),
      place_(folder_.canonicalPath()), allowOutside_(allowOutside), allowedFiles_(allowedFiles) {}

std::optional<QByteArray> ModelFolder::fetch(const QString& name) {
    const QString path = name == modelFile_ ? modelFile_ : find(name);
    return path.isEmpty() ? std::nullopt : readFile(path);
}

// Returns the path of an existing file that may be read, or an empty string.
QString ModelFolder::find(const QString& name) {
    QString slashed = withoutQuotes(QString(name).replace(u'\\', u'/').trimmed());
    if (slashed.startsWith(QStringLiteral("file:"), Qt::CaseInsensitive)) {
        slashed = QUrl(slashed).path();
    }
    const QString path = QDir::cleanPath(slashed);
    const QString decoded = QDir::cleanPath(QUrl::fromPercentEncoding(path.toUtf8()));
    QString elsewhere;
    for (const QString& candidate :
         {path, decoded, path.section(u'/', -1), decoded.section(u'/', -1)}) {
        const QString found = findRelative(candidate);
        if (!found.isEmpty() && isAllowed(found)) {
            return found;
        }
        elsewhere = elsewhere.isEmpty() ? found : elsewhere;
    }
    if (!elsewhere.isEmpty() && !outside_.contains(elsewhere)) {
        outside_.push_back(elsewhere);
    }
    return QString();
}

QString ModelFolder::findRelative(const QString& path) const {
    if (!isLocal(path)) {
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

bool ModelFolder::isAllowed(const QString& file) const {
    if (allowOutside_ || allowedFiles_.contains(file)) {
        return true;
    }
    const QString real = QFileInfo(file).canonicalFilePath();
    const QString within = QDir(place_).relativeFilePath(real);
    if (real.isEmpty() || QDir::isAbsolutePath(within)) { // missing, or on another drive
        return false;
    }
    const QStringList parts = within.split(u'/'); // a leading ".." begins with a dot, too
    return std::none_of(parts.begin(), parts.end(),
                        [](const QString& part) { return part.startsWith(u'.'); });
}

std::optional<QByteArray> readFile(const QString& path) {
    QFile file(path);
    if (!openToRead(file).isEmpty()) {
        return std::nullopt;
    }
    requireWithin(Budget::FileBytes, file.size(), path);
    QByteArray bytes = file.readAll();
    if (file.error() != QFileDevice::NoError) {
        return std::nullopt;
    }
    return bytes;
}

} // namespace dipwright
