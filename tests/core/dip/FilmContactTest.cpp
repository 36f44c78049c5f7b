// Tests which film adheres to the body, and how much of the body it paints.
#include "DippedByHand.h"
#include "JoinedMeshes.h"
#include "dip/Coverage.h"
#include "geometry/Shapes.h"

#include <QtTest>

#include <cmath>
#include <numeric>

using namespace dipwright;

namespace {

struct Located {
    std::shared_ptr<const LaidFilm> laid;
    const PosedBody& body;
    const DippedFilm& film;
    const FilmContact& contact;

    Located(const TriangleMesh& mesh, const DippedFilm& dipped,
            const ProcessSettings& process = ProcessSettings{})
        : laid(test::laid(mesh, dipped, process)), body(laid->body()), film(laid->film()),
          contact(laid->contact()) {}

    // Returns the film's place over the point of the body that is nearest to `position`.
    std::optional<FilmPlace> placeAt(const Eigen::Vector3f& position) const {
        return laid->place(body.query.closest(position).point);
    }
    std::size_t paintedCount() const {
        return std::size_t(
            std::accumulate(contact.painted.begin(), contact.painted.end(), std::size_t(0)));
    }
    Eigen::Vector3f place(std::size_t point) const {
        return position(body.mesh, contact.surface[point]);
    }
    // Whether `holds` is true for the middle of every painted film triangle.
    template <typename Test>
    bool allPainted(const Test& holds) const {
        for (std::size_t triangle = 0; triangle < laid->triangles().size(); ++triangle) {
            const auto& [a, b, c] = laid->triangles()[triangle];
            const Eigen::Vector3f middle =
                (film.positions[a] + film.positions[b] + film.positions[c]) / 3;
            if (contact.painted[triangle] && !holds(middle)) {
                return false;
            }
        }
        return true;
    }
};

constexpr double ballRadius = 35;
TriangleMesh ball() {
    return sphereMesh(ballRadius, 120, 240);
}

std::size_t middlePoint(const solver::FilmGrid& grid) {
    return std::size_t(grid.rows / 2) * std::size_t(grid.columns) + std::size_t(grid.columns / 2);
}

} // namespace

class FilmContactTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void filmContact_flatUnderBox_isOnItsBottom();
    void filmContact_onBall_isOnTheSurfaceNearTheFilm();
    void filmContact_atContactDistance_paintsTheBody();
    void filmContact_pastOverhang_isNotPainted();
    void filmContact_tornFilm_isNotPainted();
    void filmContact_singleMiss_isFilledFromItsNeighbours();
    void filmContact_freeFilmAtWaterline_isNotFilled();
    void filmContact_trappedFilm_isNotPainted();
    void filmContact_acrossAHollow_isNotPainted();
    void coverage_box_isItsBottom();
    void coverage_flushBoxes_isThatOfOneBox();
    void coverage_ball_isItsCap();
    void coverageTogether_twoFilms_isTheirUnion();
    void edgeIsOnBody_smallFilm_isTrue();
    void laidFilm_pastOverhang_endsEvenly_data();
    void laidFilm_pastOverhang_endsEvenly();
    void laidFilm_place_givesTheRestPosition();
    void laidFilmPlace_gradedFilm_equalsThatOfEvenFilm();
    void coverage_gradedFilm_equalsThatOfEvenFilm();
    void laidFilm_place_endsWithThePaint();
    void laidFilm_thinPlate_separatesItsSides();
    void filmContact_twice_givesTheSameBits();
};

void FilmContactTest::filmContact_flatUnderBox_isOnItsBottom() {
    const Located box(boxMesh({60, 30, 60}), test::flatUnderBox(test::a4Grid(), {60, 30, 60}));
    QCOMPARE(box.contact.contactCount, std::size_t(34 * 34));
    QCOMPARE(box.contact.filledCount, std::size_t(0));
    QCOMPARE(box.paintedCount(), std::size_t(2 * 33 * 33));
    for (std::size_t point = 0; point < box.film.positions.size(); ++point) {
        QCOMPARE(box.contact.surface[point].isValid(), box.film.adhered(point));
        if (box.film.adhered(point)) {
            QVERIFY((box.place(point) - box.film.positions[point]).norm() < 1e-4f);
        }
    }
}

