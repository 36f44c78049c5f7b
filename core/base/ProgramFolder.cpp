#include "base/ProgramFolder.h"

#include <QCoreApplication>

namespace dipwright {
namespace {

QString& namedFolder() {
    static QString folder;
    return folder;
}

} // namespace

QString programFolder() {
    return namedFolder().isEmpty() ? QCoreApplication::applicationDirPath() : namedFolder();
}

void setProgramFolder(const QString& folder) {
    namedFolder() = folder;
}

} // namespace dipwright
