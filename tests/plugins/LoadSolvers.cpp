// Lists the solvers of one folder, one per line, in a separate process that may crash. With the
// second argument "shipped", the modules are loaded as if they came with the program. With a third
// argument, each available solver makes one step.

#include "solver/SolverRegistry.h"

#include <QCoreApplication>
#include <QStandardPaths>
#include <cstdio>
#include <string>

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("load_solvers"));
    QStandardPaths::setTestModeEnabled(true);
    const QStringList folders = QCoreApplication::arguments().mid(1, 1);
    const dipwright::SolverRegistry registry(
        folders, argc > 2 && argv[2] == std::string("shipped") ? folders : QStringList());
    const bool steps = argc > 3;
    for (const dipwright::SolverInfo& info : registry.solvers()) {
        std::printf("%s %s\n", qPrintable(info.id),
                    info.available ? "available" : qPrintable(info.reason));
        if (steps && info.available) {
            try {
                registry.module(info.id).create()->advance(1);
            } catch (const std::exception& failure) {
                std::printf("%s\n", failure.what());
            }
        }
    }
}
