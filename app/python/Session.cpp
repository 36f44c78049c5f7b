#include "python/Session.h"

#include "base/Error.h"
#include "base/ProgramFolder.h"
#include "base/ProgramName.h"
#include "base/ShippedFolders.h"
#include "disk/UnfinishedWrites.h"
#include "python/ModuleFile.h"

#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QLocale>
#include <QLoggingCategory>

namespace dipwright::python {
namespace {

// A wheel contains the programs beside the module. An installed tree and a build folder have them
// in their folder of programs.
QString folderOfPrograms() {
    const QDir package = QFileInfo(moduleFile()).dir();
    const QString own = package.filePath(QStringLiteral("bin"));
    return QFileInfo(own).isDir()
               ? own
               : QDir::cleanPath(package.filePath(QStringLiteral(DIPWRIGHT_PROGRAMS_FROM_MODULE)));
}

std::unique_ptr<QGuiApplication> newApplication() {
    static char name[] = "dipwright", option[] = "-platform", platform[] = "offscreen";
    static char* arguments[] = {name, option, platform, nullptr};
    static int count = 3;
    QLoggingCategory::setFilterRules(
        QStringLiteral("*.debug=false\n*.info=false\n*.warning=false"));
    useShippedFonts();
    useShippedQtPlugins();
    auto application = std::make_unique<QGuiApplication>(count, arguments);
    QLocale::setDefault(QLocale::c());
    nameProgram();
    return application;
}

struct Session {
    Session() {
        setProgramFolder(folderOfPrograms());
        if (QCoreApplication::instance() == nullptr) {
            application = newApplication();
        } else if (qobject_cast<QGuiApplication*>(QCoreApplication::instance()) == nullptr) {
            throw Error(QStringLiteral("The sheets need fonts, but this process has a "
                                       "QCoreApplication; make a QGuiApplication instead, or none"),
                        QStringLiteral("dipwright"));
        }
        recoverUnfinishedWrites();
        registry = std::make_unique<SolverRegistry>();
    }
    std::unique_ptr<QGuiApplication> application; // null if the process has its own
    std::unique_ptr<SolverRegistry> registry;
};

// A pointer, because the session must end before Python and not with the process.
std::unique_ptr<Session>& current() {
    static std::unique_ptr<Session> session;
    return session;
}

} // namespace

const SolverRegistry& session() {
    if (!current()) {
        current() = std::make_unique<Session>();
    }
    return *current()->registry;
}

void endSession() {
    current().reset();
}

} // namespace dipwright::python
