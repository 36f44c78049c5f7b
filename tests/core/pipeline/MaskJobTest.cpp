// Tests jobs with masked surface: sheet, coverage, verdict, report and traveller.
#include "TestFolders.h"
#include "geometry/Shapes.h"
#include "pipeline/JobTraveller.h"
#include "pipeline/JobVerdict.h"
#include "pipeline/ModelNotes.h"
#include "pipeline/Pipeline.h"
#include "pipeline/Report.h"

#include <QStandardPaths>
#include <QtTest>
#include <numbers>

using namespace dipwright;

namespace {

constexpr double radius = 25;    // of the ball, mm
constexpr double capRadius = 10; // from the pole to the rim of the masked cap, mm

std::shared_ptr<const TexturedMesh> ballModel() {
    auto model = std::make_shared<TexturedMesh>();
    model->mesh = sphereMesh(radius, 60, 120);
    model->textureCoordinates.resize(model->mesh.triangles.size());
    model->material.resize(model->mesh.triangles.size(), 0);
    model->chart.resize(model->mesh.triangles.size(), 0);
    model->materials = {{QStringLiteral("body"), QColor(30, 60, 90), -1}};
    return model;
}

Project ball() {
    static const auto model = ballModel();
    Project project;
    project.model = model;
    project.film.width = project.film.height = Millimetres(120);
    project.film.columns = project.film.rows = 49;
    project.fieldResolution = 96;
    project.sheet.resolution = DotsPerInch(150);
    project.sheet.white = WhiteLayer::Last;
    project.verdict.noPicture = Advice::Print;
    return project;
}

// Returns a mask round a pole of the ball. `side`: −1: the bottom, 1: the top.
MaskMark capAt(double side, double size = capRadius) {
    MaskMark mark;
    mark.path = {{{Millimetres(0), Millimetres(side * radius), Millimetres(0)}, {0, side, 0}}};
    mark.radius = Millimetres(size);
    return mark;
}

Project withMasks(const std::vector<MaskMark>& masks) {
    Project project = ball();
    project.masks = masks;
    return project;
}

// Returns the printed area of a picture of the film, mm².
double printedArea(const QImage& picture, const Project& project) {
    std::size_t printed = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            printed += picture.format() == QImage::Format_Grayscale8
                           ? picture.constScanLine(y)[x] > 0
                           : qAlpha(picture.pixel(x, y)) > 0;
        }
    }
    return double(printed) * project.film.width.value() * project.film.height.value() /
           (double(picture.width()) * picture.height());
}

} // namespace

class MaskJobTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        open_ = run(ball());
    }

    // The film's place of the cap's rim gives the area that must be blank.
    void runJob_cap_isBlankOnTheSheet() {
        const JobResult masked = run(withMasks({capAt(-1)}));
        const double rimHeight = -radius + capRadius * capRadius / (2 * radius);
        const double rim = std::sqrt(radius * radius - rimHeight * rimHeight);
        const LaidFilm& laid = *masked.immersions[0].laid;
        const SurfaceQuery query(masked.project.model->mesh);
        double blank = 0; // mm²
        constexpr int steps = 360;
        for (int step = 0; step < steps; ++step) {
            const double angle = 2 * std::numbers::pi * step / steps;
            const auto place =
                laid.place(query
                               .closest(Eigen::Vector3d(rim * std::cos(angle), rimHeight,
                                                        rim * std::sin(angle))
                                            .cast<float>())
                               .point);
            QVERIFY(place);
            blank += double(place->rest.squaredNorm()) * std::numbers::pi / steps;
        }
        // In the film's printed size; it swells on the water.
        blank /= masked.project.film.swellX * masked.project.film.swellY;
        const ReverseTexture &before = *open_.immersions[0].texture,
                             &after = *masked.immersions[0].texture;
        const double colour = printedArea(before.image, ball()) - printedArea(after.image, ball());
        const double white = printedArea(before.white, ball()) - printedArea(after.white, ball());
        QVERIFY2(
            std::abs(colour / blank - 1) < 0.01,
            qPrintable(QStringLiteral("%1 mm² are blank, expected %2").arg(colour).arg(blank)));
        QCOMPARE(white, colour);
        const QPoint middle(after.image.width() / 2, after.image.height() / 2);
        QCOMPARE(qAlpha(after.image.pixel(middle)), 0);
        QVERIFY(qAlpha(before.image.pixel(middle)) > 0);
    }

    // Marks of another model mark nothing, or the wrong face.
    void misplacedNotes_marksOffThePart_areCounted() {
        Project project = ball();
        const SurfaceQuery query(project.model->mesh);
        const auto notes = [&] { return misplacedNotes(project, query); };
        project.masks = {capAt(-1), capAt(1)};
        project.tolerance.marks.emplace_back().place = {Millimetres(radius), {}, {}};
        project.share.marks.emplace_back().place = {Millimetres(-radius), {}, {}};
        QCOMPARE(notes(), QStringList());
        project.masks.push_back(capAt(1.1)); // within its radius
        QCOMPARE(notes(), QStringList());
        project.masks.push_back(capAt(1.5));
        project.masks.emplace_back(); // a stroke without points
        project.tolerance.marks.emplace_back().place = {Millimetres(9999), {}, {}};
        project.share.marks.emplace_back().path = capAt(-1.5).path;
        QCOMPARE(notes().size(), qsizetype(3));
        QVERIFY2(notes()[0].startsWith(QStringLiteral("Masks that lie off the part: 2.")),
                 qPrintable(notes()[0]));
        // A mark by name is not at a place.
        project.masks = {};
        project.share.marks = {};
        project.tolerance.marks.back().extent = MarkExtent::Material;
        project.tolerance.marks.back().material = QStringLiteral("body");
        QCOMPARE(notes(), QStringList());
    }

    void runJob_maskChanged_keepsTheDip() {
        const Project project = withMasks({capAt(-1)});
        const JobResult masked = runJob(project, registry_, options(), &open_, {});
        QCOMPARE(masked.immersions[0].laid, open_.immersions[0].laid);
        const JobResult anew = run(project);
        QCOMPARE(masked.immersions[0].texture->image, anew.immersions[0].texture->image);
        QCOMPARE(masked.immersions[0].coverage->share, anew.immersions[0].coverage->share);
        const JobResult back = runJob(ball(), registry_, options(), &masked, {});
        QCOMPARE(back.immersions[0].texture->image, open_.immersions[0].texture->image);
        QCOMPARE(back.immersions[0].coverage->share, open_.immersions[0].coverage->share);
    }

    // The film does not reach the ball's top. It paints all the rest.
    void verdict_maskedBareZone_doesNotComplain() {
        Project project = ball();
        project.sheet.white = WhiteLayer::None; // which no printer profile could print
        ZoneMark top;
        top.zone = Zone::B;
        top.extent = MarkExtent::Stroke;
        top.path = capAt(1).path;
        top.radius = Millimetres(8);
        project.tolerance.marks = {top};
        QCOMPARE(adviceOf(run(project)), Advice::DoNotPrint);
        project.masks = {capAt(1, 9)};
        const JobResult masked = run(project);
        QVERIFY(adviceOf(masked) < Advice::CheckFirst);
        QVERIFY(masked.coverageTotal > open_.coverageTotal + 0.01);
    }

    void verdict_everythingBareMasked_coversAll() {
        const JobResult masked = run(withMasks({capAt(1, 1.6 * radius)}));
        QVERIFY2(masked.coverageTotal > 0.97, qPrintable(QString::number(masked.coverageTotal)));
    }

    void report_masks_areNamed() {
        const JobResult masked = run(withMasks({capAt(-1), capAt(1)}));
        const QJsonObject json = report(masked.project, masked)["masks"].toObject();
        QCOMPARE(json["areas"].toInt(), 2);
        const double caps = 2 * std::numbers::pi * capRadius * capRadius;
        QVERIFY(std::abs(json["area_mm2"].toDouble() / caps - 1) < 0.01);
        QVERIFY(!report(open_.project, open_).contains("masks"));
        const Traveller traveller = jobTraveller(masked, {});
        QCOMPARE(traveller.masked.count, std::size_t(2));
        QVERIFY(traveller.dips[0].front.image != jobTraveller(open_, {}).dips[0].front.image);
    }

private:
    static JobOptions options() {
        JobOptions options;
        options.estimatesNumericalError = false;
        return options;
    }
    JobResult run(const Project& project) {
        return runJob(project, registry_, options(), nullptr, {});
    }

    const SolverRegistry registry_{QStringList{pluginFolder()}};
    JobResult open_; // without masks
};

QTEST_MAIN(MaskJobTest)
#include "MaskJobTest.moc"
