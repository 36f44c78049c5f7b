#include "workbench/widgets/DroppedFiles.h"

#include <QMimeData>
#include <QUrl>

namespace dipwright {

QStringList droppedFiles(const QMimeData& data) {
    QStringList files;
    for (const QUrl& url : data.urls()) {
        if (url.isLocalFile()) {
            files << url.toLocalFile();
        }
    }
    return files;
}

} // namespace dipwright
