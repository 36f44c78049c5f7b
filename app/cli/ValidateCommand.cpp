#include "cli/Arguments.h"

#include "pipeline/ValidateJob.h"
#include "validation/PhysicsValidation.h"

#include <QJsonDocument>

namespace dipwright::cli {
namespace {

const QString physicsOption = QStringLiteral("physics");
const QString jsonOption = QStringLiteral("json");
const QString solverOption = QStringLiteral("solver");
const QString cellsOption = QStringLiteral("cells");
const QString plotOption = QStringLiteral("plot");

// The resolutions up to the asked one.
std::vector<int> resolutions(const QCommandLineParser& parser) {
    const int finest =
        parser.isSet(cellsOption) ? wholeNumberOption(parser, cellsOption, 15, 120) : 60;
    std::vector<int> result;
    for (int cells = 15; cells <= finest; cells *= 2) {
        result.push_back(cells);
    }
    return result;
}

void validateThePhysics(const QCommandLineParser& parser, Console& console) {
    requireNoPositionalArgument(parser);
    const SolverRegistry registry;
    PhysicsOptions options;
    options.resolutions = resolutions(parser);
    const QString solver =
        parser.isSet(solverOption) ? parser.value(solverOption) : QStringLiteral("auto");
    const std::vector<PhysicsResult> results =
        validatePhysics(registry.module(solver), options, console.progress());
    if (parser.isSet(jsonOption)) {
        QJsonObject json = physicsJson(results);
        json["solver"] = registry.info(solver).id;
        console.out() << QJsonDocument(json).toJson();
    } else {
        console.out() << physicsTable(results);
    }
    if (parser.isSet(plotOption)) {
        const QString path = parser.value(plotOption);
        if (!physicsPlot(results, QSize(1400, 700)).save(path)) {
            throw Error(QStringLiteral("The plot cannot be written; name a writable .png file"),
                        path);
        }
    }
    for (const PhysicsResult& result : results) {
        if (!result.passed()) {
            throw Error(QStringLiteral("The film is farther from the closed form than allowed"),
                        result.body);
        }
    }
}

class ValidateCommand : public Command {
public:
    QString name() const override { return QStringLiteral("validate"); }
    QString summary() const override {
        return QStringLiteral("Tells whether a project can be run, and what to look at first; or, "
                              "with --physics, how far the film is from its closed forms.");
    }
    void declare(QCommandLineParser& parser) const override {
        declareProject(parser);
        parser.addOption(
            {physicsOption, QStringLiteral("Compares the film with its closed forms instead; takes "
                                           "no project.")});
        parser.addOption({jsonOption, QStringLiteral("With --physics: prints JSON.")});
        parser.addOption({solverOption, QStringLiteral("With --physics: the solver to judge."),
                          QStringLiteral("ID")});
        parser.addOption({cellsOption,
                          QStringLiteral("With --physics: the finest resolution, in grid cells in "
                                         "the contact radius (15, 30, 60 or 120; 60)."),
                          QStringLiteral("N")});
        parser.addOption({plotOption,
                          QStringLiteral("With --physics: draws simulated against exact film "
                                         "radius into a picture."),
                          QStringLiteral("FILE.png")});
    }
    void run(const QCommandLineParser& parser, Console& console) const override {
        if (parser.isSet(physicsOption)) {
            validateThePhysics(parser, console);
            return;
        }
        const Project project = projectArgument(parser);
        const SolverRegistry registry;
        for (const QString& warning : validateJob(project, registry)) {
            console.out() << "warning: " << warning << '\n';
        }
        console.out() << "The project can be run\n";
    }
};

} // namespace

std::unique_ptr<Command> validateCommand() {
    return std::make_unique<ValidateCommand>();
}

} // namespace dipwright::cli
