#include "base/ProgramFolder.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace dipwright {
namespace {

QString& namedFolder() {
    static QString folder;
    return folder;
}

} // namespace

QString programFolder() {
    if (!namedFolder().isEmpty()) {
        return namedFolder();
    }
    // Qt knows the program's path only after the application object exists.
    return QCoreApplication::instance() != nullptr
               ? QCoreApplication::applicationDirPath()
               : QFileInfo(QStringLiteral("/proc/self/exe")).canonicalPath();
}

void setProgramFolder(const QString& folder) {
    namedFolder() = folder;
}

} // namespace dipwright
