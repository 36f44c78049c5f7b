#include "cli/Arguments.h"

#include "disk/WholeFile.h"
#include "pipeline/PoseSearch.h"
#include "pipeline/SolverChoice.h"
#include "project/ProjectFile.h"
#include "project/ProjectStore.h"

namespace dipwright::cli {
namespace {

const QString immersionsOption = QStringLiteral("immersions");
const QString candidatesOption = QStringLiteral("candidates");
const QString solverOption = QStringLiteral("solver");
constexpr int shownPoses = 5;

QString plain(double number) {
    return QString::number(number, 'g', 6);
}

QString poseText(const Immersion& immersion) {
    return QStringLiteral("(%1°, %2°, %3°)")
        .arg(plain(immersion.rotation[0].value()), plain(immersion.rotation[1].value()),
             plain(immersion.rotation[2].value()));
}

void printRanking(const std::vector<RankedPoses>& ranking, QTextStream& out) {
    out << "Rank  painted  quality  turned about X, Y, Z\n";
    for (std::size_t rank = 0; rank < ranking.size() && rank < shownPoses; ++rank) {
        QStringList poses;
        for (const Immersion& immersion : ranking[rank].immersions) {
            poses.append(poseText(immersion));
        }
        out << QStringLiteral("%1  %2 %  %3 %  %4\n")
                   .arg(rank + 1, 4)
                   .arg(100 * ranking[rank].coverage, 5, 'f', 1)
                   .arg(100 * ranking[rank].quality, 5, 'f', 1)
                   .arg(poses.join(QStringLiteral(" and ")));
    }
}

class OptimizeCommand : public Command {
public:
    QString name() const override { return QStringLiteral("optimize"); }
    QString summary() const override {
        return QStringLiteral("Searches dip poses and writes the best into the project.");
    }

    void declare(CommandSyntax& syntax) const override {
        declareProject(syntax);
        syntax.addOption(
            {immersionsOption, QStringLiteral("Dips to plan, 1 or 2."), QStringLiteral("1|2")});
        syntax.addOption(
            {candidatesOption,
             QStringLiteral("Poses to try on a coarse film, 6 to 2000; 48 without it."),
             QStringLiteral("N"), QString::number(PoseSearchOptions().candidates)});
        syntax.addOption({solverOption,
                          QStringLiteral("The solver plugin, in place of the project's choice."),
                          QStringLiteral("ID")});
        declareThreads(syntax);
    }

    void run(const QCommandLineParser& parser, Console& console) const override {
        const ThreadLimit threads = threadLimit(parser);
        if (!parser.isSet(immersionsOption)) {
            throw UsageError(QStringLiteral("Say how many dips to plan with --immersions 1 or 2"),
                             QStringLiteral("--immersions"));
        }
        PoseSearchOptions options;
        options.immersions = wholeNumberOption(parser, immersionsOption, 1, 2);
        options.candidates = wholeNumberOption(parser, candidatesOption, 6, 2000);
        const QString path = positionalArgument(parser, QStringLiteral("JOB.dipw"));
        ProjectFile file(path);
        const Project project = projectArgument(parser);
        checkWritable(path); // better now than after the work
        const SolverRegistry registry;
        SolverChoice solver = chooseSolver(parser.isSet(solverOption) ? parser.value(solverOption)
                                                                      : project.process.solver,
                                           registry);
        const std::vector<RankedPoses> ranking =
            withFallback(solver, registry, [&](const dipwright::solver::SolverModule& module) {
                return searchPoses(project, module, options, console.progress());
            });
        printWarnings(solver.notes, console.out());
        printRanking(ranking, console.out());
        // Into the file as it is: what --set changed was for the search alone.
        Project stored = loadProject(path);
        stored.immersions = ranking.front().immersions;
        file.save(stored);
    }
};

} // namespace

std::unique_ptr<Command> optimizeCommand() {
    return std::make_unique<OptimizeCommand>();
}

} // namespace dipwright::cli
