#include "cli/InspectPart.h"
#include "base/NumberText.h"
#include "model/TexturedMesh.h"

#include "cli/Arguments.h"
#include "disk/SmallFile.h"
#include "import/trusted/ReadPhotos.h"
#include "inspection/BuiltPlaces.h"
#include "inspection/FindPrint.h"
#include "inspection/PartViewFiles.h"
#include "pipeline/Pipeline.h"
#include "project/DipKeys.h"
#include "project/ProjectStore.h"

#include <algorithm>
#include <utility>

namespace dipwright::cli {
namespace {

const QString pairsOption = QStringLiteral("pairs");
const QString placesOption = QStringLiteral("places");
const QString projectOption = QStringLiteral("project");
const QString keepOption = QStringLiteral("keep-camera");

constexpr qint64 mostTableBytes = 4 << 20; // size limit of a table of pairs or places, bytes

void printAccuracy(const std::vector<PlacePair>& pairs, const PartView& view, QTextStream& out) {
    const PartFigures& figures = view.figures;
    const auto number = [](double value, int decimals) {
        return withMinusSign(QString::number(value, 'f', decimals));
    };
    out << QStringLiteral("Camera: focal length %1 ± %2 half diagonals, distortion k1 %3\n")
               .arg(number(view.focalLength.value, 4), number(view.focalLength.off, 4),
                    number(view.lens.k1, 4));
    out << QStringLiteral("Residual of %1 pairs: mean %2 px, deviation %3 px, %4 % of the "
                          "picture's diagonal\n")
               .arg(figures.count)
               .arg(number(figures.meanPixels, 2), number(figures.deviationPixels, 2),
                    number(100 * figures.shareOfDiagonal, 3));
    const PlacePair& worst = pairs[figures.worstPair];
    out << QStringLiteral("On the part: 95 % of the places within %1 mm; largest error %2 mm at "
                          "%3, %4, %5 mm on the model\n")
               .arg(number(figures.percentile95, 3), number(figures.worst, 3),
                    number(worst.model.x(), 1), number(worst.model.y(), 1),
                    number(worst.model.z(), 1));
}

// Returns the corners of the print at the places where the job's dips put them.
std::vector<PrintedCorner> cornersOf(const Project& project, const QCommandLineParser& parser,
                                     const Progress& progress) {
    JobOptions options;
    applyFilmImage(options, parser);
    if (!options.filmImage.isNull()) {
        throw UsageError(QStringLiteral("Only the built-in chessboard, or the chess squares in the "
                                        "model's texture, can be searched for in photos"),
                         QStringLiteral("--film-image"));
    }
    return printedCorners(project, dippedFilms(project, progress),
                          options.chessboard ? PartPrint::Chessboard : PartPrint::Texture);
}

void printFoundCorners(const FoundPrint& print, QTextStream& out) {
    for (std::size_t photo = 0; photo < print.expected.size(); ++photo) {
        const auto found =
            std::count_if(print.places.begin(), print.places.end(),
                          [&](const PrintedPlace& place) { return place.photo == int(photo); });
        out << QStringLiteral("Photo %1: %2 of %3 corners found\n")
                   .arg(photo + 1)
                   .arg(found)
                   .arg(print.expected[photo]);
    }
    if (!print.doubt.isEmpty()) {
        out << print.doubt << '\n';
    }
}

} // namespace

std::vector<std::shared_ptr<const LaidFilm>> dippedFilms(Project project,
                                                         const Progress& progress) {
    JobOptions options;
    options.estimatesNumericalError = false;
    // A low resolution, because the sheets are not kept.
    project.sheet.resolution = DotsPerInch(72);
    const JobResult result = runJob(project, SolverRegistry(), options, nullptr, progress);
    std::vector<std::shared_ptr<const LaidFilm>> dips;
    for (const ImmersionResult& immersion : result.immersions) {
        dips.push_back(immersion.laid);
    }
    return dips;
}

std::vector<PlacePair> partPairs(const QCommandLineParser& parser,
                                 const std::vector<PartPhoto>& photos) {
    const QString path = parser.value(pairsOption);
    if (path.isEmpty()) {
        throw UsageError(QStringLiteral("Name the table of pairs with --pairs FILE.csv"),
                         QStringLiteral("--pairs"));
    }
    std::vector<PlacePair> pairs =
        readPairs(readSmallFile(path, mostTableBytes), int(photos.size()), path);
    requireInPhotos(pairs, photos.front().picture.size(), path);
    return pairs;
}

std::vector<PartPhoto> readPartPhotos(const QStringList& files, const Progress& progress) {
    constexpr qsizetype mostPhotos = 50;
    if (files.size() > mostPhotos) {
        throw UsageError(QStringLiteral("Give at most %1 photos").arg(mostPhotos),
                         QStringLiteral("FILE…"));
    }
    std::vector<PartPhoto> photos;
    for (qsizetype i = 0; i < files.size(); ++i) {
        progress(double(i) / double(files.size()), files[i]);
        Photo photo = readPhotoFile(files[i], progress);
        addPartPhoto(photos, {files[i], photo.sha256, std::move(photo.picture), photo.taken});
    }
    return photos;
}

FoundPrint searchPrint(const std::vector<PartPhoto>& photos, const std::vector<PlacePair>& clicked,
                       const QCommandLineParser& parser, const std::optional<Lens>& lens,
                       const Progress& progress) {
    const QString path = parser.value(projectOption);
    const Project project = loadProject(path);
    const auto corners = cornersOf(project, parser, progress.part(0.2, 0.7));
    if (corners.empty()) {
        throw Error(QStringLiteral(
                        "The model's texture has no chess squares to search for. Dip the printed "
                        "chessboard and add --film-image chessboard, or leave out --project"),
                    path);
    }
    std::vector<QImage> pictures;
    for (const PartPhoto& photo : photos) {
        pictures.push_back(photo.picture);
    }
    return findPrint(pictures, project.model->mesh, corners, clicked,
                     {parser.isSet(keepOption), lens}, progress.part(0.7, 1),
                     parser.value(pairsOption));
}

std::vector<PrintedPlace> placesOnPart(const std::vector<PartPhoto>& photos,
                                       const std::vector<PlacePair>& clicked,
                                       const QCommandLineParser& parser,
                                       const std::optional<Lens>& lens, const Progress& progress,
                                       QTextStream& out) {
    const QString path = parser.value(placesOption);
    if (!path.isEmpty()) {
        return readPlaces(readSmallFile(path, mostTableBytes), int(photos.size()), path);
    }
    FoundPrint print = searchPrint(photos, clicked, parser, lens, progress);
    printFoundCorners(print, out);
    return std::move(print.places);
}

std::vector<PrintedPlace> onJobsSheet(std::vector<PrintedPlace> places,
                                      const QCommandLineParser& parser) {
    JobOptions options;
    applyFilmImage(options, parser);
    return options.chessboard
               ? places
               : onPrintedSheet(std::move(places),
                                partsDippedAlike(loadProject(parser.value(projectOption))));
}

void declarePart(CommandSyntax& syntax) {
    syntax.addOption(
        {pairsOption,
         QStringLiteral("For `part`, `fit` and `built`: a table of places in the photos and on the "
                        "model, with the columns photo,x_px,y_px,x_mm,y_mm,z_mm."),
         QStringLiteral("FILE.csv")});
    syntax.addOption(
        {projectOption,
         QStringLiteral("For `part`, `fit` and `built`: the job of this part. The corners of its "
                        "print are then searched for in the photos, starting from the pairs: chess "
                        "squares in its texture, or --film-image chessboard."),
         QStringLiteral("JOB.dipw")});
    declareChessboard(
        syntax,
        QStringLiteral("For `part`, `fit` and `built`: the film was printed with the built-in "
                       "chessboard. Its corners are searched for, not those in the texture."));
    syntax.addOption(
        {keepOption,
         QStringLiteral(
             "For `fit`, and for `part` with --project: fits the camera to the pairs alone, which "
             "must be places on the part itself. A shift of the whole print then shows.")});
}

void inspectPart(const QStringList& files, const QCommandLineParser& parser,
                 const std::optional<Lens>& lens, Console& console) {
    if (!parser.isSet(projectOption)) {
        refuseOptions(parser, {QStringLiteral("film-image"), keepOption},
                      QStringLiteral("without --project"));
    }
    const Progress progress = console.progress();
    const std::vector<PartPhoto> photos = readPartPhotos(files, progress.part(0, 0.2));
    std::vector<PlacePair> pairs = partPairs(parser, photos);
    FoundPrint print;
    if (parser.isSet(projectOption)) {
        print = searchPrint(photos, pairs, parser, lens, progress);
        pairs = pairsOf(print.places);
    } else {
        print.view = fitPartCamera(pairs, int(photos.size()), photos.front().picture.size(),
                                   parser.value(pairsOption), lens);
    }
    writePartView(photos, pairs, print.view, print.places, parser.value(QStringLiteral("out")));
    progress(1, QStringLiteral("Done"));
    if (parser.isSet(projectOption)) {
        printFoundCorners(print, console.out());
        console.out() << (print.followsPrint
                              ? QStringLiteral("The camera was fitted to the print, so a shift or "
                                               "rotation of the whole print does not show\n")
                              : QStringLiteral("The camera was fitted to the given pairs\n"));
    }
    printAccuracy(pairs, print.view, console.out());
}

} // namespace dipwright::cli
