#include "workbench/document/RecentProjects.h"

#include "base/Sha256.h"
#include "disk/PlainFile.h"
#include "project/Samples.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

namespace dipwright {

namespace {

constexpr int mostRecent = 12;
constexpr QSize thumbnailSize(384, 240);
const QString settingsKey = QStringLiteral("recentProjects");

QString thumbnailPath(const QString& path) {
    const QString key = sha256Hex(path.toUtf8()).left(32);
    return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) +
           QStringLiteral("/thumbnails/") + key + QStringLiteral(".png");
}

} // namespace

QStringList recentProjects() {
    return QSettings().value(settingsKey).toStringList();
}

void addRecentProject(const QString& path) {
    QStringList paths = recentProjects();
    const QString absolute = QFileInfo(path).absoluteFilePath();
    paths.removeAll(absolute);
    paths.prepend(absolute);
    QSettings().setValue(settingsKey, QStringList(paths.mid(0, mostRecent)));
}

void forgetRecentProject(const QString& path) {
    QStringList paths = recentProjects();
    paths.removeAll(path);
    QSettings().setValue(settingsKey, paths);
    QFile::remove(thumbnailPath(path));
}

QImage projectThumbnail(const QString& path) {
    const QFileInfo file(path);
    QFile thumbnail(thumbnailPath(file.absoluteFilePath()));
    QImage kept;
    if (openToRead(thumbnail).isEmpty()) {
        kept.load(&thumbnail, "PNG");
    }
    if (!kept.isNull() || !sampleProjects().contains(file.canonicalFilePath())) {
        return kept;
    }
    return QImage(QStringLiteral(":/thumbnails/%1.png").arg(file.completeBaseName()));
}

void keepProjectThumbnail(const QString& path, const QImage& picture) {
    if (picture.isNull()) {
        return;
    }
    const QString file = thumbnailPath(QFileInfo(path).absoluteFilePath());
    QDir().mkpath(QFileInfo(file).absolutePath());
    thumbnailOf(picture).save(file);
}

QImage thumbnailOf(const QImage& picture) {
    const QImage scaled =
        picture.scaled(thumbnailSize, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    return scaled.copy((scaled.width() - thumbnailSize.width()) / 2,
                       (scaled.height() - thumbnailSize.height()) / 2, thumbnailSize.width(),
                       thumbnailSize.height());
}

} // namespace dipwright
