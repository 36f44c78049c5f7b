// Lists the solvers of one folder, a line each: a program of its own, so that it may go down.

#include "solver/SolverRegistry.h"

#include <QCoreApplication>
#include <QStandardPaths>
#include <cstdio>

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("load_solvers"));
    QStandardPaths::setTestModeEnabled(true);
    const dipwright::SolverRegistry registry({QCoreApplication::arguments().value(1)});
    for (const dipwright::SolverInfo& info : registry.solvers()) {
        std::printf("%s %s\n", qPrintable(info.id),
                    info.available ? "available" : qPrintable(info.reason));
    }
}
