// Tests the paper's film on the CPU (docs/film-model.md, "The paper's model").

#include "paper/cpu/PaperFilm.h"

#include "TestFilm.h"
#include "WholeSample.h"
#include "common/BodyFrame.h"
#include "paper/reference/PlainPaperFilm.h"

#include <QTest>
#include <bit>
#include <limits>

using namespace dipwright;
using namespace dipwright::test;

namespace {

Ending dipped(const solver::DipSetup& setup, cpu::Arithmetic arithmetic = cpu::Arithmetic::Vector) {
    return dip(*cpu::makePaperFilm(arithmetic), setup);
}

bool haveSameBits(const Ending& a, const Ending& b) {
    return a.states == b.states &&
           std::equal(a.positions.begin(), a.positions.end(), b.positions.begin(),
                      b.positions.end(), [](float x, float y) {
                          return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
                      });
}

std::size_t pointIndex(const solver::FilmGrid& grid, int column, int row) {
    return std::size_t(row) * std::size_t(grid.columns) + std::size_t(column);
}

// Returns the largest stretch of all horizontal and vertical constraints.
double largestStretch(const Ending& end, const solver::FilmGrid& grid) {
    double largest = 0;
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const auto point = pointIndex(grid, column, row);
            if (column + 1 < grid.columns) {
                largest = std::max(largest, length(end.position(point + 1) - end.position(point)) /
                                                grid.spacingX(0));
            }
            if (row + 1 < grid.rows) {
                const auto below = point + std::size_t(grid.columns);
                largest = std::max(largest, length(end.position(below) - end.position(point)) /
                                                grid.spacingZ(0));
            }
        }
    }
    return largest;
}

std::size_t adheredCount(const Ending& end) {
    return std::size_t(
        std::count(end.states.begin(), end.states.end(), solver::PointState::Adhered));
}

} // namespace

class PaperFilmTest : public QObject {
    Q_OBJECT

private slots:
    void paperFilm_beforeContact_doesNotMove();
    void paperFilm_dip_agreesWithThePlainSolver_data();
    void paperFilm_dip_agreesWithThePlainSolver();
    void paperFilm_adheredPoints_areOnTheSurface();
    void paperFilm_adheredPoints_moveExactlyWithTheBody();
    void paperFilm_pinnedPoints_stay();
    void paperFilm_onWater_keepsFreePointsInThePlane();
    void paperFilm_anyNumberOfThreads_giveTheSameBits_data();
    void paperFilm_anyNumberOfThreads_giveTheSameBits();
    void paperFilm_scalarAndVector_giveTheSameBits_data();
    void paperFilm_scalarAndVector_giveTheSameBits();
    void paperFilm_gaussSeidel_convergesBetterThanJacobi();
    void paperFilm_selfContact_keepsPointsApart();
    void paperFilm_invalidSetup_isRefused();

private:
    static void addKindsOfFilm(bool all);
};

void PaperFilmTest::paperFilm_beforeContact_doesNotMove() {
    const SampledBody body = sphere(35, 64);
    const auto setup = paperDip(body, -35, 40, 57, 4, 5);
    const Ending end = dipped(setup);
    QVERIFY(end.progress.finished);
    QCOMPARE(adheredCount(end), std::size_t(0));
    for (int row = 0; row < setup.film.rows; ++row) {
        for (int column = 0; column < setup.film.columns; ++column) {
            const auto place = end.position(pointIndex(setup.film, column, row));
            QCOMPARE(float(place.x), float(-105 + column * setup.film.spacingX(0)));
            QCOMPARE(float(place.y), 0.0f);
            QCOMPARE(float(place.z), float(-148.5 + row * setup.film.spacingZ(0)));
        }
    }
}

void PaperFilmTest::paperFilm_dip_agreesWithThePlainSolver_data() {
    QTest::addColumn<solver::Lattice>("lattice");
    QTest::addColumn<double>("travel");
    QTest::newRow("the paper's lattice") << solver::Lattice::Structural << 25.0;
    QTest::newRow("with diagonals") << solver::Lattice::Isotropic << 12.0;
}

