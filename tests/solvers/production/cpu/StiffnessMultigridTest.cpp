// Tests what share of an error remains after a multigrid cycle, for flat film and for films with
// other stiffness: stretched, gathered, partly held.

#include "production/cpu/StiffnessMultigrid.h"

#include "parallel/Threads.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace dipwright;
using namespace dipwright::cpu;

namespace {

// A film of 1 mm cells with a displacement. Points whose `free` is 0 are held.
struct Film {
    Film(int columns, int rows)
        : setup(flat(columns, rows)), along(numerics::columnsOf<float>(setup.film)),
          down(numerics::rowsOf<float>(setup.film)),
          model(numerics::filmModel<float>(setup, along.lines(), down.lines())), plane(model),
          free(std::size_t(columns) * std::size_t(rows), 1.f), area(free.size(), 1.f),
          displacement(free.size()), multigrid(setup.film) {
        for (int row = 0; row < rows; ++row) { // the left and right sides
            free[at(0, row)] = free[at(columns - 1, row)] = 0;
        }
    }
    Film(const Film&) = delete; // the model points into the film's lines
    Film& operator=(const Film&) = delete;

    static solver::DipSetup flat(int columns, int rows) {
        solver::DipSetup setup;
        setup.film = {columns, rows, double(columns - 1), double(rows - 1)};
        return setup;
    }
    std::size_t at(int column, int row) const {
        return std::size_t(row) * std::size_t(plane.columns()) + std::size_t(column);
    }
    // Displaces the film so that its stretches along X and Z are a and d.
    void stretch(float a, float d) {
        for (int row = 0; row < plane.rows(); ++row) {
            for (int column = 0; column < plane.columns(); ++column) {
                displacement.x[at(column, row)] = (a - 1) * float(column);
                displacement.z[at(column, row)] = (d - 1) * float(row);
            }
        }
    }
    void prepare() {
        PlaneVector force(free.size());
        plane.setFree(free);
        plane.gradient(displacement, force, [](int) {});
        multigrid.prepare(plane, free, area, drag);
    }
    void hold(PlaneVector& v) const {
        for (std::size_t point = 0; point < free.size(); ++point) {
            v.x[point] *= free[point];
            v.z[point] *= free[point];
        }
    }
    PlaneVector random(unsigned seed) const {
        std::mt19937 engine(seed);
        std::uniform_real_distribution<float> number(-1, 1);
        PlaneVector v(free.size());
        std::ranges::generate(v.x, [&] { return number(engine); });
        std::ranges::generate(v.z, [&] { return number(engine); });
        hold(v);
        return v;
    }
    PlaneVector stiffnessTimes(const PlaneVector& v) const {
        PlaneVector force(free.size());
        plane.hessian(v, numerics::Tangent::Projected, force, [](int) {});
        for (std::size_t point = 0; point < free.size(); ++point) {
            force.x[point] += drag * v.x[point];
            force.z[point] += drag * v.z[point];
        }
        hold(force);
        return force;
    }
    PlaneVector cycle(const PlaneVector& right) {
        PlaneVector result(free.size());
        multigrid.apply(right, 1, result);
        return result;
    }

    static constexpr float drag = 1e-4f;
    solver::DipSetup setup;
    numerics::FilmLineValues<float> along, down;
    numerics::FilmModel<float> model;
    PlaneFilm plane;
    std::vector<float> free, area;
    PlaneVector displacement;
    StiffnessMultigrid multigrid;
};

double dot(const PlaneVector& a, const PlaneVector& b) {
    double sum = 0;
    for (std::size_t point = 0; point < a.size(); ++point) {
        sum += double(a.x[point]) * double(b.x[point]) + double(a.z[point]) * double(b.z[point]);
    }
    return sum;
}

// Returns the factor by which the last of eight cycles reduces an error. The size of an error is
// the square root of its elastic energy.
double reduction(Film& film) {
    film.prepare();
    PlaneVector error = film.random(1);
    double energy = 0, before = 0;
    for (int i = 0; i < 8; ++i) {
        before = energy;
        const PlaneVector correction = film.cycle(film.stiffnessTimes(error));
        for (std::size_t point = 0; point < error.size(); ++point) {
            error.x[point] -= correction.x[point];
            error.z[point] -= correction.z[point];
        }
        energy = dot(error, film.stiffnessTimes(error));
    }
    return std::sqrt(energy / before);
}

} // namespace

class StiffnessMultigridTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void cycle_flatFilm_reducesTheError_data();
    void cycle_flatFilm_reducesTheError();
    void cycle_stretchedFilm_reducesTheError();
    void cycle_gatheredFilm_reducesTheError();
    void cycle_heldFilm_reducesTheError();
    void cycle_isSymmetric();
    void cycle_mirroredForces_giveMirroredFilm();
    void cycle_heldPoints_stay();
    void cycle_anyNumberOfThreads_giveTheSameBits();
};

