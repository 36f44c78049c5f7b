#include "base/ProgramName.h"

#include <QCoreApplication>
#include <QStandardPaths>

namespace dipwright {
namespace {

const QString name = QStringLiteral("dipwright");

} // namespace

void nameProgram() {
    QCoreApplication::setApplicationName(name);
    QCoreApplication::setOrganizationName(QStringLiteral("Dipwright"));
    QCoreApplication::setApplicationVersion(programVersion());
}

QString programVersion() {
    return QStringLiteral(DIPWRIGHT_VERSION);
}

QString earlierDataFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
           QLatin1Char('/') + name;
}

} // namespace dipwright