void PaperFilmTest::paperFilm_dip_agreesWithThePlainSolver() {
    QFETCH(solver::Lattice, lattice);
    QFETCH(double, travel);
    const SampledBody body = sphere(35, 96);
    auto setup = paperDip(body, -35, 31, 44, travel);
    setup.settings.lattice = lattice;
    reference::PlainPaperFilm plain(setup);
    plain.dip();
    const Ending end = dipped(setup);
    double farthest = 0;
    for (std::size_t point = 0; point < end.states.size(); ++point) {
        QCOMPARE(end.isAdhered(point), plain.isAdhered(point));
        farthest = std::max(farthest, length(end.position(point) - plain.position(point)));
    }
    qInfo("largest distance from the plain solver's points: %g mm", farthest);
    QVERIFY(farthest < 0.02);
}

void PaperFilmTest::paperFilm_adheredPoints_areOnTheSurface() {
    const SampledBody body = sphere(35, 96);
    auto setup = paperDip(body, -35, 61, 87, 30);
    setup.motion.rotation = {0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6};
    for (const double contactDistance : {0.0, 0.3}) {
        setup.settings.contactDistance = contactDistance;
        const Ending end = dipped(setup);
        QVERIFY(adheredCount(end) > 300);
        const numerics::Vector3<double> centre{0, setup.motion.start[1] - end.progress.descent, 0};
        for (std::size_t point = 0; point < end.states.size(); ++point) {
            if (end.isAdhered(point)) {
                const double off = length(end.position(point) - centre) - 35 - contactDistance;
                QVERIFY2(std::abs(off) < 0.1 * body.view.spacing,
                         qPrintable(QStringLiteral("%1 mm from the surface").arg(off)));
            }
        }
    }
}

void PaperFilmTest::paperFilm_adheredPoints_moveExactlyWithTheBody() {
    const SampledBody body = sphere(35, 64);
    const auto setup = paperDip(body, -35, 40, 57, 40);
    const auto film = cpu::makePaperFilm();
    film->begin(setup);
    const solver::DipState early = film->advance(120);
    const Ending before = ending(*film, setup.film);
    const solver::DipState late = film->advance(240);
    const Ending after = ending(*film, setup.film);
    QVERIFY(adheredCount(before) > 20);
    for (std::size_t point = 0; point < before.states.size(); ++point) {
        if (before.isAdhered(point)) {
            QVERIFY(after.isAdhered(point));
            QCOMPARE(after.positions[3 * point], before.positions[3 * point]);
            QCOMPARE(after.positions[3 * point + 2], before.positions[3 * point + 2]);
            const double sunk =
                double(before.positions[3 * point + 1]) - double(after.positions[3 * point + 1]);
            QVERIFY(std::abs(sunk - (late.descent - early.descent)) < 5e-6);
        }
    }
}

void PaperFilmTest::paperFilm_pinnedPoints_stay() {
    const SampledBody body = sphere(35, 64);
    auto setup = paperDip(body, -35, 40, 57, 30);
    setup.pinned.assign(setup.film.pointCount(), 0);
    for (std::size_t column = 0; column < 40; ++column) {
        setup.pinned[column] = 1; // the first row, at z = −148.5
    }
    const Ending end = dipped(setup);
    for (std::size_t column = 0; column < 40; ++column) {
        QCOMPARE(float(end.position(column).x), float(-105 + double(column) * 210 / 39));
        QCOMPARE(float(end.position(column).z), -148.5f);
    }
    QVERIFY(end.position(56 * 40 + 20).z < 148.4); // the free side is pulled inwards
}