void FilmContactTest::filmContact_onBall_isOnTheSurfaceNearTheFilm() {
    const Located globe(ball(), test::viscousOnSphere(test::a4Grid(), ballRadius, 1.8));
    QVERIFY(globe.contact.contactCount > 3000);
    for (std::size_t point = 0; point < globe.film.positions.size(); ++point) {
        if (globe.contact.surface[point].isValid()) {
            QVERIFY((globe.place(point) - globe.film.positions[point]).norm() < 0.02f);
        }
    }
}

void FilmContactTest::filmContact_atContactDistance_paintsTheBody() {
    DippedFilm film = test::flatUnderBox(test::a4Grid(), {60, 30, 60});
    for (Eigen::Vector3f& position : film.positions) {
        position.y() -= 2.5f;
    }
    const Located box(boxMesh({60, 30, 60}), film);
    QCOMPARE(box.paintedCount(), std::size_t(2 * 33 * 33));
    const std::optional<FilmPlace> place = box.placeAt({5, 0, -8});
    QVERIFY(place);
    QVERIFY((place->rest - Eigen::Vector2f(5, -8)).norm() < 1e-3f);
}

void FilmContactTest::filmContact_pastOverhang_isNotPainted() {
    const DippedFilm film = test::viscousOnSphere(test::a4Grid(), ballRadius, 2.6);
    for (const double overhang : {-10.0, 0.0, 20.0, 45.0}) {
        ProcessSettings process;
        process.overhang = Degrees(overhang);
        const Located globe(ball(), film, process);
        // A face that turns up by the overhang lies at this height above the equator.
        const double end = ballRadius * (1 + std::sin(radians(process.overhang)));
        QVERIFY(
            globe.allPainted([&](const Eigen::Vector3f& middle) { return middle.y() < end + 1; }));
        QVERIFY(!globe.allPainted(
            [&](const Eigen::Vector3f& middle) { return middle.y() < end - 2.5; }));
    }
}

void FilmContactTest::filmContact_tornFilm_isNotPainted() {
    DippedFilm film = test::flatUnderBox(test::a4Grid(), {60, 30, 60});
    // The point is drawn sideways: the cells to its left grow to 2.5 times their area.
    const std::size_t point = middlePoint(film.grid);
    film.positions[point].x() += 1.5f * float(film.grid.spacingX(0));
    ProcessSettings process;
    process.tearStretch = 2;
    const Located box(boxMesh({60, 30, 60}), film, process);
    int torn = 0;
    for (std::size_t triangle = 0; triangle < box.laid->triangles().size(); ++triangle) {
        const bool isTorn = box.laid->stretches()[triangle].isTorn(process.tearStretch);
        QVERIFY(!(isTorn && box.contact.painted[triangle]));
        torn += isTorn ? 1 : 0;
    }
    QVERIFY(torn > 0);
    // With the default limit nothing tears.
    const Located whole(boxMesh({60, 30, 60}), film);
    QCOMPARE(whole.paintedCount(), box.paintedCount() + std::size_t(torn));
}

void FilmContactTest::filmContact_singleMiss_isFilledFromItsNeighbours() {
    DippedFilm film = test::viscousOnSphere(test::a4Grid(), ballRadius, 1.5);
    const std::size_t point = middlePoint(film.grid) + 5;
    const Eigen::Vector3f place = film.positions[point];
    film.states[point] = solver::PointState::Free;
    film.positions[point].y() -= 3;
    const Located globe(ball(), film);
    QCOMPARE(globe.contact.filledCount, std::size_t(1));
    QVERIFY(globe.contact.surface[point].isValid());
    QVERIFY((globe.place(point) - place).norm() < 0.1f);
}

void FilmContactTest::filmContact_freeFilmAtWaterline_isNotFilled() {
    const Located globe(ball(), test::viscousOnSphere(test::a4Grid(), ballRadius, 1.0));
    QCOMPARE(globe.contact.filledCount, std::size_t(0));
    for (std::size_t point = 0; point < globe.film.positions.size(); ++point) {
        QCOMPARE(globe.contact.surface[point].isValid(), globe.film.adhered(point));
    }
}

void FilmContactTest::filmContact_trappedFilm_isNotPainted() {
    DippedFilm film = test::flatUnderBox(test::a4Grid(), {60, 30, 60});
    const std::size_t point = middlePoint(film.grid);
    film.states[point] = solver::PointState::Trapped;
    const Located box(boxMesh({60, 30, 60}), film);
    QVERIFY(!box.contact.surface[point].isValid());
    // The missing triangles are those that meet in the point: eight if it lies on the cells'
    // diagonals, otherwise four.
    const std::size_t missing = 2 * 33 * 33 - box.paintedCount();
    QVERIFY(missing == 4 || missing == 8);
}

