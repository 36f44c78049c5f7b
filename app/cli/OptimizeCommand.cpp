#include "cli/Arguments.h"
#include "project/Project.h"

#include "disk/AtomicFile.h"
#include "disk/SmallFile.h"
#include "pipeline/JobSearch.h"
#include "pipeline/SolverChoice.h"
#include "project/ProjectFile.h"
#include "project/ProjectStore.h"

namespace dipwright::cli {
namespace {

const QString immersionsOption = QStringLiteral("immersions");
const QString candidatesOption = QStringLiteral("candidates");
const QString directionsOption = QStringLiteral("directions");
const QString refinedOption = QStringLiteral("refined");
const QString finerOption = QStringLiteral("finer");
const QString confirmedOption = QStringLiteral("confirmed");
const QString seedOption = QStringLiteral("seed");
const QString weightOption = QStringLiteral("weight");
const QString limitOption = QStringLiteral("limit");
const QString shardOption = QStringLiteral("shard");
const QString outOption = QStringLiteral("out");
const QString mergeOption = QStringLiteral("merge");
const QString solverOption = QStringLiteral("solver");
constexpr std::size_t shownPoses = 5;
constexpr int mostParts = 1000;
constexpr qint64 mostPartBytes = 2'000'000'000;

QString plain(double number) {
    return QString::number(number, 'g', 6);
}

QString poseText(const Immersion& immersion) {
    QString text =
        QStringLiteral("(%1°, %2°, %3°)")
            .arg(plain(immersion.rotation[0].value()), plain(immersion.rotation[1].value()),
                 plain(immersion.rotation[2].value()));
    if (immersion.offset != std::array<Millimetres, 2>{}) {
        text += QStringLiteral(" at %1, %2 mm")
                    .arg(plain(immersion.offset[0].value()), plain(immersion.offset[1].value()));
    }
    return text;
}

QString posesText(const RankedPoses& ranked) {
    QStringList poses;
    for (const Immersion& immersion : ranked.immersions) {
        poses.append(poseText(immersion));
    }
    return poses.join(QStringLiteral(" and "));
}

// A measure a column: painted is what a user calls coverage.
void printRow(const QString& name, const RankedPoses& ranked, QTextStream& out) {
    out << QStringLiteral("%1  %2").arg(name, 7).arg(100 * ranked.objective, 9, 'f', 2);
    for (const Measure measure : allMeasures()) {
        out << QStringLiteral("  %1").arg(measureText(measure, ranked.measures[measure]), 9);
    }
    out << "  " << posesText(ranked) << (ranked.limitsMissed > 0 ? "  misses a limit" : "")
        << (ranked.isConfirmed ? "" : "  coarse") << '\n';
}

void printRanking(const SearchResult& result, const SearchSettings& settings, QTextStream& out) {
    out << "   Rank  objective    quality    painted    stretch    certain   wrinkled       torn"
           "        air       join     narrow  film used  turned about X, Y, Z\n";
    const std::size_t shown = std::min(result.ranking.size(), shownPoses);
    for (std::size_t rank = 0; rank < shown; ++rank) {
        printRow(QString::number(rank + 1), result.ranking[rank], out);
    }
    if (result.current) {
        printRow(QStringLiteral("now"), *result.current, out);
    }
    const auto reasons = [&](const RankedPoses& one, const RankedPoses& other) {
        return reasonText(differences(one, other, settings, result.equator));
    };
    for (std::size_t rank = 1; rank < shown; ++rank) {
        out << QStringLiteral("%1 against 1: %2\n")
                   .arg(rank + 1)
                   .arg(reasons(result.ranking[rank], result.ranking.front()));
    }
    if (result.current) {
        out << QStringLiteral("1 against now: %1\n")
                   .arg(reasons(result.ranking.front(), *result.current));
    }
    if (!result.isComplete) {
        out << "Stopped before the end: the best so far; the project is as it was\n";
    }
}

// --weight and --limit: NAME=NUMBER each, and NAME=none for no limit.
template <typename Set>
void applyPairs(const QCommandLineParser& parser, const QString& option, PoseAims& aims,
                const Set& set) {
    const QString where = QStringLiteral("--%1").arg(option);
    for (const QString& text : parser.values(option)) {
        const auto equals = text.indexOf(QLatin1Char('='));
        const QString name = text.left(equals), value = text.mid(equals + 1);
        bool isNumber = false;
        const double number = value.toDouble(&isNumber);
        const bool isNone = option == limitOption && value == QLatin1String("none");
        if (equals < 1 || !(isNumber || isNone)) {
            throw UsageError(QStringLiteral("Give it as NAME=NUMBER, as in coverage=0.9"), where);
        }
        try {
            set(aims, name, isNone ? std::nullopt : std::optional(number));
        } catch (const Error& error) {
            throw UsageError(error.sentence(), where);
        }
    }
}

// Weights and limits are the project's, but for what the options say.
SearchSettings settingsOf(const QCommandLineParser& parser, const Project& project) {
    if (!parser.isSet(immersionsOption)) {
        throw UsageError(QStringLiteral("Say how many dips to plan with --immersions 1 or 2"),
                         QStringLiteral("--immersions"));
    }
    SearchSettings settings;
    settings.immersions = wholeNumberOption(parser, immersionsOption, 1, 2);
    settings.simulated =
        wholeNumberOption(parser, candidatesOption, simulatedRange.least, simulatedRange.most);
    settings.directions =
        wholeNumberOption(parser, directionsOption, directionsRange.least, directionsRange.most);
    settings.refined =
        wholeNumberOption(parser, refinedOption, refinedRange.least, refinedRange.most);
    settings.finer = wholeNumberOption(parser, finerOption, finerRange.least, finerRange.most);
    settings.confirmed =
        wholeNumberOption(parser, confirmedOption, confirmedRange.least, confirmedRange.most);
    settings.seed = wholeNumberOption(parser, seedOption, seedRange.least, seedRange.most);
    settings.aims = project.poseAims;
    applyPairs(parser, weightOption, settings.aims,
               [](PoseAims& aims, const QString& name, std::optional<double> weight) {
                   setWeight(aims, name, *weight);
               });
    applyPairs(parser, limitOption, settings.aims, setLimit);
    try {
        requireValid(settings);
    } catch (const Error& error) {
        throw UsageError(error.sentence(), QStringLiteral("--weight"));
    }
    return settings;
}

// "3/8": the number of the part and how many there are.
std::array<int, 2> shardOf(const QCommandLineParser& parser) {
    const QStringList parts = parser.value(shardOption).split(QLatin1Char('/'));
    bool isNumber = false, isCount = false;
    const int number = parts.value(0).toInt(&isNumber);
    const int count = parts.value(1).toInt(&isCount);
    if (parts.size() != 2 || !isNumber || !isCount || number < 1 || number > count ||
        count > mostParts) {
        throw UsageError(QStringLiteral("Give it as NUMBER/COUNT, from 1/COUNT to COUNT/COUNT, "
                                        "and no more than %1 of them")
                             .arg(mostParts),
                         QStringLiteral("--shard"));
    }
    return {number, count};
}

class OptimizeCommand : public Command {
public:
    QString name() const override { return QStringLiteral("optimize"); }
    QString summary() const override {
        return QStringLiteral("Searches dip poses and writes the best into the project.");
    }

