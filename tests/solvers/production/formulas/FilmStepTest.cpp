// Tests how a step finds equilibrium. A spring at each point replaces the film's forces.

#include "production/formulas/FilmStep.h"

#include "production/formulas/HostFilm.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace dipwright;
using namespace dipwright::numerics;
using solver::PointMark;

namespace {

constexpr int columns = 5, rows = 4;

struct PlaneVector {
    using Real = double;
    std::vector<double> x, z;

    PlaneVector() = default;
    explicit PlaneVector(std::size_t points) : x(points), z(points) {}
};

// The force on a point at x, and the derivative of the force.
struct Spring {
    std::function<double(double)> force = [](double x) { return x; };
    std::function<double(double)> slope = [](double) { return 1.0; };
};

solver::DipSetup flatFilm() {
    solver::DipSetup setup;
    setup.film.columns = columns;
    setup.film.rows = rows;
    setup.film.width = columns - 1;
    setup.film.depth = rows - 1;
    setup.settings.residual = 1e-6;
    return setup;
}

// A film of springs. Its triangles exert no forces; they can only tear and fold.
class Springs : public HostFilm<PlaneVector> {
public:
    Springs() : HostFilm(flatFilm()), springs(columns * rows), held_(columns * rows) {}

    void place(int point, double x, double z) { setDisplacement(point, {x, z}); }
    bool isMarked(int point, solver::PointMark why) const {
        std::vector<std::uint8_t> marks(columns * rows);
        readMarks(marks);
        return solver::has(marks[std::size_t(point)], why);
    }
    int heldPoints() const { return int(std::ranges::count(free_, 0.f)); }

    static Matrix2<double> shape(int) { return {1, 0, 0, 1}; }
    static void setShape(int, const Matrix2<double>&) {}
    EdgePair<double> edges(int triangle) const {
        const TriangleCorners corners = triangleCorners(columns, std::size_t(triangle));
        const auto at = [&](int corner) {
            return planePosition(model(), corners.points[corner],
                                 displacement(int(corners.points[corner])));
        };
        const auto left = at(0), right = at(1), third = at(2), shared = at(corners.shared());
        const double up = corners.thirdAbove ? 1 : -1;
        return {right.x - left.x, right.z - left.z, up * (third.x - shared.x),
                up * (third.z - shared.z)};
    }
    bool triangleMoves(int triangle) const {
        const TriangleCorners corners = triangleCorners(columns, std::size_t(triangle));
        return std::ranges::any_of(corners.points,
                                   [&](std::uint32_t point) { return held_[point] == 0; });
    }

    template <typename Crosses, typename Unfold>
    LineState<double> findCrossing(const Crosses&, const Unfold&) {
        return {};
    }
    template <typename Work>
    void forCrossing(const Work&) {}
    template <typename OnLine, typename Floating>
    void forTriangles(const OnLine&, const Floating& floating) {
        for (int triangle = 0; triangle < triangleCount(model()); ++triangle) {
            floating(triangle);
        }
    }
    template <typename OnLine, typename Floating>
    void forStretched(double, const OnLine& onLine, const Floating& floating) {
        forTriangles(onLine, floating);
    }

    static constexpr NewtonLimits newtonLimits() { return {}; }
    void setFree() {
        ++timesSetFree;
        std::ranges::transform(free_, held_.begin(), [](float free) { return free > 0 ? 0 : 1; });
    }
    FilmForce force(double) {
        double squares = 0;
        forPoints([&](int point) { squares += forceOn(point).x * forceOn(point).x; });
        return {std::sqrt(squares), 1};
    }
    FilmForce forceAlong(double length, double drag) {
        forPoints([&](int point) {
            const auto k = std::size_t(point);
            displacement_.x[k] = start_.x[k] + length * step_.x[k];
        });
        return force(drag);
    }
    Vector2<double> forceOn(int point) const {
        const auto k = std::size_t(point);
        return {held_[k] ? 0 : springs[k].force(displacement_.x[k]), 0};
    }
    static void prepareLinear(double) {}
    void solveLinear(double drag, Tangent, double, double) {
        step_ = displacement_;
        forPoints([&](int point) {
            const auto k = std::size_t(point);
            step_.x[k] = -forceOn(point).x / (springs[k].slope(displacement_.x[k]) + drag);
        });
    }
    double startOfStep() {
        start_ = displacement_;
        return std::abs(*std::ranges::max_element(
            step_.x, [](double a, double b) { return std::abs(a) < std::abs(b); }));
    }
    void keepBest() { best_ = displacement_; }
    void takeBest() { displacement_ = best_; }