void FilmContactTest::filmContact_acrossAHollow_isNotPainted() {
    // A roof turned upside down: two slopes that meet in a furrow along Z, seen from below.
    TriangleMesh gable;
    gable.positions = {{-30, 0, -30}, {0, 30, -30}, {30, 0, -30},
                       {-30, 0, 30},  {0, 30, 30},  {30, 0, 30}};
    gable.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
    DippedFilm film;
    film.grid = {31, 31, 60, 60};
    for (std::size_t point = 0; point < film.grid.pointCount(); ++point) {
        const Eigen::Vector2f rest = restPosition(film.grid, point) + Eigen::Vector2f(1, 0);
        film.positions.emplace_back(rest.x(), 30 - std::abs(rest.x()), rest.y());
        film.states.push_back(solver::PointState::Adhered);
    }
    const Located roof(gable, film);
    // The 2 mm cells across the furrow span it; their neighbours lie on the slopes.
    QVERIFY(roof.allPainted([](const Eigen::Vector3f& middle) {
        return std::abs(std::abs(middle.x()) + middle.y() - 30) < 0.3f;
    }));
    QVERIFY(roof.paintedCount() > 2 * 27 * 28);
}

void FilmContactTest::coverage_box_isItsBottom() {
    // The bottom is 34 film points wide, so that the film's cells end where it does.
    const solver::FilmGrid grid = test::a4Grid();
    const Eigen::Vector3d size(33 * grid.spacingX(0), 30, 33 * grid.spacingZ(0));
    const Located box(boxMesh(size), test::flatUnderBox(grid, size + Eigen::Vector3d(0.1, 0, 0.1)));
    const Coverage cover = coverage(*box.laid);
    const double bottom = size.x() * size.z();
    QVERIFY(std::abs(cover.paintedArea - bottom) < 0.01 * bottom);
    QVERIFY(std::abs(cover.share - bottom / surfaceArea(box.body.mesh)) < 0.005);
    QCOMPARE(cover.trappedAir.area, 0.0);
    for (std::size_t triangle = 0; triangle < cover.covered.size(); ++triangle) {
        const bool down = triangleNormal(box.body.mesh, triangle).y() < -0.5f;
        QCOMPARE(bool(cover.covered[triangle]), down);
    }
}

// The faces at which the two halves touch are no surface to paint.
void FilmContactTest::coverage_flushBoxes_isThatOfOneBox() {
    const solver::FilmGrid grid = test::a4Grid();
    const Eigen::Vector3d size(33 * grid.spacingX(0), 30, 33 * grid.spacingZ(0));
    const TriangleMesh whole = boxMesh(size);
    const TriangleMesh half = boxMesh({size.x() / 2, size.y(), size.z()});
    const auto shift = float(size.x() / 4);
    const TriangleMesh halves =
        test::joined(test::joined({}, half, {-shift, 0, 0}), half, {shift, 0, 0});
    const DippedFilm film = test::flatUnderBox(grid, size + Eigen::Vector3d(0.1, 0, 0.1));
    const Located box(halves, film);
    const Coverage cover = coverage(*box.laid);
    QVERIFY(surfaceArea(halves) > 1.1 * surfaceArea(whole));
    QVERIFY(std::abs(cover.unburied - surfaceArea(whole)) < 1);
    const double share = size.x() * size.z() / surfaceArea(whole);
    QVERIFY(std::abs(cover.share - share) < 0.005);
    QVERIFY(std::abs(coverageTogether({box.laid, box.laid}, {}) - share) < 0.005);
}

void FilmContactTest::coverage_ball_isItsCap() {
    const double end = 1.2;
    const Located globe(ball(), test::viscousOnSphere(test::a4Grid(), ballRadius, end));
    const Coverage cover = coverage(*globe.laid);
    // The film's last whole cells end up to one cell before the contact line. From there the film
    // is continued to the line.
    QVERIFY(std::abs(cover.share - (1 - std::cos(end)) / 2) < 0.001);
}

void FilmContactTest::coverageTogether_twoFilms_isTheirUnion() {
    const Located small(ball(), test::viscousOnSphere(test::a4Grid(), ballRadius, 0.8));
    const Located large(ball(), test::viscousOnSphere(test::a4Grid(), ballRadius, 1.2));
    const double both = coverageTogether({small.laid, large.laid}, {});
    QVERIFY(std::abs(both - coverage(*large.laid).share) < 0.002);
    Progress cancelled;
    cancelled.cancelToken.cancel();
    QVERIFY_EXCEPTION_THROWN(coverageTogether({small.laid, large.laid}, cancelled), Cancelled);
}