    void declare(CommandSyntax& syntax) const override {
        const SearchSettings usual;
        const auto count = [&](const QString& option, const QString& description, int value) {
            syntax.addOption({option, description, QStringLiteral("N"), QString::number(value)});
        };
        declareProject(syntax);
        syntax.addOption(
            {immersionsOption, QStringLiteral("Dips to plan, 1 or 2."), QStringLiteral("1|2")});
        count(candidatesOption,
              QStringLiteral("Poses to try on a coarse film, 6 to 2000; %1 without it.")
                  .arg(usual.simulated),
              usual.simulated);
        count(directionsOption,
              QStringLiteral("Directions to judge by the body's shape first, 6 to 20000; %1 "
                             "without it.")
                  .arg(usual.directions),
              usual.directions);
        count(refinedOption,
              QStringLiteral("Of the best, how many to refine, 0 to 50; %1 without it.")
                  .arg(usual.refined),
              usual.refined);
        count(finerOption,
              QStringLiteral("Of the best, how many to rank by a finer film, 1 to 100; %1 without "
                             "it.")
                  .arg(usual.finer),
              usual.finer);
        count(confirmedOption,
              QStringLiteral("Of the best, how many to dip with the project's own film, 0 to 20; "
                             "%1 without it.")
                  .arg(usual.confirmed),
              usual.confirmed);
        count(seedOption, QStringLiteral("Other directions with every number, 0 to 1000000."),
              usual.seed);
        syntax.addOption(
            {weightOption,
             QStringLiteral("How much a measure, or zone_a, zone_b, zone_c, counts, in "
                            "place of what the project says; repeatable."),
             QStringLiteral("NAME=WEIGHT")});
        syntax.addOption(
            {limitOption,
             QStringLiteral("The least or the most that is wanted of a measure, or none, "
                            "in place of what the project says; repeatable."),
             QStringLiteral("NAME=VALUE")});
        syntax.addOption({shardOption,
                          QStringLiteral("Dips only part K of N of the poses, into --out."),
                          QStringLiteral("K/N")});
        syntax.addOption({outOption, QStringLiteral("The file for the part of --shard."),
                          QStringLiteral("FILE")});
        syntax.addOption({mergeOption,
                          QStringLiteral("Takes the poses dipped by --shard from this file; "
                                         "repeatable, once a part."),
                          QStringLiteral("FILE")});
        syntax.addOption({solverOption,
                          QStringLiteral("The solver plugin, in place of the project's choice."),
                          QStringLiteral("ID")});
        declareThreads(syntax);
    }

