// Tests the way from the body to the sheet with films that the CPU plugin simulates.
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

// Dips a model and returns its film on the body.
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

// Returns the film of a box that is dipped by 2 mm beside the film's middle.
std::shared_ptr<const LaidFilm> dippedBox(const FilmSettings& film,
                                          MillimetresPerSecond speed = ProcessSettings().dipSpeed) {
    Immersion beside;
    beside.offset = {Millimetres(12), Millimetres(-7)};
    return dipped(lettered(), beside, film, Millimetres(2), speed);
}
std::shared_ptr<const LaidFilm> dippedBox() {
    return dippedBox(filmOf(Millimetres(120), Millimetres(100), 97));
}

// At this speed the box reaches the water after 10 s. Until then the film grows by about 1/8.
constexpr MillimetresPerSecond slowly{0.05};
FilmSettings growing(FilmSettings film) {
    film.growthRate = 0.02;
    film.growthLimit = 0.2;
    return film;
}
const double grownByThen = 1 + 0.2 * (1 - std::exp(-0.02 * 10 / 0.2));

// Returns the smaller principal stretch in the film's middle, which is under the box.
double compressionInTheMiddle(const LaidFilm& laid) {
    const std::vector<float>& stretches = laid.painted().wrinkling.pointStretches;
    return double(stretches[stretches.size() / 2]);
}

// Tells whether a film triangle lies completely under the box's bottom.
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
    void simulateDip_flatFace_keepsTheFilm();
    void reverseTexture_letterOnTheBottom_isMirroredOnTheSheet();
    void reverseTexture_growingFilm_isPrintedSmaller();
    void simulateDip_growingFilmPinnedAllRound_wrinkles();
    void simulateDip_sphere_isPaintedToTheOverhangInPlace();
    void simulateDip_sphereOnGrowingFilm_matchesClosedForm();
};

void PrintedBodyTest::simulateDip_flatFace_keepsTheFilm() {
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

void PrintedBodyTest::reverseTexture_letterOnTheBottom_isMirroredOnTheSheet() {
    ReverseTextureOptions options;
    options.pixels = {1200, 1000}; // ten per mm
    const QImage sheet = reverseTexture(*dippedBox(), lettered(), options, Progress{}).image;
    // The letter must be mirrored on the sheet and 60 mm wide. Its middle must be 12 mm to the
    // right of the film's middle and 7 mm above it.
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
    // An error of 0.05 mm along the letter's outline of 170 mm is 850 pixels.
    QVERIFY2(wrong < 850, qPrintable(QStringLiteral("%1 wrong pixels, expected < 850").arg(wrong)));
}

// The sheet shows the film before it grew. On the sheet the letter is smaller, by a factor of about
// 8/9, and nearer to the middle.
void PrintedBodyTest::reverseTexture_growingFilm_isPrintedSmaller() {
    ReverseTextureOptions options;
    options.pixels = {1200, 1000}; // ten per mm
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
    QVERIFY2(
        wrong < 850,
        qPrintable(
            QStringLiteral("%1 wrong pixels, expected < 850").arg(wrong))); // 0.05 mm, as above
    QVERIFY(std::abs(compressionInTheMiddle(*laid) - 1) < 0.002);
}

void PrintedBodyTest::simulateDip_growingFilmPinnedAllRound_wrinkles() {
    FilmSettings film = filmOf(Millimetres(120), Millimetres(100), 97);
    film.edges = {true, true, true, true};
    const auto plain = dippedBox(film, slowly), grown = dippedBox(growing(film), slowly);
    QVERIFY(std::abs(compressionInTheMiddle(*plain) - 1) < 0.002);
    QVERIFY(std::abs(compressionInTheMiddle(*grown) - 1 / grownByThen) < 0.002);
    // All film wrinkles except the film on the sides of the box.
    QVERIFY(plain->painted().wrinkling.share < 0.1);
    QVERIFY(grown->painted().wrinkling.share > 0.9);
}

void PrintedBodyTest::simulateDip_sphere_isPaintedToTheOverhangInPlace() {
    QImage picture(256, 128, QImage::Format_RGBA8888);
    picture.fill(Qt::red);
    const TexturedMesh globe = test::globe(35, 90, 180, picture);
    const auto laid =
        dipped(globe, Immersion{}, filmOf(Millimetres(210), Millimetres(210), 91), std::nullopt);
    const ReadBackError error = readBackError(*laid, *laid, globe);
    QVERIFY2(error.mean <= 0.15,
             qPrintable(QStringLiteral("read-back error: mean %1 mm, expected 0.15 mm or less")
                            .arg(error.mean)));
    QVERIFY2(
        error.percentile95 <= 0.4,
        qPrintable(QStringLiteral("read-back error: 95 % within %1 mm, expected 0.4 mm or less")
                       .arg(error.percentile95)));
    const Coverage cover = coverage(*laid);
    // Painted from the pole to the overhang of 20°, within two film cells.
    const double end = (1 + std::sin(radians(Degrees(20)))) / 2;
    QVERIFY2(
        cover.share > end - 0.06 && cover.share < end + 0.005,
        qPrintable(QStringLiteral("coverage %1, expected up to %2").arg(cover.share).arg(end)));
    QCOMPARE(cover.trappedAir.area, 0.0);
}

void PrintedBodyTest::simulateDip_sphereOnGrowingFilm_matchesClosedForm() {
    constexpr double radius = 35, side = 240, speed = 2;
    QImage picture(256, 128, QImage::Format_RGBA8888);
    picture.fill(Qt::red);
    const auto film = growing(filmOf(Millimetres(side), Millimetres(side), 161));
    const TexturedMesh globe = test::globe(radius, 90, 180, picture);
    const auto laid =
        dipped(globe, Immersion{}, film, Millimetres(34), MillimetresPerSecond(speed));
    const ReadBackError error = readBackError(*laid, *laid, globe);
    QVERIFY2(
        error.percentile95 <= 0.2,
        qPrintable(QStringLiteral("read-back error: 95 % within %1 mm, expected 0.2 mm or less")
                       .arg(error.percentile95)));

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
            exact.filmRadius(sphere.fullArc) + 2); // the film's growth moves film by more than 2 mm
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
