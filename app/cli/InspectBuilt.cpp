#include "cli/InspectBuilt.h"
#include "model/TexturedMesh.h"

#include "accuracy/correction/SheetCorrection.h"
#include "base/Png.h"
#include "cli/Arguments.h"
#include "cli/InspectPart.h"
#include "disk/AtomicFile.h"
#include "disk/FolderTransaction.h"
#include "inspection/BuiltPlaces.h"
#include "project/DipKeys.h"
#include "project/ProjectFile.h"
#include "project/ProjectStore.h"

namespace dipwright::cli {
namespace {

const QString acceptedOption = QStringLiteral("accepted-by");
const QString correctOption = QStringLiteral("correct");
const QString projectOption =
    QStringLiteral("project"); // declared by InspectPart.cpp, as is `pairsOption`
const QString pairsOption = QStringLiteral("pairs");
const QString placesOption = QStringLiteral("places"); // declared by InspectFit.cpp, as is the next
const QString updateOption = QStringLiteral("update-job");

QString number(double value, int decimals) {
    return QString::number(value, 'f', decimals);
}

QString pictureName(int dip) {
    return QStringLiteral("correction-%1.png").arg(dip);
}

// Sets the share of the repeating error that the next sheets correct; 0 turns the correction off.
void setCorrection(AsBuilt& built, const QCommandLineParser& parser) {
    if (parser.isSet(correctOption)) {
        const double strength = numberOption(parser, correctOption, 0, 1);
        built.corrects = strength > 0;
        built.strength = strength > 0 ? strength : built.strength;
    }
}

// Writes the picture of each dip's repeating error and returns the sentences about them.
QStringList writePictures(const Project& project, const QString& folder) {
    constexpr int height = 1400; // pixels
    const AsBuilt built = partsDippedAlike(project);
    QStringList sentences;
    FolderTransaction files(folder, {pictureName(1), pictureName(2)});
    for (int dip = 1; dip <= int(project.immersions.size()); ++dip) {
        const RepeatingError error(built, dip);
        if (!error.isNothing()) {
            sentences << repeatingSentence(error, dip);
            files.write(pictureName(dip),
                        pngBytes(correctionPicture(error, project.film.width, project.film.height,
                                                   built.strength, height),
                                 pictureName(dip)));
        }
    }
    files.commit();
    return sentences;
}

// Throws Error if a place belongs to a dip that the job does not have.
void requireDips(const std::vector<PrintedPlace>& places, const Project& project,
                 const QString& where) {
    for (const PrintedPlace& place : places) {
        if (place.dip >= int(project.immersions.size())) {
            throw Error(
                QStringLiteral("The table names a place of dip %1, but the job has only %2 dips")
                    .arg(place.dip + 1)
                    .arg(project.immersions.size()),
                where);
        }
    }
}

// Adds the part in the photos to the job's finished parts.
void addPart(Project& project, const QStringList& files, const QCommandLineParser& parser,
             const std::optional<Lens>& lens,
             const std::function<QString(const std::optional<QDateTime>&)>& dateOf,
             Console& console) {
    const Progress progress = console.progress();
    const std::vector<PartPhoto> photos = readPartPhotos(files, progress.part(0, 0.1));
    const QSize picture = photos.front().picture.size();
    const std::vector<PlacePair> pairs = partPairs(parser, photos);
    const SurfaceQuery surface(project.model->mesh);
    requireOnBody(pairs, surface, parser.value(pairsOption));
    const PartView camera =
        fitPartCamera(pairs, int(photos.size()), picture, parser.value(pairsOption), lens);
    const auto places =
        placesOnPart(photos, pairs, parser, lens, progress.part(0.1, 0.5), console.out());
    const QString table = parser.value(parser.isSet(placesOption) ? placesOption : projectOption);
    requireDips(places, project, table);
    requireOnBody(places, surface, table);
    const QSizeF sheet(project.film.width.value(), project.film.height.value());
    const auto films = dippedFilms(project, progress.part(0.5, 1));
    requireOnTargets(places, films, sheet, table);
    const std::vector<BuiltPlace> built =
        builtPlaces(onJobsSheet(places, parser), camera, picture, films, sheet,
                    int(project.asBuilt.parts.size()) + 1);
    QStringList hashes;
    for (const PartPhoto& photo : photos) {
        hashes << photo.sha256;
    }
    project.asBuilt = withBuiltPart(std::move(project.asBuilt), built,
                                    {dateOf(photos.front().taken), parser.value(acceptedOption),
                                     hashes.join(u' '), 0, dipKeys(project).join(u' ')},
                                    sheet, parser.value(projectOption));
}

} // namespace

void declareBuilt(CommandSyntax& syntax) {
    syntax.addOption(
        {acceptedOption,
         QStringLiteral("For `built`: the name of the person who accepts the part's measurements."),
         QStringLiteral("NAME")});
    syntax.addOption({correctOption,
                      QStringLiteral("For `built`: the share of the repeating error that the next "
                                     "sheets correct, from 0 (none) to 1 (all)."),
                      QStringLiteral("SHARE")});
}

void inspectBuilt(const QStringList& files, const QCommandLineParser& parser,
                  const std::optional<Lens>& lens,
                  const std::function<QString(const std::optional<QDateTime>&)>& dateOf,
                  Console& console) {
    const QString path = parser.value(projectOption);
    if (path.isEmpty()) {
        throw UsageError(QStringLiteral("Name the job of this part with --project JOB.dipw"),
                         QStringLiteral("--project"));
    }
    if (parser.value(acceptedOption).trimmed().isEmpty()) {
        throw UsageError(
            QStringLiteral("Name the person who accepts the part with --accepted-by NAME"),
            QStringLiteral("--accepted-by"));
    }
    dateOf({});                      // refuses a wrong date before the measurement
    std::optional<ProjectFile> file; // locks the job against other writers before it is read
    if (parser.isSet(updateOption)) {
        checkWritable(path); // fails now instead of after the measurement
        file.emplace(path);
    }
    Project project = loadProject(path);
    addPart(project, files, parser, lens, dateOf, console);
    setCorrection(project.asBuilt, parser);
    const QStringList sentences = writePictures(project, parser.value(QStringLiteral("out")));
    console.progress()(1, QStringLiteral("Done"));
    const BuiltPart& part = project.asBuilt.parts.back();
    console.out() << QStringLiteral("Part %1: root mean square error %2 mm on the sheet\n")
                         .arg(project.asBuilt.parts.size())
                         .arg(number(part.residual, 3));
    for (const QString& sentence : sentences) {
        console.out() << sentence << '\n';
    }
    if (file) {
        file->save(project);
        console.out() << QStringLiteral("Saved the part in %1; the next sheets %2\n")
                             .arg(path, project.asBuilt.corrects
                                            ? QStringLiteral("are corrected")
                                            : QStringLiteral("are not corrected"));
    }
}

} // namespace dipwright::cli
