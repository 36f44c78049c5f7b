#include "cli/Arguments.h"
#include "cli/PackOptions.h"

#include "cost/CostText.h"
#include "disk/AtomicFile.h"
#include "pipeline/DipCache.h"
#include "pipeline/JobCost.h"
#include "pipeline/Pipeline.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace dipwright::cli {
namespace {

const QString partsOption = QStringLiteral("parts");
const QString csvOption = QStringLiteral("csv");
const QString jsonOption = QStringLiteral("json");
const QString solverOption = QStringLiteral("solver");

void printRows(const std::vector<CostRow>& rows, QTextStream& out) {
    for (const CostRow& row : rows) {
        out << QStringLiteral("  %1 %2 %3").arg(row.what, -28).arg(row.amount, -16).arg(row.cost)
            << '\n';
    }
}

void printCost(const OrderCost& cost, QTextStream& out) {
    out << costSentence(cost) << '\n';
    printRows(costRows(cost), out);
    printRows(timeRows(cost), out);
    if (cost.areInksEstimated) {
        out << QStringLiteral("The inks are estimated, because the project has no printer profile "
                              "with an ICC profile in CMYK\n");
    }
}

class CostCommand : public Command {
public:
    QString name() const override { return QStringLiteral("cost"); }
    QString summary() const override {
        return QStringLiteral("Computes cost and time of one part and of an order.");
    }

    void declare(CommandSyntax& syntax) const override {
        declareProjects(syntax,
                        QStringLiteral("Several projects are processed one after the other."));
        syntax.addOption({partsOption,
                          QStringLiteral("The number of good parts of the order, instead of the "
                                         "project's (order.parts)."),
                          QStringLiteral("N")});
        syntax.addOption({csvOption, QStringLiteral("Also writes a table of all items and times."),
                          QStringLiteral("FILE")});
        syntax.addOption({jsonOption, QStringLiteral("Prints JSON.")});
        syntax.addOption({solverOption,
                          QStringLiteral("The solver plugin, instead of the projects' choice."),
                          QStringLiteral("ID")});
        declarePacking(syntax, QStringLiteral("The sheets of all parts are packed on it. Without "
                                              "this option, each sheet is a film of its own."));
        declareThreads(syntax);
    }

    void run(const QCommandLineParser& parser, Console& console) const override {
        const QStringList paths = projectPaths(parser);
        refusePackingWithoutFilm(parser);
        if (parser.isSet(csvOption)) {
            // Fails now instead of after the dips.
            checkWritable(parser.value(csvOption));
            const auto isTable = [](const QByteArray& begin) {
                return begin.startsWith(costCsv({}).trimmed());
            };
            requireReplaceable(parser.value(csvOption), isTable,
                               QStringLiteral("a table of costs"));
        }
        const ThreadLimit threads = threadLimit(parser);
        const Progress progress = console.progress();
        const auto count = double(paths.size());
        std::vector<ProjectCost> projects;
        for (qsizetype i = 0; i < paths.size(); ++i) {
            projects.push_back(
                costOfProject(paths[i], parser,
                              progress.part(double(i) / count, double(i + 1) / count), console));
        }
        progress(1, QStringLiteral("Done"));
        if (parser.isSet(csvOption)) {
            const QByteArray csv = costCsv(projects);
            writeAtomically(parser.value(csvOption), [&](QIODevice& file) { file.write(csv); });
        }
        print(projects, parser.isSet(jsonOption), console.out());
    }

private:
    static ProjectCost costOfProject(const QString& path, const QCommandLineParser& parser,
                                     const Progress& progress, Console& console) {
        Project project = readProject(path, parser);
        if (parser.isSet(partsOption)) {
            setByOption(project, QStringLiteral("order.parts"), parser.value(partsOption),
                        QStringLiteral("--parts"));
        }
        const SolverRegistry registry;
        JobOptions options;
        options.solver = solverNamed(parser, registry);
        options.estimatesNumericalError = false;
        const auto kept =
            usableDips(project, registry, path, progress.silent(), console.warnings());
        const JobResult result = runJob(project, registry, options, kept.get(), progress);
        if (!packs(parser)) {
            return {project.name, jobCosts(result, project)};
        }
        const PackSettings settings = packSettings(parser);
        const WorkCosts work = project.profiles.tank ? project.profiles.tank->costs : WorkCosts();
        const int racks = racksOf(project.partsToMake, work);
        const std::optional<FilmProfile>& priced = project.profiles.film;
        const FilmAmount film =
            filmOf(packedFilms(piecesOf(result, racks, settings), settings),
                   priced ? QSizeF(priced->width.value(), priced->height.value()) : QSizeF());
        return {project.name, {jobCost(result, project.profiles, project.partsToMake, film)}};
    }

    static void print(const std::vector<ProjectCost>& projects, bool asJson, QTextStream& out) {
        QJsonArray list;
        for (const ProjectCost& project : projects) {
            QJsonArray orders;
            if (!asJson && projects.size() > 1) {
                out << QStringLiteral("%1\n").arg(project.project);
            }
            for (const OrderCost& order : project.orders) {
                orders.append(costJson(order));
                if (!asJson) {
                    printCost(order, out);
                }
            }
            list.append(QJsonObject{{"project", project.project}, {"costs", orders}});
        }
        if (asJson) {
            out << QJsonDocument(QJsonObject{{"version", 1}, {"projects", list}}).toJson();
        }
    }
};

} // namespace

std::unique_ptr<Command> costCommand() {
    return std::make_unique<CostCommand>();
}

} // namespace dipwright::cli