void PaperFilmTest::paperFilm_onWater_keepsFreePointsInThePlane() {
    const SampledBody body = sphere(35, 64);
    auto setup = paperDip(body, -35, 40, 57, 30);
    setup.settings.support = solver::Support::Water;
    const Ending end = dipped(setup);
    for (std::size_t point = 0; point < end.states.size(); ++point) {
        QVERIFY(end.isAdhered(point) || end.position(point).y == 0);
    }
}

// Adds rows for all combinations of sweeps and film, or only for those that differ most.
void PaperFilmTest::addKindsOfFilm(bool all) {
    QTest::addColumn<solver::Relaxation>("relaxation");
    QTest::addColumn<solver::Lattice>("lattice");
    QTest::addColumn<int>("iterations");
    QTest::addColumn<bool>("selfContact");
    using solver::Lattice, solver::Relaxation;
    QTest::newRow("many sweeps") << Relaxation::Jacobi << Lattice::Structural << 19 << false;
    QTest::newRow("Gauss-Seidel, diagonals")
        << Relaxation::GaussSeidel << Lattice::Isotropic << 9 << false;
    QTest::newRow("self-contact") << Relaxation::Jacobi << Lattice::Structural << 5 << true;
    if (all) {
        QTest::newRow("Jacobi") << Relaxation::Jacobi << Lattice::Structural << 5 << false;
        QTest::newRow("diagonals") << Relaxation::Jacobi << Lattice::Isotropic << 5 << false;
        QTest::newRow("Gauss-Seidel")
            << Relaxation::GaussSeidel << Lattice::Structural << 5 << false;
    }
}

void PaperFilmTest::paperFilm_anyNumberOfThreads_giveTheSameBits() {
    QFETCH(solver::Relaxation, relaxation);
    QFETCH(solver::Lattice, lattice);
    QFETCH(int, iterations);
    QFETCH(bool, selfContact);
    const SampledBody body = sphere(35, 64);
    auto setup = paperDip(body, -35, 119, 171, 25);
    setup.settings.relaxation = relaxation;
    setup.settings.lattice = lattice;
    setup.settings.iterations = iterations;
    setup.settings.selfContact = selfContact;
    setup.settings.threads = 1;
    const Ending one = dipped(setup);
    QVERIFY(adheredCount(one) > 100);
    for (const int threads : {2, 2, 5}) {
        setup.settings.threads = threads;
        QVERIFY(haveSameBits(one, dipped(setup)));
    }
}

void PaperFilmTest::paperFilm_anyNumberOfThreads_giveTheSameBits_data() {
    addKindsOfFilm(isWholeRun());
}

void PaperFilmTest::paperFilm_scalarAndVector_giveTheSameBits_data() {
    addKindsOfFilm(true);
}

void PaperFilmTest::paperFilm_scalarAndVector_giveTheSameBits() {
    QFETCH(solver::Relaxation, relaxation);
    QFETCH(solver::Lattice, lattice);
    QFETCH(int, iterations);
    QFETCH(bool, selfContact);
    const SampledBody body = sphere(35, 64);
    auto setup = paperDip(body, -35, 61, 86, 25);
    setup.settings.relaxation = relaxation;
    setup.settings.lattice = lattice;
    setup.settings.iterations = iterations;
    setup.settings.selfContact = selfContact;
    QVERIFY(haveSameBits(dipped(setup, cpu::Arithmetic::Scalar), dipped(setup)));
}

void PaperFilmTest::paperFilm_gaussSeidel_convergesBetterThanJacobi() {
    const SampledBody body = sphere(35, 96);
    auto setup = paperDip(body, -35, 120, 170, 35);
    const double jacobi = largestStretch(dipped(setup), setup.film);
    setup.settings.relaxation = solver::Relaxation::GaussSeidel;
    const double gaussSeidel = largestStretch(dipped(setup), setup.film);
    qInfo("largest stretch: Jacobi %.3f, Gauss-Seidel %.3f", jacobi, gaussSeidel);
    QVERIFY(gaussSeidel > 1);
    QVERIFY(gaussSeidel - 1 < 0.7 * (jacobi - 1));
}

