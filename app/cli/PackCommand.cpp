#include "cli/Arguments.h"
#include "cli/PrintOptions.h"

#include "pipeline/DipCache.h"
#include "pipeline/JobPacking.h"
#include "pipeline/Pipeline.h"
#include "printing/PrintReach.h"
#include "project/FilmSizes.h"

#include <QFileInfo>
#include <QRegularExpression>

namespace dipwright::cli {
namespace {

const QString outOption = QStringLiteral("out");
const QString filmOption = QStringLiteral("film");
const QString spacingOption = QStringLiteral("spacing");
const QString marginOption = QStringLiteral("margin");
const QString feedOption = QStringLiteral("feed");
const QString turnOption = QStringLiteral("turn");
const QString dpiOption = QStringLiteral("dpi");
const QString solverOption = QStringLiteral("solver");
// mm, longest side of a film; also used for a roll of unknown length.
constexpr double mostLength = 3000;

struct PackedProject {
    QString path;
    int copies = 1;
};

// Reads "JOB.dipw:3", a project and its number of copies. If a file with the whole name exists, it
// is the project.
PackedProject packedProject(const QString& word) {
    static const QRegularExpression counted(QStringLiteral("^(.+):(\\d{1,9})$"));
    const QRegularExpressionMatch match = counted.match(word);
    if (!match.hasMatch() || QFileInfo::exists(word)) {
        return {word};
    }
    const int copies = match.captured(2).toInt();
    if (copies < 1 || copies > mostPieces) {
        throw UsageError(
            QStringLiteral("Give 1 to %1 copies, for example JOB.dipw:3").arg(mostPieces), word);
    }
    return {match.captured(1), copies};
}

// Reads the film: the name of a size, WIDTHxHEIGHT, roll:WIDTH or roll:WIDTHxLENGTH.
void setFilm(PackingFilm& film, const QString& text) {
    static const QRegularExpression sizes(
        QStringLiteral("^(roll:)?(\\d+(?:\\.\\d+)?)(?:x(\\d+(?:\\.\\d+)?))?$"));
    const QRegularExpressionMatch match = sizes.match(text);
    film.isRoll = !match.captured(1).isEmpty();
    if (filmSizeNames().contains(text)) {
        film.size = filmSize(text);
        return;
    }
    const bool hasLength = !match.captured(3).isEmpty();
    film.size = {match.captured(2).toDouble(),
                 hasLength ? match.captured(3).toDouble() : mostLength};
    constexpr double least = 50;
    if (!match.hasMatch() || !(hasLength || film.isRoll) ||
        std::min(film.size.width(), film.size.height()) < least ||
        std::max(film.size.width(), film.size.height()) > mostLength) {
        throw UsageError(QStringLiteral("Write the film as %1, WIDTHxHEIGHT, roll:WIDTH or "
                                        "roll:WIDTHxLENGTH in mm, %2 to %3")
                             .arg(filmSizeNames().join(QStringLiteral(", ")))
                             .arg(least)
                             .arg(mostLength),
                         QStringLiteral("--film"));
    }
}

PackSettings packSettings(const QCommandLineParser& parser) {
    PackSettings settings;
    if (parser.isSet(filmOption)) {
        setFilm(settings.film, parser.value(filmOption));
    }
    if (parser.isSet(spacingOption)) {
        settings.film.spacing = Millimetres(numberOption(parser, spacingOption, 0, 200));
    }
    if (parser.isSet(marginOption)) {
        settings.film.margin =
            Millimetres(numberOption(parser, marginOption, leastPieceMargin, 200));
    }
    const QString feed = parser.value(feedOption);
    if (!feed.isEmpty() && feed != QLatin1String("short") && feed != QLatin1String("long")) {
        throw UsageError(
            QStringLiteral("Give the edge that enters the printer first, short or long"),
            QStringLiteral("--feed"));
    }
    settings.feed = feed == QLatin1String("long") ? FeedDirection::LongEdgeFirst
                                                  : FeedDirection::ShortEdgeFirst;
    settings.mayTurn = parser.isSet(turnOption);
    return settings;
}

class PackCommand : public Command {
public:
    QString name() const override { return QStringLiteral("pack"); }
    QString summary() const override {
        return QStringLiteral(
            "Packs the sheets of several projects, and copies of them, on one film.");
    }