void FilmContactTest::edgeIsOnBody_smallFilm_isTrue() {
    const DippedFilm film = test::flatUnderBox({31, 31, 60, 60}, {50, 30, 50});
    QVERIFY(!edgeIsOnBody(*test::laid(boxMesh({50, 30, 50}), film)));
    const DippedFilm tooSmall = test::flatUnderBox({31, 31, 60, 60}, {70, 30, 70});
    QVERIFY(edgeIsOnBody(*test::laid(boxMesh({70, 30, 70}), tooSmall)));
}

void FilmContactTest::laidFilm_pastOverhang_endsEvenly_data() {
    QTest::addColumn<int>("rings");
    QTest::addColumn<double>("shortOfLimit");
    QTest::addColumn<double>("within");
    QTest::newRow("fine mesh") << 120 << 1.8 << 0.3;
    // Each flat face spans 9°. A face at the limit may turn up past it as a whole, although its
    // lower edge lies before the limit of an exact ball.
    QTest::newRow("coarse mesh") << 20 << 0.0 << 0.8;
}

void FilmContactTest::laidFilm_pastOverhang_endsEvenly() {
    QFETCH(int, rings);
    QFETCH(double, shortOfLimit); // mm along the ball from the last film points on it to the limit
    QFETCH(double, within);
    // Film points past the limit float above it.
    const ProcessSettings process;
    const double limit = pi / 2 + radians(process.overhang);
    DippedFilm film =
        test::viscousOnSphere(test::a4Grid(), ballRadius, limit - shortOfLimit / ballRadius);
    for (std::size_t point = 0; point < film.positions.size(); ++point) {
        if (!film.adhered(point)) {
            film.positions[point].y() = 2 * ballRadius + 2;
        }
    }
    const Located globe(sphereMesh(ballRadius, rings, 2 * rings), film);
    for (double turn = 0; turn < 2 * pi; turn += 0.01) {
        for (const double beside : {-within, within}) {
            const double angle = limit + beside / ballRadius;
            const Eigen::Vector3d place(std::sin(angle) * std::cos(turn), 1 - std::cos(angle),
                                        std::sin(angle) * std::sin(turn));
            const std::optional<FilmPlace> found =
                globe.placeAt((ballRadius * place).cast<float>());
            QCOMPARE(found.has_value(), beside < 0);
            if (found) {
                const double fromMiddle = 2 * ballRadius * std::sin(angle / 2);
                QVERIFY(std::abs(double(found->rest.norm()) - fromMiddle) < 0.3);
            }
        }
    }
}

void FilmContactTest::laidFilm_place_givesTheRestPosition() {
    const Located globe(ball(), test::viscousOnSphere(test::a4Grid(), ballRadius, 1.5));
    int found = 0;
    for (std::uint32_t triangle = 0; triangle < globe.body.mesh.triangles.size(); ++triangle) {
        const SurfacePoint middle = middleOf(triangle);
        const Eigen::Vector3f place = position(globe.body.mesh, middle);
        const double angle =
            std::atan2(std::hypot(place.x(), place.z()), ballRadius - double(place.y()));
        const std::optional<FilmPlace> covering = globe.laid->place(middle);
        QVERIFY(covering || angle > 1.5 - 3 / ballRadius);
        QVERIFY(!covering || angle < 1.5 + 0.1 / ballRadius);
        if (covering) {
            const Eigen::Vector2f direction = Eigen::Vector2f(place.x(), place.z()).normalized();
            const Eigen::Vector2f expected =
                float(2 * ballRadius * std::sin(angle / 2)) * direction;
            QVERIFY((covering->rest - expected).norm() < 0.06f);
            // The weights interpolate the rest positions of the triangle's corners.
            const Eigen::Vector3f weights = globe.laid->weights(*covering);
            const FilmTriangle& corners = globe.laid->triangles()[covering->triangle];
            Eigen::Vector2f back = Eigen::Vector2f::Zero();
            for (int corner = 0; corner < 3; ++corner) {
                QVERIFY(weights[corner] > -1e-3f && weights[corner] < 1 + 1e-3f);
                back +=
                    weights[corner] * restPosition(globe.film.grid, corners[std::size_t(corner)]);
            }
            QVERIFY((back - covering->rest).norm() < 1e-3f);
            ++found;
        }
    }
    QVERIFY(found > 10000);
}

