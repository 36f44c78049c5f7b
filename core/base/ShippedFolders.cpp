#include "base/ShippedFolders.h"

#include <QCoreApplication>
#include <QDir>
#include <QStandardPaths>

namespace dipwright {
namespace {

QStringList fromProgram(const QStringList& paths) {
    const QDir program(QCoreApplication::applicationDirPath());
    QStringList folders;
    for (const QString& path : paths) {
        folders << QDir::cleanPath(program.filePath(path));
    }
    return folders;
}

} // namespace

QStringList shippedPluginFolders() {
    return fromProgram({QStringLiteral("plugins"), QStringLiteral(DIPWRIGHT_PLUGINS_FROM_PROGRAM)});
}

QString readerProgram() {
    // Beside the programs; those that are only there to build and test lie elsewhere in the build.
    return QStandardPaths::findExecutable(
        QStringLiteral("dipwright-reader"),
        fromProgram({QStringLiteral("."), QStringLiteral("../bin")}));
}

QStringList shippedSampleFolders() {
    return fromProgram(
        {QStringLiteral("../share/samples"), QStringLiteral(DIPWRIGHT_SAMPLES_FROM_PROGRAM)});
}

} // namespace dipwright