    void run(const QCommandLineParser& parser, Console& console) const override {
        const ThreadLimit threads = threadLimit(parser);
        parser.isSet(shardOption) ? makePart(parser, console) : search(parser, console);
    }

private:
    static SolverChoice solverOf(const QCommandLineParser& parser, const Project& project,
                                 const SolverRegistry& registry, Console& console) {
        return chooseSolver(parser.isSet(solverOption) ? parser.value(solverOption)
                                                       : project.process.solver,
                            registry, console.progress().cancelToken);
    }

    static void makePart(const QCommandLineParser& parser, Console& console) {
        const Project project = projectArgument(parser);
        const SearchSettings settings = settingsOf(parser, project);
        const auto [number, count] = shardOf(parser);
        const QString out = parser.value(outOption);
        if (out.isEmpty() || parser.isSet(mergeOption)) {
            throw UsageError(QStringLiteral("Name the file for the part with --out, without "
                                            "--merge"),
                             QStringLiteral("--shard"));
        }
        checkWritable(out);
        const SolverRegistry registry;
        SolverChoice solver = solverOf(parser, project, registry, console);
        const SearchShard part =
            withFallback(solver, registry, [&](const dipwright::solver::SolverModule& module) {
                return searchShard(searchSubject(project, solver.solver.id), settings, module,
                                   number, count, console.progress());
            });
        printWarnings(solver.notes, console.out());
        writeAtomically(out, [&](QIODevice& device) { device.write(shardFile(part)); });
    }

    static void search(const QCommandLineParser& parser, Console& console) {
        if (parser.isSet(outOption)) {
            throw UsageError(QStringLiteral("It goes with --shard only"), QStringLiteral("--out"));
        }
        const QString path = projectPath(parser);
        ProjectFile file(path); // before it is read: nobody else writes it meanwhile
        const Project project = projectArgument(parser);
        checkWritable(path); // better now than after the work
        const SearchSettings settings = settingsOf(parser, project);
        std::vector<SearchShard> parts;
        for (const QString& name : parser.values(mergeOption)) {
            parts.push_back(shardFromFile(readSmallFile(name, mostPartBytes), name));
        }
        const SolverRegistry registry;
        SolverChoice solver = solverOf(parser, project, registry, console);
        const SearchResult result =
            withFallback(solver, registry, [&](const dipwright::solver::SolverModule& module) {
                return searchPoses(searchSubject(project, solver.solver.id), settings, module,
                                   parts, {}, console.progress());
            });
        printWarnings(solver.notes, console.out());
        printRanking(result, settings, console.out());
        if (!result.isComplete) {
            throw Cancelled();
        }
        // Into the file as it is: what --set changed was for the search alone.
        Project stored = loadProject(path);
        stored.immersions = result.ranking.front().immersions;
        file.save(stored);
    }
};

} // namespace

std::unique_ptr<Command> optimizeCommand() {
    return std::make_unique<OptimizeCommand>();
}

} // namespace dipwright::cli
