#include "cli/InspectBuilt.h"
#include "model/TexturedMesh.h"

#include "accuracy/correction/SheetCorrection.h"
#include "base/Png.h"
#include "cli/Arguments.h"
#include "cli/InspectPart.h"
#include "disk/AtomicFile.h"
#include "disk/FolderTransaction.h"
#include "inspection/BuiltPlaces.h"
#include "project/ProjectFile.h"
#include "project/ProjectStore.h"

namespace dipwright::cli {
namespace {

const QString acceptedOption = QStringLiteral("accepted-by");
const QString correctOption = QStringLiteral("correct");
const QString projectOption = QStringLiteral("project"); // of “part”, as is this
const QString pairsOption = QStringLiteral("pairs");
const QString updateOption = QStringLiteral("update-job"); // of “fit”

QString number(double value, int decimals) {
    return QString::number(value, 'f', decimals);
}

QString pictureName(int dip) {
    return QStringLiteral("correction-%1.png").arg(dip);
}

// Sets whether the next sheets are corrected, and by how much of what repeats.
void setCorrection(AsBuilt& built, const QCommandLineParser& parser) {
    if (parser.isSet(correctOption)) {
        const double strength = numberOption(parser, correctOption, 0, 1);
        built.corrects = strength > 0;
        built.strength = strength > 0 ? strength : built.strength;
    }
}

void writePictures(const Project& project, const QString& folder) {
    constexpr int height = 1400; // pixels
    FolderTransaction files(folder, {pictureName(1), pictureName(2)});
    for (int dip = 1; dip <= int(project.immersions.size()); ++dip) {
        const RepeatingError error(project.asBuilt, dip);
        if (!error.isNothing()) {
            files.write(pictureName(dip),
                        pngBytes(correctionPicture(error, project.film.width, project.film.height,
                                                   project.asBuilt.strength, height),
                                 pictureName(dip)));
        }
    }
    files.commit();
}

// The part that the photos show, as the next of the job's.
void addPart(Project& project, const QStringList& files, const QCommandLineParser& parser,
             const std::optional<Lens>& lens,
             const std::function<QString(const std::optional<QDateTime>&)>& dateOf,
             const Progress& progress) {
    const std::vector<PartPhoto> photos = readPartPhotos(files, progress.part(0, 0.1));
    const QSize picture = photos.front().picture.size();
    const std::vector<PlacePair> pairs = partPairs(parser, int(photos.size()));
    const PartView camera =
        fitPartCamera(pairs, int(photos.size()), picture, parser.value(pairsOption), lens);
    const auto seen = placesOnPart(photos, pairs, parser, lens, progress.part(0.1, 0.5));
    for (const PrintedPlace& place : seen) {
        if (place.dip >= int(project.immersions.size())) {
            throw Error(QStringLiteral("A place is said to be of dip %1, and the job has %2")
                            .arg(place.dip + 1)
                            .arg(project.immersions.size()),
                        parser.value(pairsOption));
        }
    }
    const std::vector<BuiltPlace> places =
        builtPlaces(seen, camera, picture, dippedFilms(project, progress.part(0.5, 1)),
                    {project.film.width.value(), project.film.height.value()},
                    int(project.asBuilt.parts.size()) + 1);
    QStringList hashes;
    for (const PartPhoto& photo : photos) {
        hashes << photo.sha256;
    }
    project.asBuilt = withBuiltPart(
        std::move(project.asBuilt), places,
        {dateOf(photos.front().taken), parser.value(acceptedOption), hashes.join(u' '), 0},
        parser.value(projectOption));
}

} // namespace

void declareBuilt(CommandSyntax& syntax) {
    syntax.addOption({acceptedOption,
                      QStringLiteral("Of “built”: who has said that the part's figures may "
                                     "count."),
                      QStringLiteral("NAME")});
    syntax.addOption({correctOption,
                      QStringLiteral("Of “built”: how much of what repeats is taken off the next "
                                     "sheets, 0 (nothing) to 1."),
                      QStringLiteral("SHARE")});
}

void inspectBuilt(const QStringList& files, const QCommandLineParser& parser,
                  const std::optional<Lens>& lens,
                  const std::function<QString(const std::optional<QDateTime>&)>& dateOf,
                  Console& console) {
    const QString path = parser.value(projectOption);
    if (path.isEmpty()) {
        throw UsageError(QStringLiteral("Name the job that was dipped with --project JOB.dipw"),
                         QStringLiteral("--project"));
    }
    if (parser.value(acceptedOption).trimmed().isEmpty()) {
        throw UsageError(QStringLiteral("Say who accepts the part with --accepted-by NAME"),
                         QStringLiteral("--accepted-by"));
    }
    dateOf({});                      // refused before any work
    std::optional<ProjectFile> file; // before it is read: nobody else writes it meanwhile
    if (parser.isSet(updateOption)) {
        checkWritable(path); // better now than after the work
        file.emplace(path);
    }
    Project project = loadProject(path);
    const Progress progress = console.progress();
    addPart(project, files, parser, lens, dateOf, progress);
    setCorrection(project.asBuilt, parser);
    writePictures(project, parser.value(QStringLiteral("out")));
    progress(1, QStringLiteral("Done"));
    const BuiltPart& part = project.asBuilt.parts.back();
    console.out() << QStringLiteral("Part %1: off by %2 mm on the sheet (root mean square)\n")
                         .arg(project.asBuilt.parts.size())
                         .arg(number(part.residual, 3));
    for (int dip = 1; dip <= int(project.immersions.size()); ++dip) {
        const RepeatingError error(project.asBuilt, dip);
        if (!error.isNothing()) {
            console.out() << repeatingSentence(error, dip) << '\n';
        }
    }
    if (file) {
        file->save(project);
        console.out() << QStringLiteral("%1 keeps the part; its sheets are %2\n")
                             .arg(path, project.asBuilt.corrects
                                            ? QStringLiteral("corrected from now on")
                                            : QStringLiteral("not corrected"));
    }
}

} // namespace dipwright::cli
