// Artwork from the project to the sheet: what it paints, what it makes anew, what it leaves alone.
#include "artwork/PaintArtwork.h"
#include "base/WideColour.h"
#include "geometry/Shapes.h"
#include "pipeline/Pipeline.h"
#include "pipeline/Report.h"
#include "pipeline/ValidateJob.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QStandardPaths>
#include <QtTest>

using namespace dipwright;

namespace {

std::shared_ptr<const TexturedMesh> bareBall() {
    auto model = std::make_shared<TexturedMesh>();
    model->mesh = sphereMesh(15, 30, 60);
    const Eigen::Vector2f none = Eigen::Vector2f::Constant(std::nanf(""));
    model->textureCoordinates.assign(model->mesh.triangles.size(), {none, none, none});
    model->material.resize(model->mesh.triangles.size(), 0);
    model->materials.resize(1);
    model->chart = findCharts(*model);
    return model;
}

Project ballJob() {
    Project project;
    project.name = QStringLiteral("ball");
    project.model = bareBall();
    project.film.width = project.film.height = Millimetres(90);
    project.film.columns = project.film.rows = 31;
    project.fieldResolution = 64;
    project.sheet.resolution = DotsPerInch(100);
    return project;
}

// A spot on what goes into the water first.
ArtworkLayer spot(const QColor& colour, double size) {
    ArtworkLayer layer = newLayer(LayerKind::Picture, QStringLiteral("Spot"));
    QImage image(20, 20, QImage::Format_RGBA8888);
    image.fill(colour);
    layer.picture = artworkPicture(image);
    layer.place = {Millimetres(0), Millimetres(-15), Millimetres(0)};
    layer.size = {Millimetres(size), Millimetres(size)};
    return layer;
}

Project spottedJob() {
    Project project = ballJob();
    project.artwork.base = Qt::white;
    project.artwork.layers = {spot(QColor(200, 30, 30), 10)};
    return project;
}

// mm² of a film's picture that are red.
double redArea(const ImmersionResult& result, const Project& project) {
    const QImage image = inSrgb(result.texture->image);
    qint64 count = 0;
    for (int row = 0; row < image.height(); ++row) {
        for (int column = 0; column < image.width(); ++column) {
            const QColor colour = image.pixelColor(column, row);
            count += colour.alpha() == 255 && colour.red() > colour.green() + 60 ? 1 : 0;
        }
    }
    return double(count) * project.film.width.value() * project.film.height.value() /
           (double(image.width()) * image.height());
}

} // namespace

class ArtworkJobTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        registry_ = std::make_unique<SolverRegistry>(QStringList{DIPWRIGHT_PLUGINS});
        bare_ = run(ballJob());
        spotted_ = run(spottedJob(), &bare_);
    }

    // As ever: its plain colour, grey, all over.
    void anUntexturedModelWithoutArtworkPrintsItsPlainColour() {
        QCOMPARE(bare_.painted, bare_.project.model);
        const QImage image = bare_.immersions[0].texture->image;
        QVERIFY(image.pixelColor(image.width() / 2, image.height() / 2).lightness() > 120);
        QVERIFY(image.pixelColor(image.width() / 2, image.height() / 2).lightness() < 240);
        QCOMPARE(redArea(bare_.immersions[0], bare_.project), 0.0);
    }

    void aSpotIsPrintedWhereItIsAndNoInkBesideIt() {
        const ImmersionResult& result = spotted_.immersions[0];
        const double area = redArea(result, spotted_.project);
        QVERIFY2(area > 60 && area < 110, qPrintable(QString::number(area))); // less by stretch
        const QImage image = inSrgb(result.texture->image);
        QVERIFY(image.pixelColor(image.width() / 2, image.height() / 2).red() > 150);
        QVERIFY(image.pixelColor(image.width() / 2 + 40, image.height() / 2).lightness() > 250);
        QVERIFY(result.readBack.samples > 0 && result.readBack.percentile95 < 0.5);
    }

    void aLayerThatIsMovedTakesNoDipAndGivesWhatAWholeRunGives() {
        Project moved = spottedJob();
        moved.model = spotted_.project.model;
        moved.artwork.layers[0].place[0] = Millimetres(5);
        moved.artwork.layers[0].turn = Degrees(20);
        bool hasDipped = false;
        JobOptions options;
        options.observer = [&](std::size_t, const FilmFrame&) { hasDipped = true; };
        const JobResult live = runJob(moved, *registry_, options, &spotted_, {});
        QVERIFY(!hasDipped);
        QVERIFY(live.immersions[0].texture->image != spotted_.immersions[0].texture->image);
        const JobResult whole = run(moved);
        QCOMPARE(live.immersions[0].texture->image, whole.immersions[0].texture->image);
        QCOMPARE(live.immersions[0].sheet.job.hash, whole.immersions[0].sheet.job.hash);
        QCOMPARE(live.proof, whole.proof);
        QCOMPARE(live.immersions[0].readBack.mean, whole.immersions[0].readBack.mean);
        QCOMPARE(live.coverageTotal, whole.coverageTotal);
    }

    void takenOffAgainItIsAsBefore() {
        Project bare = ballJob();
        bare.model = spotted_.project.model;
        const JobResult result = runJob(bare, *registry_, {}, &spotted_, {});
        QCOMPARE(result.immersions[0].texture->image, bare_.immersions[0].texture->image);
        QCOMPARE(result.immersions[0].sheet.job.hash, bare_.immersions[0].sheet.job.hash);
    }

    void nothingChangedIsPaintedNoMore() {
        const JobResult again = run(spotted_.project, &spotted_);
        QCOMPARE(again.painted, spotted_.painted);
        QCOMPARE(again.immersions[0].texture, spotted_.immersions[0].texture);
    }

    void theReportListsTheLayers() {
        const QJsonObject json = report(spotted_.project, spotted_);
        const QJsonArray layers =
            json[QLatin1String("artwork")].toObject()[QLatin1String("layers")].toArray();
        QCOMPARE(layers.size(), 1);
        QCOMPARE(layers[0].toObject()[QLatin1String("name")].toString(), QStringLiteral("Spot"));
        QVERIFY(!report(bare_.project, bare_).contains(QLatin1String("artwork")));
    }

    void plainColoursAndMissingFontsAreSaidBeforehand() {
        const auto says = [&](const Project& project, const char* words) {
            return validateJob(project, *registry_)
                .join(QLatin1Char('\n'))
                .contains(QLatin1String(words));
        };
        QVERIFY(says(ballJob(), "no texture"));
        QVERIFY(!says(spottedJob(), "no texture"));
        Project project = spottedJob();
        project.artwork.layers.push_back(newLayer(LayerKind::Text, QStringLiteral("Title")));
        project.artwork.layers.back().font = QStringLiteral("No Such Letters");
        QVERIFY(says(project, "No Such Letters"));
    }

private:
    JobResult run(const Project& project, const JobResult* previous = nullptr) const {
        return runJob(project, *registry_, {}, previous, {});
    }

    std::unique_ptr<SolverRegistry> registry_;
    JobResult bare_, spotted_;
};

QTEST_MAIN(ArtworkJobTest)
#include "ArtworkJobTest.moc"
