// Measures steps per second of the paper's film in whole dips: 70 mm sphere, 128³ field, 5
// iterations.
//
//   paper_film_bench [jacobi|gauss-seidel] [scalar] [threads=N] [dips=N] [COLUMNSxROWS …]

#include "Bench.h"
#include "paper/cpu/PaperFilm.h"
#include "solvers/TestFilm.h"

using namespace dipwright;
using namespace dipwright::bench;
using namespace dipwright::test;

namespace {

struct Rate {
    double perSecond = 0;
    // Steps per second of processor time, as if the film had a core to itself.
    double perCoreSecond = 0;
};

Rate rate(solver::FilmSolver& film, const solver::DipSetup& setup) {
    film.begin(setup);
    solver::DipState progress;
    const Elapsed time = elapsed([&] {
        while (!progress.finished) {
            progress = film.advance(64);
        }
    });
    return {double(progress.steps) / time.seconds, double(progress.steps) / time.processors};
}

} // namespace

int main(int argc, char** argv) {
    Arguments arguments(argc, argv);
    const bool isScalar = arguments.take("scalar"), isJacobi = !arguments.take("gauss-seidel");
    const int threads = arguments.number("threads", 0),
              dips = std::max(1, arguments.number("dips", 3));
    const SampledBody body = sphere(35, 128);
    std::printf("%s\n%8s %12s %14s %10s %10s %18s\n",
                isScalar ? "scalar" : cpu::paperFilmInstructionSet().c_str(), "points",
                "constraints", "median step/s", "min", "max", "step/core-second");
    for (const auto& [columns, rows] : arguments.takeSizes(tableOneFilms)) {
        solver::DipSetup setup = paperDip(body, -35, columns, rows, 72.5);
        setup.settings.relaxation =
            isJacobi ? solver::Relaxation::Jacobi : solver::Relaxation::GaussSeidel;
        setup.settings.threads = threads;
        const auto film =
            cpu::makePaperFilm(isScalar ? cpu::Arithmetic::Scalar : cpu::Arithmetic::Vector);
        std::vector<Rate> rates;
        for (int dip = 0; dip < dips; ++dip) {
            rates.push_back(rate(*film, setup));
        }
        std::sort(rates.begin(), rates.end(),
                  [](const Rate& a, const Rate& b) { return a.perSecond < b.perSecond; });
        const Rate& median = rates[rates.size() / 2];
        std::printf("%8d %12d %14.0f %10.0f %10.0f %18.0f\n", columns * rows,
                    columns * (rows - 1) + rows * (columns - 1), median.perSecond,
                    rates.front().perSecond, rates.back().perSecond, median.perCoreSecond);
        std::fflush(stdout);
    }
}
