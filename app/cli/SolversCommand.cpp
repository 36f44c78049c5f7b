#include "cli/Arguments.h"

#include "solver/SolverRegistry.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace dipwright::cli {
namespace {

const QString jsonOption = QStringLiteral("json");

QJsonArray solversJson(const std::vector<SolverInfo>& solvers) {
    QJsonArray array;
    for (const SolverInfo& solver : solvers) {
        array.append(QJsonObject{{"id", solver.id},
                                 {"name", solver.name},
                                 {"version", solver.version},
                                 {"device", solver.device},
                                 {"vendor", solver.vendor},
                                 {"available", solver.available},
                                 {"reason", solver.reason}});
    }
    return array;
}

void printSolvers(const std::vector<SolverInfo>& solvers, QTextStream& out) {
    if (solvers.empty()) {
        out << "No solver plugins were found in\n";
        for (const QString& folder : SolverRegistry::standardFolders()) {
            out << "  " << folder << '\n';
        }
    }
    for (const SolverInfo& solver : solvers) {
        out << QStringLiteral("%1  %2 %3, %4: %5\n")
                   .arg(solver.id, -12)
                   .arg(solver.name, solver.version, solver.device,
                        solver.available ? QStringLiteral("available") : solver.reason);
    }
}

class SolversCommand : public Command {
public:
    QString name() const override { return QStringLiteral("solvers"); }
    QString summary() const override {
        return QStringLiteral("Lists the solver plugins and why one cannot be used.");
    }
    bool needsFiles() const override { return false; }
    void declare(CommandSyntax& syntax) const override {
        syntax.addOption({jsonOption, QStringLiteral("Prints JSON.")});
    }
    void run(const QCommandLineParser& parser, Console& console) const override {
        requireNoPositionalArgument(parser);
        const SolverRegistry registry;
        const std::vector<SolverInfo> solvers = registry.solvers(console.progress().cancelToken);
        if (parser.isSet(jsonOption)) {
            console.out() << QJsonDocument(solversJson(solvers)).toJson();
        } else {
            printSolvers(solvers, console.out());
        }
    }
};

} // namespace

std::unique_ptr<Command> solversCommand() {
    return std::make_unique<SolversCommand>();
}

} // namespace dipwright::cli