    void declare(CommandSyntax& syntax) const override {
        declareProjects(syntax);
        const auto value = [&](const QString& name, const char* words, const char* kind) {
            syntax.addOption({name, QString::fromUtf8(words), QString::fromLatin1(kind)});
        };
        value(outOption,
              "The folder for the packed films as PDF, PNG and TIFF. Earlier films are replaced.",
              "DIR");
        value(filmOption,
              "The film: the name of a size, WIDTHxHEIGHT, or a roll as roll:WIDTH or "
              "roll:WIDTHxLENGTH, in mm. A roll is cut off after the last piece. Default: A4.",
              "SIZE");
        value(spacingOption, "The distance between two pieces in mm, 0 to 200; default 3.", "MM");
        value(marginOption, "The bare film around the ink in mm, 7 to 200; default 7.", "MM");
        value(feedOption, "The edge of the film that enters the printer first.", "short|long");
        syntax.addOption({turnOption, QStringLiteral("Turns pieces by 90° to save film, if their "
                                                     "film swells equally in both directions.")});
        value(dpiOption, "The resolution of all sheets, instead of the projects' own.", "N");
        value(solverOption, "The solver plugin, instead of the projects' choice.", "ID");
        declarePrinter(syntax);
        declareThreads(syntax);
    }

    void run(const QCommandLineParser& parser, Console& console) const override {
        if (listsPrinters(parser)) {
            requireNoPositionalArgument(parser);
            listPrinters(console.out());
            return;
        }
        const QString folder = parser.value(outOption);
        const PrintTarget target = folder.isEmpty() ? printTarget(parser) : PrintTarget{};
        std::vector<PackedProject> projects;
        for (const QString& word : projectPaths(parser)) {
            projects.push_back(packedProject(word));
        }
        PackSettings settings = packSettings(parser);
        if (!folder.isEmpty()) {
            checkFilmsFolder(folder);
        }
        const ThreadLimit threads = threadLimit(parser);
        const Progress progress = console.progress();
        const std::vector<JobResult> results = dipped(projects, parser, progress.part(0, 0.9));
        const Project& first = results.front().project;
        PrintRequest request = printRequest(parser, target, first.profiles.printer);
        request.source = printSource(first, projects.front().path);
        settings.film.edges = larger(settings.film.edges, unreachable({}, request.profile));
        std::vector<PieceToPack> pieces;
        for (std::size_t i = 0; i < results.size(); ++i) {
            for (PieceToPack& piece : piecesOf(results[i], projects[i].copies, settings)) {
                pieces.push_back(std::move(piece));
            }
        }
        const PackedFilms films = packedFilms(std::move(pieces), settings);
        for (const QString& line : filmsText(films)) {
            console.out() << line << '\n';
        }
        if (!folder.isEmpty()) {
            writeFilms(films, folder, progress.part(0.9, 1));
            console.out() << QStringLiteral("Wrote %1\n").arg(folder);
        } else {
            print(films, target, request, progress.part(0.9, 1), console.out());
        }
    }

private:
    static std::vector<JobResult> dipped(const std::vector<PackedProject>& projects,
                                         const QCommandLineParser& parser,
                                         const Progress& progress) {
        const SolverRegistry registry;
        JobOptions options;
        options.solver = parser.value(solverOption);
        options.estimatesNumericalError = false;
        std::vector<JobResult> results;
        for (std::size_t i = 0; i < projects.size(); ++i) {
            Project project = readProject(projects[i].path, parser);
            if (parser.isSet(dpiOption)) {
                setByOption(project, QStringLiteral("sheet.dpi"), parser.value(dpiOption),
                            QStringLiteral("--dpi"));
            }
            const auto count = double(projects.size());
            const Progress part = progress.part(double(i) / count, double(i + 1) / count);
            const auto kept = usableDips(project, registry, projects[i].path, part.silent());
            results.push_back(runJob(project, registry, options, kept.get(), part));
        }
        return results;
    }

    static void print(const PackedFilms& films, const PrintTarget& target,
                      const PrintRequest& request, const Progress& progress, QTextStream& out) {
        std::vector<Sheet> sheets;
        for (std::size_t number = 0; number < films.plan.films.size(); ++number) {
            sheets.push_back(sheetOf(films, number));
        }
        if (!target.printer.isEmpty()) {
            const std::unique_ptr<PrintSystem> system = printSystem();
            const std::vector<PrintPlan> plans = planPrints(*system, sheets, request);
            for (const PrintPlan& plan : plans) {
                printWarnings(plan.warnings, out);
            }
            printAndReport(*system, plans, progress, out);
            return;
        }
        PrintFileRequest file;
        file.profile = request.profile;
        file.source = request.source;
        for (std::size_t number = 0; number < sheets.size(); ++number) {
            const QString path =
                sheets.size() == 1 ? target.file : numbered(target.file, number + 1);
            printWarnings(writePrintFile(sheets[number], file, path, PrintHistory()), out);
            out << QStringLiteral("Wrote %1\n").arg(path);
        }
    }
    // Returns "films-2.pdf" for "films.pdf".
    static QString numbered(const QString& path, std::size_t number) {
        const qsizetype dot = path.lastIndexOf(u'.');
        return QStringLiteral("%1-%2%3").arg(path.left(dot)).arg(number).arg(path.mid(dot));
    }
};

} // namespace

std::unique_ptr<Command> packCommand() {
    return std::make_unique<PackCommand>();
}

} // namespace dipwright::cli
