#include "cli/Arguments.h"
#include "project/Project.h"

#include "dip/BodyPath.h"
#include "disk/AtomicFile.h"
#include "disk/SmallFile.h"
#include "pipeline/DipCache.h"
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
const QString pathsOption = QStringLiteral("paths");
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
        text += QStringLiteral(" at x %1 mm, z %2 mm")
                    .arg(plain(immersion.offset[0].value()), plain(immersion.offset[1].value()));
    }
    if (const QString path = pathText(immersion.path); !path.isEmpty()) {
        text += QStringLiteral(" ") + path;
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

// Returns the width of a column of the table, which is headed by the name that --weight and --limit
// take.
int columnWidth(Measure measure) {
    return std::max(9, int(measureKey(measure).size()));
}

// Prints one row for these poses, with a column for each measure.
void printRow(const QString& name, const RankedPoses& ranked, QTextStream& out) {
    out << QStringLiteral("%1  %2 %").arg(name, 7).arg(100 * ranked.objective, 7, 'f', 2);
    for (const Measure measure : allMeasures()) {
        out << "  "
            << measureText(measure, ranked.measures[measure]).rightJustified(columnWidth(measure));
    }
    out << "  " << posesText(ranked) << (ranked.limitsMissed > 0 ? "  misses a limit" : "")
        << (ranked.tankFaults.isEmpty() ? "" : "  exceeds a limit of the tank")
        << (ranked.isConfirmed ? "" : "  not confirmed")
        << (ranked.areOwn ? "  the project's poses" : "") << '\n';
}

void printRanking(const SearchResult& result, const SearchSettings& settings, QTextStream& out) {
    out << "   Rank  objective";
    for (const Measure measure : allMeasures()) {
        out << "  " << measureKey(measure).rightJustified(columnWidth(measure));
    }
    out << "  rotation about X, Y, Z\n";
    const std::size_t shown = std::min(result.ranking.size(), shownPoses);
    for (std::size_t rank = 0; rank < shown; ++rank) {
        printRow(QString::number(rank + 1), result.ranking[rank], out);
    }
    if (result.current) {
        printRow(QStringLiteral("now"), *result.current, out);
    }
    for (std::size_t rank = 0; rank < shown; ++rank) {
        const RankedPoses& poses = result.ranking[rank];
        if (!poses.tankFaults.isEmpty() && poses.verdicts.empty()) {
            out << QStringLiteral("Rank %1: %2\n")
                       .arg(rank + 1)
                       .arg(poses.tankFaults.join(QStringLiteral(". ")));
        }
        for (std::size_t dip = 0; dip < poses.verdicts.size(); ++dip) {
            out << QStringLiteral("Rank %1, %2\n")
                       .arg(rank + 1)
                       .arg(verdictText(poses.immersions[dip].name, poses.verdicts[dip]));
        }
        if (!poses.together.reasons.empty()) {
            out << QStringLiteral("Rank %1, %2\n")
                       .arg(rank + 1)
                       .arg(verdictText(QStringLiteral("all dips"), poses.together));
        }
    }
    const auto reasons = [&](const RankedPoses& one, const RankedPoses& other) {
        return reasonText(differences(one, other, settings, result.equator));
    };
    for (std::size_t rank = 1; rank < shown; ++rank) {
        out << QStringLiteral("Rank %1 compared with rank 1: %2\n")
                   .arg(rank + 1)
                   .arg(reasons(result.ranking[rank], result.ranking.front()));
    }
    if (result.current && !result.ranking.front().areOwn) {
        out << QStringLiteral("Rank 1 compared with the project's poses: %1\n")
                   .arg(reasons(result.ranking.front(), *result.current));
    }
    if (!result.isComplete) {
        out << "Stopped before the end: these are the best poses so far. The project was not "
               "changed\n";
    }
}

// Reads --weight or --limit. Each value is NAME=NUMBER; NAME=none removes a limit.
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
            throw UsageError(
                QStringLiteral("Write the option as NAME=NUMBER, for example coverage=0.9"), where);
        }
        try {
            set(aims, name, isNone ? std::nullopt : std::optional(number));
        } catch (const Error& error) {
            throw UsageError(error.sentence(), where);
        }
    }
}

