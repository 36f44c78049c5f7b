#include "cli/Arguments.h"
#include "cli/PackOptions.h"
#include "cli/PrintOptions.h"
#include "cli/VerdictOutput.h"

#include "pipeline/DipCache.h"
#include "pipeline/JobPacking.h"
#include "pipeline/Pipeline.h"
#include "printing/PrintReach.h"

#include <QFileInfo>
#include <QRegularExpression>

namespace dipwright::cli {
namespace {

const QString outOption = QStringLiteral("out");
const QString dpiOption = QStringLiteral("dpi");
const QString solverOption = QStringLiteral("solver");

struct PackedProject {
    QString path;
    int copies = 1;
};

// Reads "JOB.dipw:3", a project and its number of copies. If a file with the whole name exists, it
// is the project.
PackedProject packedProject(const QString& word) {
    static const QRegularExpression counted(QStringLiteral("^(.+):([^:]*)$"));
    const QRegularExpressionMatch match = counted.match(word);
    bool isNumber = false;
    const int copies = match.captured(2).toInt(&isNumber);
    const bool isCounted = isNumber || QFileInfo::exists(match.captured(1));
    if (!match.hasMatch() || !isCounted || QFileInfo::exists(word)) {
        return {word};
    }
    if (copies < 1 || copies > mostPieces) {
        throw UsageError(
            QStringLiteral("Give 1 to %1 copies, for example JOB.dipw:3").arg(mostPieces), word);
    }
    return {match.captured(1), copies};
}

class PackCommand : public Command {
public:
    QString name() const override { return QStringLiteral("pack"); }
    QString summary() const override {
        return QStringLiteral(
            "Packs the sheets of several projects, and copies of them, on one film.");
    }

    void declare(CommandSyntax& syntax) const override {
        declareProjects(syntax,
                        QStringLiteral("Several projects share the films. JOB.dipw:3 packs three "
                                       "copies of a project."));
        const auto value = [&](const QString& name, const char* words, const char* kind) {
            syntax.addOption({name, QString::fromUtf8(words), QString::fromLatin1(kind)});
        };
        value(outOption,
              "The folder for the packed films as PDF, PNG and TIFF. Earlier films are replaced.",
              "DIR");
        declarePacking(syntax, QStringLiteral("Default: A4."));
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
        if (!folder.isEmpty()) {
            refuseTarget(parser, QStringLiteral("with --out, which prints nothing"));
        }
        const PrintTarget target = folder.isEmpty() ? printTarget(parser) : PrintTarget{};
        std::vector<PackedProject> projects;
        for (const QString& word : projectPaths(parser)) {
            projects.push_back(packedProject(word));
        }
        PackSettings settings = packSettings(parser);
        if (!folder.isEmpty()) {
            checkFilmsFolder(folder);
        } else if (!target.file.isEmpty()) {
            for (int film = 1; film <= mostFilms; ++film) {
                requireReplaceableSheet(numbered(target.file, std::size_t(film)));
            }
        }
        if (!target.printer.isEmpty() && settings.film.isRoll) {
            keepToLongestPage(settings.film, target.printer);
        }
        const ThreadLimit threads = threadLimit(parser);
        const Progress progress = console.progress();
        const std::vector<ProjectToPack> read = readProjects(projects, parser);
        const std::vector<JobResult> results =
            dipped(read, projects, parser, progress.part(0, 0.9), console);
        for (const JobResult& result : results) {
            console.out() << result.project.name << QStringLiteral(": ");
            printVerdict(result, console.out());
            for (const QString& note : result.notes) {
                console.out() << QStringLiteral("  %1\n").arg(note);
            }
        }
        const Project& first = results.front().project;
        PrintRequest request = printRequest(parser, target, first);
        request.source = printSource(first, projects.front().path);
        settings.film =
            withinReach(settings.film, marginsOf(target.printer, settings.film), request.profile);
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
        printWarnings(filmsWarnings(films), console.out());
        if (!folder.isEmpty()) {
            QStringList lost = lostInFiles(films);
            if (!lost.isEmpty()) {
                lost << QStringLiteral("Films in a folder are in sRGB; --to FILE writes them with "
                                       "the inks of a profile");
            }
            printWarnings(lost, console.out());
            writeFilms(films, folder, progress.part(0.9, 1));
            console.out() << wrote(folder);
        } else {
            print(films, target, request, progress.part(0.9, 1), console.out());
        }
    }

private:
    static void keepToLongestPage(PackingFilm& roll, const QString& name) {
        const std::optional<PrinterInfo> printer = printSystem()->printer(name);
        const std::optional<QSizeF> page =
            printer ? rollSize(*printer, std::nullopt) : std::nullopt;
        if (page) {
            roll.size.setHeight(std::min(roll.size.height(), page->height()));
        }
    }

    // Returns the margins of the printer, if one is named.
    static QMarginsF marginsOf(const QString& printer, const PackingFilm& film) {
        return printer.isEmpty() ? QMarginsF() : printerMargins(*printSystem(), printer, film);
    }

    // Throws Error if the projects cannot share a film.
    static std::vector<ProjectToPack> readProjects(const std::vector<PackedProject>& projects,
                                                   const QCommandLineParser& parser) {
        std::vector<ProjectToPack> read;
        for (const PackedProject& project : projects) {
            read.push_back({readProject(project.path, parser), project.copies});
            useProfile(parser, read.back().project);
            if (parser.isSet(dpiOption)) {
                setByOption(read.back().project, QStringLiteral("sheet.dpi"),
                            parser.value(dpiOption), QStringLiteral("--dpi"));
            }
        }
        checkProjects(read);
        return read;
    }

    static std::vector<JobResult> dipped(const std::vector<ProjectToPack>& read,
                                         const std::vector<PackedProject>& projects,
                                         const QCommandLineParser& parser, const Progress& progress,
                                         Console& console) {
        const SolverRegistry registry;
        JobOptions options;
        options.solver = solverNamed(parser, registry);
        std::vector<JobResult> results;
        for (std::size_t i = 0; i < projects.size(); ++i) {
            const Project& project = read[i].project;
            const auto count = double(projects.size());
            const Progress part = progress.part(double(i) / count, double(i + 1) / count);
            const auto kept =
                usableDips(project, registry, projects[i].path, part.silent(), console.warnings());
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
            out << wrote(path);
        }
        for (std::size_t number = sheets.size() == 1 ? 1 : sheets.size() + 1;
             QFileInfo::exists(numbered(target.file, number)); ++number) {
            printWarnings({QStringLiteral("%1 is from an earlier call and not a film of this one")
                               .arg(numbered(target.file, number))},
                          out);
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
