// The workbench: dipwright [FILE.dipw …]
#include "base/ProgramName.h"
#include "base/ShippedFolders.h"
#include "disk/UnfinishedWrites.h"
#include "workbench/document/Recovery.h"
#include "workbench/main/MainWindow.h"
#include "workbench/main/Workbench.h"
#include "workbench/widgets/Languages.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>
#include <QTimer>

int main(int argc, char* argv[]) {
    QApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    dipwright::useShippedFonts();
    QApplication application(argc, argv);
    dipwright::nameProgram();
    QApplication::setApplicationDisplayName(QStringLiteral("Dipwright"));
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/dipwright.svg")));
    QApplication::setDesktopFileName(QStringLiteral("dipwright"));

    dipwright::installLanguage(application, dipwright::loadPreferences().language);

    QCommandLineParser parser;
    parser.setApplicationDescription(
        QApplication::translate("main", "Computational hydrographic printing."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("FILE"),
                                 QApplication::translate("main", "Projects to open."),
                                 QStringLiteral("[FILE.dipw …]"));
    parser.process(application);
    dipwright::recoverUnfinishedWrites();

    dipwright::Workbench workbench(dipwright::recoveryFolder());
    dipwright::MainWindow* window = workbench.openWindow();
    for (const QString& path : parser.positionalArguments()) {
        window->documents().openProject(path);
    }
    QTimer::singleShot(0, &workbench, &dipwright::Workbench::offerRecovery);
    return QApplication::exec();
}