// Returns the project's weights and limits, with the values of the options in their place.
SearchSettings settingsOf(const QCommandLineParser& parser, const Project& project) {
    if (!parser.isSet(immersionsOption)) {
        throw UsageError(QStringLiteral("Give the number of dips with --immersions 1 or 2"),
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
    settings.paths = parser.isSet(pathsOption);
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

// Reads "3/8": the number of this part of the poses, and the number of parts.
std::array<int, 2> shardOf(const QCommandLineParser& parser) {
    const QStringList parts = parser.value(shardOption).split(QLatin1Char('/'));
    bool isNumber = false, isCount = false;
    const int number = parts.value(0).toInt(&isNumber);
    const int count = parts.value(1).toInt(&isCount);
    if (parts.size() != 2 || !isNumber || !isCount || number < 1 || number > count ||
        count > mostParts) {
        throw UsageError(QStringLiteral("Write the option as NUMBER/COUNT, from 1/COUNT to "
                                        "COUNT/COUNT, with COUNT at most %1")
                             .arg(mostParts),
                         QStringLiteral("--shard"));
    }
    return {number, count};
}

class OptimizeCommand : public Command {
public:
    QString name() const override { return QStringLiteral("optimize"); }
    QString summary() const override {
        return QStringLiteral(
            "Searches for dip poses and replaces the project's dips by the best.");
    }

    void declare(CommandSyntax& syntax) const override {
        const SearchSettings usual;
        const auto count = [&](const QString& option, const QString& description, int value) {
            syntax.addOption({option, description, QStringLiteral("N"), QString::number(value)});
        };
        declareProject(syntax);
        syntax.addOption({immersionsOption, QStringLiteral("The number of dips, 1 or 2."),
                          QStringLiteral("1|2")});
        count(candidatesOption,
              QStringLiteral(
                  "The number of poses to simulate with a coarse film, 6 to 2000; default %1.")
                  .arg(usual.simulated),
              usual.simulated);
        count(directionsOption,
              QStringLiteral("The number of directions to rate first by the part's shape alone, 6 "
                             "to 20000; default %1.")
                  .arg(usual.directions),
              usual.directions);
        count(refinedOption,
              QStringLiteral("How many of the best poses to refine, 0 to 50; default %1.")
                  .arg(usual.refined),
              usual.refined);
        count(finerOption,
              QStringLiteral(
                  "How many of the best poses to rank with a finer film, 1 to 100; default %1.")
                  .arg(usual.finer),
              usual.finer);
        count(confirmedOption,
              QStringLiteral("How many of the best poses to simulate with the project's own film, "
                             "0 to 20; default %1.")
                  .arg(usual.confirmed),
              usual.confirmed);
        count(seedOption, QStringLiteral("The seed of the random directions, 0 to 1000000."),
              usual.seed);
        syntax.addOption(
            {pathsOption, QStringLiteral("Also tries paths for the best poses: tilted and "
                                         "slanted entries, and rolls if a depth is set.")});
        syntax.addOption({weightOption,
                          QStringLiteral("The weight of a measure, or of zone_a, zone_b or zone_c, "
                                         "instead of the project's weight. May be repeated."),
                          QStringLiteral("NAME=WEIGHT")});
        syntax.addOption(
            {limitOption,
             QStringLiteral("A limit, instead of the project's: the lowest value for quality, "
                            "coverage and certain (film without faults), the highest for "
                            "every other measure. Shares are 0 to 1, stretch is a ratio, join is "
                            "in mm. NAME=none removes the limit. May be repeated."),
             QStringLiteral("NAME=VALUE")});
        syntax.addOption(
            {shardOption,
             QStringLiteral("Simulates only part K of N of the poses and writes it to --out."),
             QStringLiteral("K/N")});
        syntax.addOption({outOption, QStringLiteral("The file for the part of --shard."),
                          QStringLiteral("FILE")});
        syntax.addOption({mergeOption,
                          QStringLiteral("Reads the poses that --shard simulated from this file. "
                                         "May be repeated, once for each part."),
                          QStringLiteral("FILE")});
        syntax.addOption({solverOption,
                          QStringLiteral("The solver plugin, instead of the project's choice."),
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
        const QString named = solverNamed(parser, registry);
        return chooseSolver(named.isEmpty() ? project.process.solver : named, registry,
                            console.progress().cancelToken);
    }

    static void makePart(const QCommandLineParser& parser, Console& console) {
        const Project project = projectArgument(parser);
        const SearchSettings settings = settingsOf(parser, project);
        const auto [number, count] = shardOf(parser);
        const QString out = parser.value(outOption);
        if (out.isEmpty() || parser.isSet(mergeOption)) {
            throw UsageError(
                QStringLiteral("Name the file for the part with --out, and leave out --merge"),
                QStringLiteral("--shard"));
        }
        checkWritable(out);
        requireReplaceable(out, isShardFile, QStringLiteral("a part of a search"));
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

    // Caches the dips beside the project, so that nothing has to simulate them again.
    static void keepDips(const Project& project, const RankedPoses& poses, const SolverInfo& solver,
                         const QString& path, Console& console) {
        try {
            if (const auto dips = foundDips(project, poses, solver)) {
                cacheDips(*dips, path);
            }
        } catch (const Error& error) {
            printWarnings({error.sentence()}, console.out());
        }
    }

    static void search(const QCommandLineParser& parser, Console& console) {
        if (parser.isSet(outOption)) {
            throw UsageError(QStringLiteral("--out works only with --shard"),
                             QStringLiteral("--out"));
        }
        const QString path = projectPath(parser);
        ProjectFile file(path); // locks the project against other writers before it is read
        // The values of --set apply only to the search: the poses are written into the project as
        // it was.
        Project stored = loadProject(path);
        Project project = stored;
        applySettings(project, parser);
        checkWritable(path); // fails now instead of after the search
        const SearchSettings settings = settingsOf(parser, project);
        std::vector<SearchShard> parts;
        for (const QString& name : parser.values(mergeOption)) {
            parts.push_back(shardFromFile(readSmallFile(name, mostPartBytes), name));
        }
        const SolverRegistry registry;
        SolverChoice solver = solverOf(parser, project, registry, console);
        const SolverInfo chosen = solver.solver;
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
        stored.immersions = result.ranking.front().immersions;
        file.save(stored);
        if (solver.solver.id == chosen.id) { // no other solver took over
            keepDips(project, result.ranking.front(), chosen, path, console);
        }
    }
};

} // namespace

std::unique_ptr<Command> optimizeCommand() {
    return std::make_unique<OptimizeCommand>();
}

} // namespace dipwright::cli
