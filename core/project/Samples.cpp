#include "project/Samples.h"

#include "base/ShippedFolders.h"

#include <QDir>

namespace dipwright {

QStringList sampleProjects() {
    QStringList paths;
    for (const QString& folder : shippedSampleFolders()) {
        for (const QFileInfo& file : QDir(folder).entryInfoList({QStringLiteral("*.dipw")})) {
            paths.append(file.canonicalFilePath());
        }
    }
    return paths;
}

} // namespace dipwright
