// The projects opened last, the newest first, each with a small picture of its view.
#pragma once

#include <QImage>
#include <QString>
#include <QStringList>

namespace dipwright {

QStringList recentProjects();
void addRecentProject(const QString& path);
void forgetRecentProject(const QString& path);
QImage projectThumbnail(const QString& path); // null: none kept
QImage thumbnailOf(const QImage& picture);    // its middle, small
void keepProjectThumbnail(const QString& path, const QImage& picture);

} // namespace dipwright