void StiffnessMultigridTest::cycle_flatFilm_reducesTheError_data() {
    QTest::addColumn<int>("columns");
    QTest::addColumn<int>("rows");
    QTest::newRow("odd") << 65 << 65;
    QTest::newRow("even") << 64 << 48;
    QTest::newRow("long") << 90 << 40;
    QTest::newRow("larger") << 257 << 200;
    QTest::newRow("smallest") << 3 << 3;
}

void StiffnessMultigridTest::cycle_flatFilm_reducesTheError() {
    QFETCH(int, columns);
    QFETCH(int, rows);
    Film film(columns, rows);
    const double left = reduction(film);
    qInfo("a cycle leaves the share %.3f of the error", left);
    QVERIFY(left < 0.4);
}

void StiffnessMultigridTest::cycle_stretchedFilm_reducesTheError() {
    Film film(65, 65);
    film.stretch(3, 1);
    const double left = reduction(film);
    qInfo("a cycle leaves the share %.3f of the error", left);
    QVERIFY(left < 0.6);
}

// In some directions gathered film has hardly any resistance, even with the semi-definite
// derivative.
void StiffnessMultigridTest::cycle_gatheredFilm_reducesTheError() {
    Film film(65, 65);
    film.stretch(0.7f, 0.8f);
    const double left = reduction(film);
    qInfo("a cycle leaves the share %.3f of the error", left);
    QVERIFY(left < 0.9);
}

// A disc in the film's middle and scattered points are held.
void StiffnessMultigridTest::cycle_heldFilm_reducesTheError() {
    Film film(65, 65);
    for (int row = 0; row < 65; ++row) {
        for (int column = 0; column < 65; ++column) {
            if (std::hypot(column - 32, row - 32) < 15 || (7 * column + 3 * row) % 53 == 0) {
                film.free[film.at(column, row)] = 0;
            }
        }
    }
    const double left = reduction(film);
    qInfo("a cycle leaves the share %.3f of the error", left);
    QVERIFY(left < 0.5);
}

void StiffnessMultigridTest::cycle_isSymmetric() {
    Film film(34, 27);
    film.stretch(1.4f, 0.9f);
    film.prepare();
    const PlaneVector a = film.random(1), b = film.random(2);
    const double first = dot(a, film.cycle(b)), second = dot(film.cycle(a), b);
    QVERIFY(std::abs(first - second) <
            1e-4 * std::sqrt(dot(a, film.cycle(a)) * dot(b, film.cycle(b))));
}

// The grid has a point in its middle, so that the diagonals of its cells are mirrored, too.
void StiffnessMultigridTest::cycle_mirroredForces_giveMirroredFilm() {
    Film film(33, 25);
    film.prepare();
    PlaneVector right = film.random(1);
    for (int row = 0; row < 25; ++row) {
        right.x[film.at(16, row)] = 0;
        for (int column = 0; column < 16; ++column) {
            right.x[film.at(32 - column, row)] = -right.x[film.at(column, row)];
            right.z[film.at(32 - column, row)] = right.z[film.at(column, row)];
        }
    }
    const PlaneVector way = film.cycle(right);
    for (int row = 0; row < 25; ++row) {
        for (int column = 0; column <= 16; ++column) {
            const std::size_t here = film.at(column, row), there = film.at(32 - column, row);
            QVERIFY(std::abs(way.x[here] + way.x[there]) < 1e-4f);
            QVERIFY(std::abs(way.z[here] - way.z[there]) < 1e-4f);
        }
    }
}

void StiffnessMultigridTest::cycle_heldPoints_stay() {
    Film film(20, 20);
    film.free[film.at(9, 9)] = 0;
    film.prepare();
    const PlaneVector way = film.cycle(film.random(1));
    for (std::size_t point = 0; point < film.free.size(); ++point) {
        QVERIFY(film.free[point] > 0 || (way.x[point] == 0 && way.z[point] == 0));
        QVERIFY(film.free[point] == 0 || way.x[point] != 0);
    }
}

void StiffnessMultigridTest::cycle_anyNumberOfThreads_giveTheSameBits() {
    PlaneVector first;
    for (const int threads : {1, 2, 5}) {
        ThreadTeam team(threads);
        team.run([&] {
            Film film(300, 200);
            film.stretch(1.2f, 0.9f);
            film.prepare();
            const PlaneVector way = film.cycle(film.random(1));
            if (threads == 1) {
                first = way;
            }
            QVERIFY(way.x == first.x && way.z == first.z);
        });
    }
}

QTEST_GUILESS_MAIN(StiffnessMultigridTest)
#include "StiffnessMultigridTest.moc"
