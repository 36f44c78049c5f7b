// dipwright-solver: runs one solver module in its own process (core/solver/OutOfProcessSolver.h).
// Started by the programs, not by users.
#include "solver/SolverServer.h"
#include "solving/Pipes.h"

#include <QCoreApplication>

int main(int argc, char* argv[]) {
    const QCoreApplication application(argc, argv);
    if (argc != 3) {
        std::fputs("error: This program is started by Dipwright (command line)\n", stderr);
        return 2;
    }
    dipwright::leaveInterruptsToStarter();
    std::FILE* const answers = dipwright::answerPipe();
    const QStringList arguments = QCoreApplication::arguments();
    dipwright::serveSolver(arguments.at(1), arguments.at(2).toInt(), stdin, answers);
}
