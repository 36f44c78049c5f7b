// Tests jobs whose texture is in CMYK: the amounts of ink in its file arrive on the printer's
// plates, also after the project was saved, and a picture for the film passes as it is.
#include "TestProfiles.h"
#include "TexturedBall.h"
#include "import/trusted/ImportModel.h"
#include "import/trusted/ReadPictures.h"
#include "pipeline/Pipeline.h"
#include "project/ProjectStore.h"
#include "sheet/prepress/PrinterColour.h"
#include "sheet/prepress/Separation.h"

#include <QTemporaryDir>
#include <QtTest>
#include <tiffio.h>

using namespace dipwright;

namespace {

using Inks = std::array<uchar, 4>;
constexpr Inks first{0, 0, 0, 255}, second{200, 30, 0, 90}; // black alone, and a mixture

// Writes a TIFF in CMYK whose left half is `first` and whose right half is `second`.
QString inkTiff(const QTemporaryDir& folder, QSize size, const QByteArray& profile) {
    const QString path = folder.filePath("inks.tif");
    TIFF* tiff = TIFFOpen(path.toLocal8Bit().constData(), "w");
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, size.width());
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, size.height());
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 4);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_SEPARATED);
    TIFFSetField(tiff, TIFFTAG_ICCPROFILE, std::uint32_t(profile.size()), profile.constData());
    std::vector<uchar> row;
    for (int x = 0; x < size.width(); ++x) {
        const Inks& inks = 2 * x < size.width() ? first : second;
        row.insert(row.end(), inks.begin(), inks.end());
    }
    for (int y = 0; y < size.height(); ++y) {
        TIFFWriteScanline(tiff, row.data(), std::uint32_t(y), 0);
    }
    TIFFClose(tiff);
    return path;
}

PrinterProfile printer() {
    PrinterProfile profile;
    profile.name = QStringLiteral("Press");
    profile.iccProfile = simpleCmykProfile(0.02);
    return profile;
}

Project ballWith(const QString& texture) {
    Project project;
    project.model =
        std::make_shared<const TexturedMesh>(withTexture(*test::texturedBall(Qt::red), texture));
    project.film.width = project.film.height = Millimetres(90);
    project.film.resolution = FilmResolution::Points;
    project.film.columns = project.film.rows = 46;
    project.film.work = 0;
    project.fieldResolution = 64;
    project.sheet.resolution = DotsPerInch(100);
    project.profiles.printer = printer();
    project.ink.compensate = false;
    return project;
}

struct Counted {
    double first = 0, second = 0, other = 0; // shares of the pixels with ink
};
Counted countedPlates(const Sheet& sheet) {
    const PrinterColour colour(printer(), {});
    PrintCorrection correction;
    correction.colour = &colour;
    const QByteArray cmyk = separate(sheet, correction).cmyk;
    Counted counted;
    for (qsizetype at = 0; at < cmyk.size(); at += 4) {
        Inks inks{};
        std::copy_n(cmyk.constData() + at, 4, inks.begin());
        if (inks != Inks{}) {
            ++(inks == first ? counted.first : inks == second ? counted.second : counted.other);
        }
    }
    const double sum = counted.first + counted.second + counted.other;
    return {counted.first / sum, counted.second / sum, counted.other / sum};
}

JobResult run(const Project& project, JobOptions options = {}) {
    options.estimatesNumericalError = false;
    return runJob(project, SolverRegistry(), options, nullptr, {});
}

bool tellsOfHiddenInks(const JobResult& result) {
    const auto& reasons = result.verdict.reasons;
    return std::any_of(reasons.begin(), reasons.end(), [](const VerdictReason& reason) {
        return reason.kind == VerdictReason::Kind::HiddenInks;
    });
}

} // namespace

class InkJobTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
    void runJob_textureInThePrintersInks_printsItsNumbers();
    void runJob_savedProject_printsTheSame();
    void runJob_artworkOnTheModel_printsColours();
    void runJob_artworkThatDoesNotShow_printsTheInks();
    void runJob_picturesForTheFilm_passAsTheyAre();
};

