// The list of recent projects, newest first, each with a thumbnail of its part.
#pragma once

#include <QImage>
#include <QString>
#include <QStringList>

namespace dipwright {

QStringList recentProjects();
void addRecentProject(const QString& path);
void forgetRecentProject(const QString& path);
QImage projectThumbnail(const QString& path); // null: there is none
QImage thumbnailOf(const QImage& picture);    // scaled and cropped to the centre
void keepProjectThumbnail(const QString& path, const QImage& picture);

} // namespace dipwright
