// From body to sheet with the film simulated by the CPU plugin.
#include "DippedByHand.h"
#include "dip/Coverage.h"
#include "dip/Dip.h"
#include "geometry/Shapes.h"
#include "solver/SolverRegistry.h"
#include "texture/ReadBack.h"
#include "texture/ReverseTexture.h"
#include "validation/ClosedForm.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <optional>

using namespace dipwright;

namespace {

// One immersion from a model to its film on the body.
std::shared_ptr<const LaidFilm> dipped(const TexturedMesh& model, const Immersion& immersion,
                                       const FilmSettings& film, std::optional<Millimetres> depth,
                                       MillimetresPerSecond speed = ProcessSettings().dipSpeed) {
    ProcessSettings process;
    process.depth = depth;
    process.dipSpeed = speed;
    const auto body = std::make_shared<const PosedBody>(posedBody(model.mesh, immersion));
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

TexturedMesh lettered() {
    return test::boxWithPicture(boxSize, test::letterF());
}

// A box over a place off the film's middle, dipped by 2 mm.
std::shared_ptr<const LaidFilm> dippedBox(const FilmSettings& film,
                                          MillimetresPerSecond speed = ProcessSettings().dipSpeed) {
    Immersion beside;
    beside.offset = {Millimetres(12), Millimetres(-7)};
    return dipped(lettered(), beside, film, Millimetres(2), speed);
}
std::shared_ptr<const LaidFilm> dippedBox() {
    return dippedBox(filmOf(Millimetres(120), Millimetres(100), 97));
}

// By an eighth until the box comes to the water, ten seconds after the begin at this speed.
constexpr MillimetresPerSecond slowly{0.05};
FilmSettings growing(FilmSettings film) {
    film.growthRate = 0.02;
    film.growthLimit = 0.2;
    return film;
}
const double grownByThen = 1 + 0.2 * (1 - std::exp(-0.02 * 10 / 0.2));

// Of the film in its middle, which is under the box.
double compressionInTheMiddle(const LaidFilm& laid) {
    const std::vector<float>& stretches = laid.painted().wrinkling.pointStretches;
    return double(stretches[stretches.size() / 2]);
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
    void whatGrowsIsPrintedSmaller();
    void filmThatCannotGrowWrinkles();
    void sphereIsPaintedToItsOverhangAndInPlace();
    void sphereComesOutInPlaceOnAFilmThatGrows();
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
                position(laid->body().mesh, laid->contact().surface[point]);
            QVERIFY((place - Eigen::Vector3f(rest.x(), 0, rest.y())).norm() < 0.05f);
        }
    }
    QVERIFY(cells > 4000);
}