void InkJobTest::runJob_textureInThePrintersInks_printsItsNumbers() {
    const QTemporaryDir folder;
    Project project = ballWith(inkTiff(folder, {64, 64}, printer().iccProfile));
    const JobResult result = run(project);
    const Counted counted = countedPlates(result.immersions[0].sheet);
    QVERIFY(counted.first > 0.4 && counted.second > 0.4);
    QVERIFY2(counted.other < 0.06, qPrintable(QString::number(counted.other))); // the border

    project.ink.compensate = true; // the left half is still black alone
    const Sheet sheet = run(project).immersions[0].sheet;
    const PrinterColour colour(printer(), {});
    PrintCorrection correction;
    correction.colour = &colour;
    const QByteArray cmyk = separate(sheet, correction).cmyk;
    const int width = sheet.image.width();
    int black = 0, mixed = 0;
    for (qsizetype at = 0; at < cmyk.size(); at += 4) {
        const bool isLeft = at / 4 % width < width / 2 - 3;
        const bool hasColour = cmyk[at] != 0 || cmyk[at + 1] != 0 || cmyk[at + 2] != 0;
        black += isLeft && cmyk[at + 3] != 0 && !hasColour;
        mixed += isLeft && hasColour;
    }
    QVERIFY(black > 1000);
    QCOMPARE(mixed, 0);
}

void InkJobTest::runJob_savedProject_printsTheSame() {
    const QTemporaryDir folder;
    const Project project = ballWith(inkTiff(folder, {64, 64}, printer().iccProfile));
    const QString path = folder.filePath("ball.dipw");
    saveProject(project, path);
    const Project again = loadProject(path);
    QCOMPARE(again.model->inks.size(), std::size_t(1));
    QVERIFY(again.model->inks[0] == project.model->inks[0]);
    QCOMPARE(inkSpace(again.model->inks[0]), iccIdentity(printer().iccProfile));
    QVERIFY(again.unknown.isEmpty() && again.unknownEntries.empty());
    const Sheet before = run(project).immersions[0].sheet, after = run(again).immersions[0].sheet;
    QVERIFY(before.wanted->inks == after.wanted->inks);
}

void InkJobTest::runJob_artworkOnTheModel_printsColours() {
    const QTemporaryDir folder;
    Project project = ballWith(inkTiff(folder, {64, 64}, printer().iccProfile));
    project.artwork.base = QColor(10, 120, 200);
    const JobResult result = run(project);
    QVERIFY(!result.immersions[0].sheet.wanted);
    QVERIFY(tellsOfHiddenInks(result));
}

void InkJobTest::runJob_artworkThatDoesNotShow_printsTheInks() {
    const QTemporaryDir folder;
    Project project = ballWith(inkTiff(folder, {64, 64}, printer().iccProfile));
    const Sheet without = run(project).immersions[0].sheet;
    ArtworkLayer hidden, transparent;
    hidden.kind = transparent.kind = LayerKind::Carbon;
    hidden.visible = false;
    transparent.opacity = 0;
    project.artwork.layers = {hidden, transparent};
    const JobResult result = run(project);
    const Sheet& sheet = result.immersions[0].sheet;
    QVERIFY(sheet.wanted && sheet.wanted->inks == without.wanted->inks);
    QCOMPARE(sheet.image, without.image);
    QVERIFY(!tellsOfHiddenInks(result));
}

void InkJobTest::runJob_picturesForTheFilm_passAsTheyAre() {
    const QTemporaryDir folder;
    Project project = ballWith(inkTiff(folder, {8, 8}, printer().iccProfile));
    const QSize pixels =
        sheetPixels(project.film.width, project.film.height, project.sheet.resolution);
    const ReadPicture picture = readPictureAndInks(inkTiff(folder, pixels, printer().iccProfile));
    JobOptions options;
    options.filmImage = picture.colours;
    options.filmInks = picture.inks;
    project.ink.compensate = true;               // does not apply to pictures for the film
    project.artwork.base = QColor(10, 120, 200); // nor does artwork
    const JobResult result = run(project, options);
    QVERIFY(!tellsOfHiddenInks(result));
    const Counted counted = countedPlates(result.immersions[0].sheet);
    QVERIFY(counted.first > 0.49 && counted.second > 0.49);
    QCOMPARE(counted.other, 0.0);
}

QTEST_MAIN(InkJobTest)
#include "InkJobTest.moc"
