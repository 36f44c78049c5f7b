#include "base/ShippedFolders.h"

#include "base/ProgramFolder.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QStandardPaths>

namespace dipwright {
namespace {

QStringList fromProgram(const QStringList& paths) {
    const QDir program(programFolder());
    QStringList folders;
    for (const QString& path : paths) {
        folders << QDir::cleanPath(program.filePath(path));
    }
    return folders;
}

// Only the tarball has this folder (cmake/BundledLibraries.cmake).
QString fromTarball(const QString& path) {
    return fromProgram({QStringLiteral("../lib/dipwright/system/") + path}).front();
}

} // namespace

QStringList shippedPluginFolders() {
    // The tests find the plugins in the second folder.
    return fromProgram({QStringLiteral("plugins"), QStringLiteral("../bin/plugins"),
                        QStringLiteral(DIPWRIGHT_PLUGINS_FROM_PROGRAM)});
}

QString shippedProgram(const QString& name) {
    // In a build the helpers lie beside the programs. Helpers that are used only to build and test
    // lie elsewhere.
    return QStandardPaths::findExecutable(
        name, fromProgram({QStringLiteral("."), QStringLiteral("../bin"),
                           QStringLiteral(DIPWRIGHT_HELPERS_FROM_PROGRAM)}));
}

QString readerProgram() {
    return shippedProgram(QStringLiteral("dipwright-reader"));
}

void useShippedFonts() {
    const QString shipped = fromTarball(QStringLiteral("fonts/fonts.conf"));
    if (!QFile::exists(QStringLiteral("/etc/fonts/fonts.conf")) && QFile::exists(shipped)) {
        qputenv("FONTCONFIG_FILE", QFile::encodeName(shipped));
    }
}

QString cadReaderProgram() {
    return shippedProgram(QStringLiteral("dipwright-cad-reader"));
}

void useShippedQtPlugins() {
    if (const QString shipped = fromTarball(QStringLiteral("plugins")); QFile::exists(shipped)) {
        QCoreApplication::setLibraryPaths({shipped});
    }
}

QStringList shippedSampleFolders() {
    return fromProgram(
        {QStringLiteral("../share/samples"), QStringLiteral(DIPWRIGHT_SAMPLES_FROM_PROGRAM)});
}

} // namespace dipwright
