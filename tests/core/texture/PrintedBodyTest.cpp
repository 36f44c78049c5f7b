// From body to sheet with the film simulated by the CPU plugin.
#include "DippedByHand.h"
#include "dip/Coverage.h"
#include "dip/Dip.h"
#include "geometry/Shapes.h"
#include "solver/SolverRegistry.h"
#include "texture/ReadBack.h"
#include "texture/ReverseTexture.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <optional>

using namespace dipwright;

namespace {

// One immersion from a model to its film on the body.
std::shared_ptr<const LaidFilm> dipped(const TexturedMesh& model, const Immersion& immersion,
                                       const FilmSettings& film, std::optional<Millimetres> depth) {
    ProcessSettings process;
    process.depth = depth;
    const auto body = std::make_shared<const PosedBody>(posedBody(model, immersion));
    const SolverRegistry registry;
    const DistanceField field = buildDistanceField(model.mesh, 128, Progress{});
    return layFilm(body,
                   simulateDip(*body, field, immersion, film, process, registry.module("pbd-cpu"),
                               Progress{}, {}),
                   process);
}

FilmSettings filmOf(Millimetres width, Millimetres height, int columns) {
    FilmSettings settings;
    settings.preset = "custom";
    settings.width = width;
    settings.height = height;
    settings.columns = columns;
    settings.rows = int(std::lround((columns - 1) * (height / width))) + 1; // square cells
    return settings;
}

const Eigen::Vector3d boxSize(60, 20, 60);

// A box over a place off the film's middle, dipped by 2 mm.
std::shared_ptr<const LaidFilm> dippedBox() {
    Immersion beside;
    beside.offset = {Millimetres(12), Millimetres(-7)};
    return dipped(test::boxWithPicture(boxSize, test::letterF()), beside,
                  filmOf(Millimetres(120), Millimetres(100), 97), Millimetres(2));
}

// Film cells wholly under the box's bottom: whether a film triangle is one.
bool isUnderBottom(const solver::FilmGrid& grid, const FilmTriangle& triangle) {
    return std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t point) {
        const Eigen::Vector2f rest = restPosition(grid, point) - Eigen::Vector2f(12, -7);
        return rest.cwiseAbs().maxCoeff() < 29.9f;
    });
}

} // namespace

class PrintedBodyTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void flatFaceIsCarriedUnchanged();
    void letterOnTheBottomIsMirroredOnTheSheet();
    void sphereIsPaintedToItsOverhangAndInPlace();
};

void PrintedBodyTest::flatFaceIsCarriedUnchanged() {
    const auto laid = dippedBox();
    const solver::FilmGrid& grid = laid->film().grid;
    const std::vector<FilmTriangle>& triangles = laid->triangles();
    const std::vector<PrincipalStretch>& stretches = laid->stretches();
    int cells = 0;
    for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle) {
        if (!isUnderBottom(grid, triangles[triangle])) {
            continue;
        }
        ++cells;
        QVERIFY(laid->contact().painted[triangle]);
        QVERIFY(std::abs(stretches[triangle].larger - 1) < 0.002f);
        QVERIFY(std::abs(stretches[triangle].smaller - 1) < 0.002f);
        for (const std::uint32_t point : triangles[triangle]) {
            const Eigen::Vector2f rest = restPosition(grid, point) - Eigen::Vector2f(12, -7);
            const Eigen::Vector3f place =
                position(laid->body().model.mesh, laid->contact().surface[point]);
            QVERIFY((place - Eigen::Vector3f(rest.x(), 0, rest.y())).norm() < 0.05f);
        }
    }
    QVERIFY(cells > 4000);
}

void PrintedBodyTest::letterOnTheBottomIsMirroredOnTheSheet() {
    ReverseTextureOptions options;
    options.pixels = {1200, 1000}; // ten a millimetre
    const QImage sheet = reverseTexture(*dippedBox(), options, Progress{}).image;
    // The letter as it has to stand on the sheet: mirrored, 60 mm wide, its middle 12 mm right of
    // the film's and 7 mm above it.
    const QImage mirrored = test::letterF().mirrored(true, false);
    int wrong = 0;
    int inked = 0;
    for (int y = -290; y < 290; ++y) {
        for (int x = -290; x < 290; ++x) {
            const QColor printed = sheet.pixelColor(600 + 120 + x, 500 - 70 + y);
            QCOMPARE(printed.alpha(), 255);
            const bool black = printed.red() < 128;
            wrong += black != (mirrored.pixelColor(300 + x, 300 + y).red() < 128);
            inked += black;
        }
    }
    QVERIFY(inked > 20000);
    // 0.05 mm along all of the letter's outline of 170 mm is 850 pixels.
    QVERIFY2(wrong < 850, qPrintable(QString::number(wrong)));
}

void PrintedBodyTest::sphereIsPaintedToItsOverhangAndInPlace() {
    QImage picture(256, 128, QImage::Format_RGBA8888);
    picture.fill(Qt::red);
    const auto laid = dipped(test::globe(35, 90, 180, picture), Immersion{},
                             filmOf(Millimetres(210), Millimetres(210), 91), std::nullopt);
    const ReadBackError error = readBackError(*laid, *laid);
    QVERIFY2(error.mean <= 0.15, qPrintable(QString::number(error.mean)));
    QVERIFY2(error.percentile95 <= 0.4, qPrintable(QString::number(error.percentile95)));
    const Coverage cover = coverage(*laid);
    // Painted from the pole to where the sphere turns up by 20°, but for a film cell or two.
    const double end = (1 + std::sin(radians(Degrees(20)))) / 2;
    QVERIFY2(cover.share > end - 0.06 && cover.share < end + 0.005,
             qPrintable(QString::number(cover.share)));
    QCOMPARE(cover.trappedAirArea, 0.0);
}

QTEST_MAIN(PrintedBodyTest)
#include "PrintedBodyTest.moc"