void PrintedBodyTest::letterOnTheBottomIsMirroredOnTheSheet() {
    ReverseTextureOptions options;
    options.pixels = {1200, 1000}; // ten a millimetre
    const QImage sheet = reverseTexture(*dippedBox(), lettered(), options, Progress{}).image;
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

// The sheet is the film as it was when the dip began. So the letter stands on it an eighth smaller,
// and nearer to the middle.
void PrintedBodyTest::whatGrowsIsPrintedSmaller() {
    ReverseTextureOptions options;
    options.pixels = {1200, 1000}; // ten a millimetre
    const auto laid = dippedBox(growing(filmOf(Millimetres(120), Millimetres(100), 97)), slowly);
    const QImage sheet = reverseTexture(*laid, lettered(), options, Progress{}).image;
    const QImage mirrored = test::letterF().mirrored(true, false);
    int wrong = 0, inked = 0;
    for (int y = -290; y < 290; ++y) {
        for (int x = -290; x < 290; ++x) {
            const QColor printed = sheet.pixelColor(int(600 + (120.5 + x) / grownByThen),
                                                    int(500 + (-69.5 + y) / grownByThen));
            QCOMPARE(printed.alpha(), 255);
            const bool black = printed.red() < 128;
            wrong += black != (mirrored.pixelColor(300 + x, 300 + y).red() < 128);
            inked += black;
        }
    }
    QVERIFY(inked > 20000);
    QVERIFY2(wrong < 850, qPrintable(QString::number(wrong))); // 0.05 mm, as above
    QVERIFY(std::abs(compressionInTheMiddle(*laid) - 1) < 0.002);
}

void PrintedBodyTest::filmThatCannotGrowWrinkles() {
    FilmSettings film = filmOf(Millimetres(120), Millimetres(100), 97);
    film.edges = {true, true, true, true};
    const auto plain = dippedBox(film, slowly), grown = dippedBox(growing(film), slowly);
    QVERIFY(std::abs(compressionInTheMiddle(*plain) - 1) < 0.002);
    QVERIFY(std::abs(compressionInTheMiddle(*grown) - 1 / grownByThen) < 0.002);
    // All but what is drawn down the sides.
    QVERIFY(plain->painted().wrinkling.share < 0.1);
    QVERIFY(grown->painted().wrinkling.share > 0.9);
}

void PrintedBodyTest::sphereIsPaintedToItsOverhangAndInPlace() {
    QImage picture(256, 128, QImage::Format_RGBA8888);
    picture.fill(Qt::red);
    const TexturedMesh globe = test::globe(35, 90, 180, picture);
    const auto laid =
        dipped(globe, Immersion{}, filmOf(Millimetres(210), Millimetres(210), 91), std::nullopt);
    const ReadBackError error = readBackError(*laid, *laid, globe);
    QVERIFY2(error.mean <= 0.15, qPrintable(QString::number(error.mean)));
    QVERIFY2(error.percentile95 <= 0.4, qPrintable(QString::number(error.percentile95)));
    const Coverage cover = coverage(*laid);
    // Painted from the pole to where the sphere turns up by 20°, but for a film cell or two.
    const double end = (1 + std::sin(radians(Degrees(20)))) / 2;
    QVERIFY2(cover.share > end - 0.06 && cover.share < end + 0.005,
             qPrintable(QString::number(cover.share)));
    QCOMPARE(cover.trappedAir.area, 0.0);
}

void PrintedBodyTest::sphereComesOutInPlaceOnAFilmThatGrows() {
    constexpr double radius = 35, side = 240, speed = 2;
    QImage picture(256, 128, QImage::Format_RGBA8888);
    picture.fill(Qt::red);
    const auto film = growing(filmOf(Millimetres(side), Millimetres(side), 161));
    const TexturedMesh globe = test::globe(radius, 90, 180, picture);
    const auto laid =
        dipped(globe, Immersion{}, film, Millimetres(34), MillimetresPerSecond(speed));
    const ReadBackError error = readBackError(*laid, *laid, globe);
    QVERIFY2(error.percentile95 <= 0.2, qPrintable(QString::number(error.percentile95)));

    const FloatingFilm floating{FilmLaw::Elastic, FilmEdge::Free, side / std::sqrt(pi),
                                [](double depth) {
                                    const double seconds = (0.5 + depth) / speed;
                                    return 1 + 0.2 * (1 - std::exp(-0.02 * seconds / 0.2));
                                }};
    const Meridian sphere = sphereMeridian(radius, radians(Degrees(80)));
    const ClosedForm exact(sphere, floating);
    FloatingFilm still = floating;
    still.grown = [](double) { return 1.0; };
    QVERIFY(ClosedForm(sphere, still).filmRadius(sphere.fullArc) >
            exact.filmRadius(sphere.fullArc) + 2); // what growth is worth
    const DippedFilm& dip = laid->film();
    int compared = 0;
    for (std::size_t point = 0; point < dip.states.size(); ++point) {
        const Eigen::Vector3f& place = dip.positions[point];
        const double arc = sphere.arc(double(std::hypot(place.x(), place.z())), double(place.y()));
        const auto onFilm = dip.adhered(point) && arc > 5 && arc < sphere.fullArc
                                ? laid->place(laid->contact().surface[point])
                                : std::nullopt;
        if (onFilm) {
            QVERIFY(std::abs(double(onFilm->rest.norm()) - exact.filmRadius(arc)) < 0.1);
            ++compared;
        }
    }
    QVERIFY(compared > 1000);
}

QTEST_MAIN(PrintedBodyTest)
#include "PrintedBodyTest.moc"
