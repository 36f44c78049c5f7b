#include "project/Samples.h"

#include <QCoreApplication>
#include <QDir>

namespace dipwright {

QStringList sampleProjects() {
    QStringList paths;
    for (const char* place : {"/../share/samples", "/../share/dipwright/samples"}) {
        const QDir folder(QCoreApplication::applicationDirPath() + QLatin1String(place));
        for (const QFileInfo& file : folder.entryInfoList({QStringLiteral("*.dipw")})) {
            paths.append(file.canonicalFilePath());
        }
    }
    return paths;
}

} // namespace dipwright
