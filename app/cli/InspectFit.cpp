#include "cli/InspectFit.h"

#include "cli/InspectPart.h"

#include "disk/AtomicFile.h"
#include "pipeline/SolverChoice.h"
#include "project/ProjectFile.h"
#include "project/ProjectStore.h"

namespace dipwright::cli {
namespace {

const QString placesOption = QStringLiteral("places");
const QString fitOption = QStringLiteral("fit");
const QString updateOption = QStringLiteral("update-job");
const QString projectOption =
    QStringLiteral("project"); // these three are declared by InspectPart.cpp
const QString keepOption = QStringLiteral("keep-camera");
const QString pairsOption = QStringLiteral("pairs");

FitRequest fitRequest(const QCommandLineParser& parser, const std::optional<Lens>& lens) {
    FitRequest request{{}, parser.isSet(keepOption), lens};
    for (const QString& key : parser.value(fitOption).split(u',', Qt::SkipEmptyParts)) {
        try {
            request.quantities.push_back(fitQuantityOf(key.trimmed()));
        } catch (const Error& error) {
            throw UsageError(error.message(), QStringLiteral("--fit"));
        }
    }
    return request;
}

FitPairs pairsOf(const std::vector<PartPhoto>& photos, const QCommandLineParser& parser,
                 const std::optional<Lens>& lens, const Progress& progress, QTextStream& out) {
    FitPairs pairs;
    pairs.photos = int(photos.size());
    pairs.picture = photos.front().picture.size();
    pairs.body = partPairs(parser, photos);
    pairs.where = parser.value(pairsOption);
    pairs.printed =
        onJobsSheet(placesOnPart(photos, pairs.body, parser, lens, progress, out), parser);
    return pairs;
}

} // namespace

void declareFit(CommandSyntax& syntax) {
    syntax.addOption(
        {placesOption,
         QStringLiteral(
             "For `fit` and `built`: a table of the places where the print is seen, like the "
             "part-places.csv of `part`. Without it the corners of the print are searched for."),
         QStringLiteral("FILE.csv")});
    syntax.addOption(
        {fitOption,
         QStringLiteral("For `fit`: the quantities to find, joined by commas: shift_x, shift_z, "
                        "turn, swell_x, swell_y, relaxation, growth, contact_distance, depth. "
                        "Default: those of the first six quantities that the photos "
                        "determine."),
         QStringLiteral("LIST")});
    syntax.addOption(
        {updateOption, QStringLiteral("For `fit`: writes placement and depth into the job. For "
                                      "`built`: writes the part into the job.")});
}

FittedPart fitPart(const QStringList& files, const QCommandLineParser& parser,
                   const std::optional<Lens>& lens, Console& console) {
    const QString path = parser.value(projectOption);
    if (path.isEmpty()) {
        throw UsageError(QStringLiteral("Name the job of this part with --project JOB.dipw"),
                         QStringLiteral("--project"));
    }
    const FitRequest request = fitRequest(parser, lens);
    FittedPart part;
    if (parser.isSet(updateOption)) {
        checkWritable(path); // fails now instead of after the fit
        part.job = std::make_unique<ProjectFile>(path);
    }
    part.project = loadProject(path);
    if (part.job) {
        requireUncorrected(part.project, path);
    }
    const Project& project = part.project;
    const Progress progress = console.progress();
    std::vector<PartPhoto> photos = readPartPhotos(files, progress.part(0, 0.1));
    part.pairs = pairsOf(photos, parser, lens, progress.part(0.1, 0.3), console.out());
    part.taken = photos.front().taken;
    for (const PartPhoto& photo : photos) {
        part.photos.push_back({photo.where, photo.sha256});
    }
    photos.clear();
    const SolverRegistry registry;
    SolverChoice solver = chooseSolver(project.process.solver, registry, progress.cancelToken);
    const auto field =
        cachedDistanceField(project.model->mesh, project.fieldResolution, progress.part(0.3, 0.35));
    part.fit = withFallback(solver, registry, [&](const dipwright::solver::SolverModule& module) {
        return fitFilm(project, *field, part.pairs, request, module, progress.part(0.35, 1));
    });
    return part;
}

void updateJob(const FittedPart& part, const QCommandLineParser& parser, Console& console) {
    if (!part.job) {
        return;
    }
    const QString path = parser.value(projectOption);
    part.job->save(withPlacement(loadProject(path), part.fit));
    console.out() << QStringLiteral("Saved placement and depth in %1\n").arg(path);
}

} // namespace dipwright::cli