    std::vector<Spring> springs;
    int timesSetFree = 0;

private:
    std::vector<char> held_; // as at the last setFree()
    PlaneVector start_, step_, best_;
};
static_assert(FilmBackend<Springs>);

// Returns a spring with the same force everywhere. It has no equilibrium.
Spring restless(double force) {
    return {[force](double) { return force; }, [](double) { return 1.0; }};
}

} // namespace

class FilmStepTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void settle_filmConverges_holdsNoPoint();
    void settle_filmDoesNotConverge_isHeldAndMarked();
    void settle_foldedFilm_isHeldFirst();
    void settle_foldedFilmAtRest_isNotHeld();
    void holdTornOrFolded_tornFilm_isHeldAndMarked();
    void settle_tooManyDivergingPoints_givesUp();
    void enter_missedEquilibrium_isCounted();
};

void FilmStepTest::settle_filmConverges_holdsNoPoint() {
    Springs film;
    film.place(7, 0.2, 0);
    QVERIFY(detail::settle(film, 0, detail::farthestFromRest(film)).isReached);
    QCOMPARE(film.heldPoints(), 0);
    QCOMPARE(film.timesSetFree, 0);
    QVERIFY(std::abs(film.displacement(7).x) < 1e-6);
}

void FilmStepTest::settle_filmDoesNotConverge_isHeldAndMarked() {
    Springs film;
    film.springs[7] = restless(0.5);
    film.place(3, 0.3, 0);
    QVERIFY(detail::settle(film, 0, detail::farthestFromRest(film)).isReached);
    QCOMPARE(film.heldPoints(), 1);
    QVERIFY(!film.moves(7));
    QVERIFY(film.isMarked(7, PointMark::Unbalanced));
    QVERIFY(!film.isMarked(3, PointMark::Unbalanced));
    QVERIFY(std::abs(film.displacement(3).x) < 1e-6); // the other points converge
}

// If a corner lies past its opposite side, its triangles are held first. Only then is the point
// with the largest force held.
void FilmStepTest::settle_foldedFilm_isHeldFirst() {
    Springs film;
    film.springs[12] = restless(0.5);
    film.springs[2] = {[](double x) { return x - 0.1; }, [](double) { return 1.0; }};
    film.place(12, 0, 1.2); // past the next row, so triangles fold
    QVERIFY(detail::settle(film, 0, detail::farthestFromRest(film)).isReached);
    QVERIFY(!film.moves(12));
    QVERIFY(!film.moves(17));
    QVERIFY(film.isMarked(17, PointMark::Unbalanced) && !film.isMarked(17, PointMark::Torn));
    QVERIFY(film.moves(2));
    QVERIFY(std::abs(film.displacement(2).x - 0.1) < 1e-6);
}

void FilmStepTest::settle_foldedFilmAtRest_isNotHeld() {
    Springs film;
    film.place(12, 0, 1.2);
    QVERIFY(detail::settle(film, 0, detail::farthestFromRest(film)).isReached);
    QVERIFY(!detail::holdTornOrFolded(film, false));
    QCOMPARE(film.heldPoints(), 0);
}

void FilmStepTest::holdTornOrFolded_tornFilm_isHeldAndMarked() {
    Springs film;
    film.place(9, 9, 0); // stretched
    QVERIFY(detail::holdTornOrFolded(film, false));
    QVERIFY(!film.moves(9) && film.isMarked(9, PointMark::Torn));
    QVERIFY(film.moves(0) && !film.isMarked(0, PointMark::Torn));
}

// Each round holds the points with the largest forces. This film needs more rounds than the limit
// allows.
void FilmStepTest::settle_tooManyDivergingPoints_givesUp() {
    Springs film;
    for (int point = 0; point <= mostHolds; ++point) {
        film.springs[std::size_t(point)] = restless(std::pow(0.05, point));
    }
    const EquilibriumResult found = detail::settle(film, 0, detail::farthestFromRest(film));
    QCOMPARE(film.heldPoints(), mostHolds);
    QCOMPARE(film.timesSetFree, mostHolds);
    QVERIFY(film.moves(mostHolds));
    QVERIFY(!found.isReached);
    // This point is left without equilibrium.
    QVERIFY(film.isMarked(mostHolds, PointMark::Unbalanced));
    QVERIFY(!film.isMarked(mostHolds + 1, PointMark::Unbalanced));
    QCOMPARE(found.left, std::pow(0.05, mostHolds));
}

void FilmStepTest::enter_missedEquilibrium_isCounted() {
    solver::EquilibriumAccount account;
    detail::enter({0.5, true}, account);
    QCOMPARE(account.stepsWithout, std::int64_t(0));
    detail::enter({0.2, false}, account);
    detail::enter({0.1, false}, account);
    QCOMPARE(account.stepsWithout, std::int64_t(2));
    QCOMPARE(account.worstForceLeft, 0.2);
}

QTEST_GUILESS_MAIN(FilmStepTest)
#include "FilmStepTest.moc"