void PaperFilmTest::paperFilm_selfContact_keepsPointsApart() {
    // The film closes behind a small sphere that is dipped deep.
    const SampledBody body = sphere(20, 48);
    auto setup = paperDip(body, -20, 42, 59, 120);
    const double kept = std::min(setup.film.spacingX(0), setup.film.spacingZ(0)) / 2;
    const auto nearest = [&](const Ending& end) {
        double smallest = std::numeric_limits<double>::infinity();
        for (std::size_t a = 0; a < end.states.size(); ++a) {
            for (std::size_t b = a + 1; b < end.states.size(); ++b) {
                const auto columns = std::size_t(setup.film.columns);
                const auto apart = [](std::size_t m, std::size_t n) {
                    return m > n ? m - n : n - m;
                };
                const bool neighbours =
                    apart(a % columns, b % columns) <= 1 && apart(a / columns, b / columns) <= 1;
                if (!neighbours && !(end.isAdhered(a) && end.isAdhered(b))) {
                    smallest = std::min(smallest, length(end.position(a) - end.position(b)));
                }
            }
        }
        return smallest;
    };
    const double without = nearest(dipped(setup));
    setup.settings.selfContact = true;
    const double with = nearest(dipped(setup));
    qInfo("smallest distance of two points: %.3f mm without, %.3f mm with self-contact; required "
          "%.3f mm",
          without, with, kept);
    QVERIFY(without < 0.5 * kept);
    QVERIFY(with > 0.7 * kept);
}

void PaperFilmTest::paperFilm_invalidSetup_isRefused() {
    const SampledBody body = sphere(35, 16);
    const auto refused = [&](auto change) {
        auto setup = paperDip(body, -35, 10, 14, 1);
        change(setup);
        try {
            cpu::makePaperFilm()->begin(setup);
        } catch (const std::invalid_argument&) {
            return true;
        }
        return false;
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(!refused([](auto&) {}));
    QVERIFY(refused([](auto& setup) { setup.film.columns = 1; }));
    QVERIFY(refused([](auto& setup) { setup.film.rows = 100000; }));
    QVERIFY(refused([&](auto& setup) { setup.film.width = nan; }));
    QVERIFY(refused([](auto& setup) { setup.field.distance = nullptr; }));
    QVERIFY(refused([](auto& setup) { setup.motion.speed = 0; }));
    QVERIFY(refused([&](auto& setup) { setup.motion.travel = nan; }));
    QVERIFY(refused([](auto& setup) { setup.settings.timeStep = -1; }));
    QVERIFY(refused([](auto& setup) { setup.settings.iterations = 0; }));
    QVERIFY(refused([](auto& setup) { setup.pinned.resize(3); }));
    QVERIFY(refused([](auto& setup) { // a graded film
        solver::FilmGrid& film = setup.film;
        for (int column = 0; column < film.columns; ++column) {
            film.columnPlaces.push_back(film.width * (double(column) / (film.columns - 1) - 0.5));
        }
    }));
    QVERIFY(refused([](auto& setup) { setup.film.rowPlaces = {0, 1}; }));
    QVERIFY(refused([](auto& setup) { setup.settings.gripFade = 0; }));
    QVERIFY(refused([](auto& setup) { setup.settings.gatheringStretch = 0.5; }));
    QVERIFY(refused([](auto& setup) { setup.settings.growthLimit = -0.1; }));
    QVERIFY(refused([](auto& setup) {
        setup.settings.growthRate = 0.01;
        setup.settings.growthLimit = 0.2;
    }));
    QVERIFY(refused([](auto& setup) {
        setup.settings.lattice = solver::Lattice::Isotropic;
        setup.settings.support = solver::Support::Water;
    }));
}

QTEST_GUILESS_MAIN(PaperFilmTest)
#include "PaperFilmTest.moc"