void FilmContactTest::laidFilmPlace_gradedFilm_equalsThatOfEvenFilm() {
    const Eigen::Vector3d size(60, 30, 60);
    for (const solver::FilmGrid& grid : {test::a4Grid(), test::gradedA4Grid()}) {
        const Located box(boxMesh(size), test::flatUnderBox(grid, size));
        for (float x = -27; x <= 27; x += 1.7f) {
            for (float z = -27; z <= 27; z += 1.3f) {
                const std::optional<FilmPlace> place = box.placeAt({x, 0, z});
                QVERIFY(place);
                QVERIFY((place->rest - Eigen::Vector2f(x, z)).norm() < 2e-5f);
                Eigen::Vector2f rest = Eigen::Vector2f::Zero();
                const Eigen::Vector3f weights = box.laid->weights(*place);
                for (int corner = 0; corner < 3; ++corner) {
                    const auto point = box.laid->triangles()[place->triangle][std::size_t(corner)];
                    rest += weights[corner] * restPosition(grid, point);
                }
                QVERIFY((rest - place->rest).norm() < 2e-5f);
            }
        }
    }
}

void FilmContactTest::coverage_gradedFilm_equalsThatOfEvenFilm() {
    const Located even(ball(), test::viscousOnSphere(test::a4Grid(), ballRadius, 1.8));
    const Located graded(ball(), test::viscousOnSphere(test::gradedA4Grid(), ballRadius, 1.8));
    for (float angle = 0.05f; angle < 1.7f; angle += 0.05f) {
        for (float turn = 0; turn < 6.2f; turn += 0.3f) {
            const Eigen::Vector3f at(float(ballRadius) * std::sin(angle) * std::cos(turn),
                                     float(ballRadius) * (1 - std::cos(angle)),
                                     float(ballRadius) * std::sin(angle) * std::sin(turn));
            const auto one = even.placeAt(at), other = graded.placeAt(at);
            QVERIFY(one && other);
            // Both films interpolate over flat triangles, which are smaller in the graded film
            // here.
            QVERIFY((one->rest - other->rest).norm() < 0.03f);
        }
    }
    const double evenArea = coverage(*even.laid).paintedArea;
    QVERIFY(std::abs(coverage(*graded.laid).paintedArea / evenArea - 1) < 0.003);
}

void FilmContactTest::laidFilm_place_endsWithThePaint() {
    const Located box(boxMesh({60, 30, 60}), test::flatUnderBox(test::a4Grid(), {30, 30, 30}));
    const auto covers = [&](float x, float z) { return box.placeAt({x, 0, z}).has_value(); };
    // In each row, 18 points with 17 cells between them are on the bottom.
    const auto end = float(8.5 * box.film.grid.spacingX(0));
    QVERIFY(covers(end - 0.05f, 3));
    QVERIFY(covers(-end + 0.05f, -3));
    QVERIFY(!covers(end + 0.1f, 3));
    QVERIFY(!covers(-end - 0.1f, -3));
    QVERIFY(!covers(25, 25));
}

void FilmContactTest::laidFilm_thinPlate_separatesItsSides() {
    // A plate 0.2 mm thick, with film only below it.
    const Located plate(boxMesh({60, 0.2, 60}), test::flatUnderBox(test::a4Grid(), {60, 0.2, 60}));
    QVERIFY(plate.placeAt({5, 0, 5}));
    QVERIFY(!plate.placeAt({5, 0.2f, 5}));
}

void FilmContactTest::filmContact_twice_givesTheSameBits() {
    const DippedFilm film = test::viscousOnSphere(test::a4Grid(), ballRadius, 1.9);
    const Located one(ball(), film);
    const Located other(ball(), film);
    QVERIFY(one.contact.painted == other.contact.painted);
    for (std::size_t point = 0; point < film.positions.size(); ++point) {
        QCOMPARE(one.contact.surface[point].triangle, other.contact.surface[point].triangle);
        QCOMPARE(one.contact.surface[point].weights, other.contact.surface[point].weights);
    }
    const Coverage oneCover = coverage(*one.laid);
    const Coverage otherCover = coverage(*other.laid);
    QCOMPARE(oneCover.paintedArea, otherCover.paintedArea);
    QVERIFY(oneCover.covered == otherCover.covered);
}

QTEST_APPLESS_MAIN(FilmContactTest)
#include "FilmContactTest.moc"
