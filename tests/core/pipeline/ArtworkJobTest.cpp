// Tests artwork from the project to the sheet: what it paints, and which steps are computed again
// after a change.
#include "TestFolders.h"
#include "artwork/EditArtwork.h"
#include "artwork/PaintArtwork.h"
#include "base/Error.h"
#include "base/WideGamut.h"
#include "dip/Pose.h"
#include "geometry/Shapes.h"
#include "pipeline/JobSearch.h"
#include "pipeline/JobSheet.h"
#include "pipeline/Pipeline.h"
#include "pipeline/Report.h"
#include "pipeline/ValidateJob.h"
#include "texture/ReverseTexture.h"

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

// Returns a layer with a spot on the body's lowest point, `size` mm wide.
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

// Returns the red area of a film's picture, in mm².
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

double redPixels(const QImage& image) {
    double count = 0;
    for (int row = 0; row < image.height(); ++row) {
        for (int column = 0; column < image.width(); ++column) {
            const QColor colour = image.pixelColor(column, row);
            count += colour.red() > colour.green() + 60 ? 1 : 0;
        }
    }
    return count;
}

} // namespace

class ArtworkJobTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        registry_ = std::make_unique<SolverRegistry>(QStringList{pluginFolder()});
        bare_ = run(ballJob());
        spotted_ = run(spottedJob(), &bare_);
    }

    // The plain colour of the model is grey.
    void runJob_untexturedModelWithoutArtwork_printsItsPlainColour() {
        QCOMPARE(bare_.painted, bare_.project.model);
        const QImage image = bare_.immersions[0].texture->image;
        QVERIFY(image.pixelColor(image.width() / 2, image.height() / 2).lightness() > 120);
        QVERIFY(image.pixelColor(image.width() / 2, image.height() / 2).lightness() < 240);
        QCOMPARE(redArea(bare_.immersions[0], bare_.project), 0.0);
    }

    void runJob_spot_isPrintedInItsPlaceWithoutInkBesideIt() {
        const ImmersionResult& result = spotted_.immersions[0];
        const double area = redArea(result, spotted_.project);
        QVERIFY2(area > 60 && area < 110,
                 qPrintable(QStringLiteral("red area %1 mm², expected 60 to 110 mm²")
                                .arg(area))); // stretch reduces the spot's area
        const QImage image = inSrgb(result.texture->image);
        QVERIFY(image.pixelColor(image.width() / 2, image.height() / 2).red() > 150);
        QVERIFY(image.pixelColor(image.width() / 2 + 40, image.height() / 2).lightness() > 250);
        QVERIFY(result.readBack->samples > 0 && result.readBack->percentile95 < 0.5);
    }

    void runJob_layerMoved_reusesTheDipAndEqualsAFullRun() {
        Project moved = spottedJob();
        moved.model = spotted_.project.model;
        moved.artwork.layers[0].place[0] = Millimetres(5);
        moved.artwork.layers[0].turn = Degrees(20);
        bool hasDipped = false;
        JobOptions options;
        options.observer = [&](std::size_t, const FilmFrame&) { hasDipped = true; };
        const JobResult live = runJob(moved, *registry_, options, &spotted_, {});
        QVERIFY(!hasDipped);
        isOnTheSameFilm(live.immersions[0]);
        QVERIFY(live.immersions[0].texture->image != spotted_.immersions[0].texture->image);
        const JobResult whole = run(moved);
        QCOMPARE(live.immersions[0].texture->image, whole.immersions[0].texture->image);
        QCOMPARE(live.immersions[0].sheet.job.hash, whole.immersions[0].sheet.job.hash);
        QCOMPARE(live.proof, whole.proof);
        QCOMPARE(live.immersions[0].readBack->mean, whole.immersions[0].readBack->mean);
        QCOMPARE(live.coverageTotal, whole.coverageTotal);
    }

    void runJob_layerRemoved_restoresTheEarlierSheet() {
        Project bare = ballJob();
        bare.model = spotted_.project.model;
        const JobResult result = runJob(bare, *registry_, {}, &spotted_, {});
        QCOMPARE(result.immersions[0].texture->image, bare_.immersions[0].texture->image);
        QCOMPARE(result.immersions[0].sheet.job.hash, bare_.immersions[0].sheet.job.hash);
    }

    void checkSpots_nameOfAnotherInk_isRefusedWithItsLayer() {
        const auto refusal = [](const Project& before, const Project& after) {
            try {
                checkEditedSpots(before, after);
            } catch (const Error& error) {
                return error.sentence();
            }
            return QString();
        };
        Project project = spottedJob();
        project.sheet.white = WhiteLayer::Last;
        Project edited = project;
        edited.artwork.layers[0].name = QStringLiteral("Logo");
        edited.artwork.layers[0].spot = QStringLiteral("white");
        const QString sentence = refusal(project, edited);
        QVERIFY2(sentence.contains("Logo") && sentence.contains("rename the white ink"),
                 qPrintable(sentence));
        QVERIFY(refusal(edited, edited).isEmpty()); // an old fault does not stop other edits
        edited.sheet.white = WhiteLayer::None;
        QVERIFY(refusal(project, edited).isEmpty());
        edited.sheet.cutLine = CutLine::Ink;
        edited.sheet.cutName = QStringLiteral("WHITE");
        QVERIFY(refusal(project, edited).contains("cut contour"));
        edited = project;
        edited.sheet.cutLine = CutLine::Ink;
        edited.sheet.cutName = QStringLiteral("White");
        QVERIFY(refusal(project, edited).contains("both named White"));
        edited = project;
        edited.artwork.layers.push_back(edited.artwork.layers[0]);
        edited.artwork.layers[0].spot = QStringLiteral("Gloss");
        edited.artwork.layers[1].spot = QStringLiteral("gloss");
        QVERIFY(refusal(project, edited).contains("capital letters"));
    }

    void runJob_unchangedArtwork_reusesThePaintedModel() {
        const JobResult again = run(spotted_.project, &spotted_);
        QCOMPARE(again.painted, spotted_.painted);
        QCOMPARE(again.immersions[0].texture, spotted_.immersions[0].texture);
    }

    // The plate inks the same places of the film that the colour would.
    void runJob_layerInSpotInk_isAPlateAndNotColour() {
        Project project = spottedJob();
        project.model = spotted_.project.model;
        project.artwork.layers[0].spot = QStringLiteral("Pantone 485 C");
        project.artwork.layers[0].spotColour = QColor(218, 41, 28);
        project.artwork.layers.push_back(project.artwork.layers[0]);
        project.artwork.layers[1].spot = QStringLiteral("Gloss varnish");
        project.artwork.layers[1].spotFirst = true;
        project.artwork.layers[1].opacity = 0.5;
        project.sheet.white = WhiteLayer::Last;
        const JobResult result = run(project, &spotted_);
        const ImmersionResult& dip = result.immersions[0];
        isOnTheSameFilm(dip);
        QCOMPARE(redArea(dip, project), 0.0);
        QCOMPARE(dip.sheet.plates.size(), std::size_t(3));
        QStringList names;
        for (const SheetPlate& plate : dip.sheet.plates) {
            names << plate.name;
            QCOMPARE(plate.tint.size(), dip.sheet.image.size());
        }
        QCOMPARE(names, QStringList({"Pantone 485 C", "Gloss varnish", "White"}));
        QVERIFY(!dip.sheet.plates[0].first && dip.sheet.plates[1].first);
        QCOMPARE(dip.sheet.plates[0].alternate, QColor(218, 41, 28));
        const QImage red = inSrgb(spotted_.immersions[0].texture->image);
        int same = 0, other = 0;
        for (int row = 0; row < red.height(); ++row) {
            for (int column = 0; column < red.width(); ++column) {
                const QColor colour = red.pixelColor(column, row);
                const bool isRed = colour.alpha() == 255 && colour.red() > colour.green() + 60;
                const bool isTinted = dip.sheet.plates[0].tint.constScanLine(row)[column] > 128;
                same += isRed && isTinted;
                other += isRed != isTinted;
            }
        }
        QVERIFY2(same > 800 && other < same / 10,
                 qPrintable(QString("%1 pixels in both, %2 in one only").arg(same).arg(other)));
        // The part shows half the tint. The film needs a higher tint where it is stretched.
        const QImage& varnish = dip.sheet.plates[1].tint;
        const int middle = varnish.constScanLine(varnish.height() / 2)[varnish.width() / 2];
        QVERIFY2(middle > 110 && middle < 180,
                 qPrintable(QStringLiteral("tint %1 of 255, expected 110 to 180").arg(middle)));
        const QJsonArray spots = report(result.project, result)[QLatin1String("immersions")]
                                     .toArray()[0]
                                     .toObject()[QLatin1String("spots")]
                                     .toArray();
        QCOMPARE(spots.size(), 3);
        QCOMPARE(spots[1].toObject()[QLatin1String("printed")].toString(), "first");
        // The proof shows the spot ink's colour, which differs slightly from the layer's colour.
        QVERIFY(redPixels(bare_.proof) == 0);
        const double shown = redPixels(result.proof), inInks = redPixels(spotted_.proof);
        QVERIFY2(shown > 0.9 * inInks && shown < 1.1 * inInks,
                 qPrintable(QStringLiteral("%1 of %2").arg(shown).arg(inInks)));
        project.artwork.layers[1].spot = QStringLiteral("white");
        QVERIFY_EXCEPTION_THROWN(run(project, &spotted_), Error);
        QVERIFY_EXCEPTION_THROWN(validateJob(project, *registry_), Error);
    }

    // All directions of a ball are equal except for its ink.
    void searchPoses_artwork_bringsTheInkDown() {
        Project project = spottedJob();
        project.artwork.layers[0].place = {Millimetres(15), Millimetres(0), Millimetres(0)};
        SearchSettings settings;
        settings.directions = 200;
        settings.simulated = 12;
        settings.refined = settings.confirmed = 0;
        settings.aims.weights = {};
        settings.aims.weights[Measure::Quality] = 1;
        const auto best = [&] {
            return searchPoses(searchSubject(project, QStringLiteral("auto")), settings,
                               registry_->module("auto"), {}, {}, {})
                .ranking.front();
        };
        const RankedPoses inked = best();
        const Eigen::Vector3d spotNow =
            rotationMatrix(inked.immersions[0].rotation) * Eigen::Vector3d::UnitX();
        QVERIFY2(spotNow.y() < 0.2,
                 qPrintable(QStringLiteral("height of the spot's direction %1, expected < 0.2")
                                .arg(spotNow.y())));
        const double quality = inked.measures[Measure::Quality];
        QVERIFY2(quality > 0.95,
                 qPrintable(QStringLiteral("quality %1, expected > 0.95").arg(quality)));
        project.sheet.white = WhiteLayer::Last; // white round the spot uses film, too
        QVERIFY(best().measures[Measure::Quality] < quality - 0.1);
    }

    void searchSubject_otherArtwork_hasAnotherIdentity() {
        Project project = spottedJob();
        const QByteArray before = searchSubject(project, QStringLiteral("auto")).identity;
        QCOMPARE(searchSubject(project, QStringLiteral("auto")).identity, before);
        project.artwork.layers[0].place[0] = Millimetres(3);
        QVERIFY(searchSubject(project, QStringLiteral("auto")).identity != before);
    }

    void report_artwork_listsTheLayers() {
        const QJsonObject json = report(spotted_.project, spotted_);
        const QJsonArray layers =
            json[QLatin1String("artwork")].toObject()[QLatin1String("layers")].toArray();
        QCOMPARE(layers.size(), 1);
        QCOMPARE(layers[0].toObject()[QLatin1String("name")].toString(), QStringLiteral("Spot"));
        QVERIFY(!report(bare_.project, bare_).contains(QLatin1String("artwork")));
    }

    void validateJob_plainColourAndMissingFont_areReported() {
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
        JobOptions options;
        options.estimatesNumericalError = false;
        const Verdict verdict = runJob(project, *registry_, options, nullptr, {}).verdict;
        QVERIFY(std::any_of(verdict.reasons.begin(), verdict.reasons.end(), [](const auto& reason) {
            return reason.advice == Advice::CheckFirst && reason.text.contains("No Such Letters");
        }));
    }

private:
    JobResult run(const Project& project, const JobResult* previous = nullptr) const {
        return runJob(project, *registry_, {}, previous, {});
    }
    // After a change of the appearance, the dip is not computed again.
    void isOnTheSameFilm(const ImmersionResult& dip) const {
        QCOMPARE(dip.body, spotted_.immersions[0].body);
        QCOMPARE(dip.laid, spotted_.immersions[0].laid);
        QCOMPARE(dip.coverage, spotted_.immersions[0].coverage);
        QVERIFY(dip.appearance != spotted_.immersions[0].appearance);
    }

    std::unique_ptr<SolverRegistry> registry_;
    JobResult bare_, spotted_;
};

QTEST_MAIN(ArtworkJobTest)
#include "ArtworkJobTest.moc"
