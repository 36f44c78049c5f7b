#include "cli/InspectPart.h"

#include "disk/SmallFile.h"
#include "import/ReadPhotos.h"
#include "inspection/PartViewFiles.h"

namespace dipwright::cli {
namespace {

const QString pairsOption = QStringLiteral("pairs");

constexpr qint64 mostTableBytes = 4 << 20; // of pairs

std::vector<PartPhoto> readPhotos(const QStringList& files, const Progress& progress) {
    std::vector<PartPhoto> photos;
    for (qsizetype i = 0; i < files.size(); ++i) {
        progress(double(i) / double(files.size()), files[i]);
        Photo photo = readPhotoFile(files[i], progress);
        photos.push_back({files[i], photo.sha256, std::move(photo.picture)});
        if (photos.back().picture.size() != photos.front().picture.size()) {
            throw Error(QStringLiteral("The photos are of different sizes; take those of one "
                                       "camera, held the same way"),
                        files[i]);
        }
    }
    return photos;
}

void tell(const std::vector<PlacePair>& pairs, const PartView& view, QTextStream& out) {
    const PartFigures& figures = view.figures;
    const auto number = [](double value, int decimals) {
        return QString::number(value, 'f', decimals);
    };
    out << QStringLiteral("Camera: focal length %1 ± %2 half diagonals, k1 %3\n")
               .arg(number(view.focalLength.value, 4), number(view.focalLength.off, 4),
                    number(view.lens.k1, 4));
    out << QStringLiteral("N %1 · R %2 ± %3 px · %4 % of the diagonal\n")
               .arg(figures.count)
               .arg(number(figures.meanPixels, 2), number(figures.deviationPixels, 2),
                    number(100 * figures.shareOfDiagonal, 3));
    const PlacePair& worst = pairs[figures.worstPair];
    out << QStringLiteral("On the body: 95 % within %1 mm, the farthest %2 mm at %3, %4, %5 mm of "
                          "the model\n")
               .arg(number(figures.percentile95, 3), number(figures.worst, 3),
                    number(worst.model.x(), 1), number(worst.model.y(), 1),
                    number(worst.model.z(), 1));
}

} // namespace

void declarePart(CommandSyntax& syntax) {
    syntax.addOption({pairsOption,
                      QStringLiteral("Of “part”: a table of places in the photos and on the model "
                                     "with the columns photo,x_px,y_px,x_mm,y_mm,z_mm."),
                      QStringLiteral("FILE.csv")});
}

void inspectPart(const QStringList& files, const QCommandLineParser& parser, Console& console) {
    constexpr qsizetype mostPhotos = 50;
    const QString path = parser.value(pairsOption);
    if (path.isEmpty()) {
        throw UsageError(QStringLiteral("Name the table of pairs with --pairs FILE.csv"),
                         QStringLiteral("--pairs"));
    }
    if (files.size() > mostPhotos) {
        throw UsageError(QStringLiteral("Give %1 photos at most").arg(mostPhotos),
                         QStringLiteral("part FILE…"));
    }
    const auto pairs = readPairs(readSmallFile(path, mostTableBytes), int(files.size()), path);
    const Progress progress = console.progress();
    const std::vector<PartPhoto> photos = readPhotos(files, progress);
    const PartView view =
        fitPartCamera(pairs, int(photos.size()), photos.front().picture.size(), path);
    writePartView(photos, pairs, view, parser.value(QStringLiteral("out")));
    progress(1, QStringLiteral("Done"));
    tell(pairs, view, console.out());
}

} // namespace dipwright::cli
