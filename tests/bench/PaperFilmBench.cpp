// Steps per second of the paper's film: whole dips of the 70 mm sphere, 128³ field, 5 iterations.
//
//   paper_film_bench [jacobi|gauss-seidel] [scalar] [threads=N] [dips=N] [COLUMNSxROWS …]

#include "paper/cpu/PaperFilm.h"
#include "solvers/TestFilm.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <string_view>

using namespace dipwright;
using namespace dipwright::test;

namespace {

struct Options {
    solver::Relaxation relaxation = solver::Relaxation::Jacobi;
    cpu::Arithmetic arithmetic = cpu::Arithmetic::Vector;
    int threads = 0;
    int dips = 3;
    std::vector<std::pair<int, int>> films;
};

Options parsed(int argc, char** argv) {
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        int columns = 0, rows = 0;
        if (argument == "gauss-seidel") {
            options.relaxation = solver::Relaxation::GaussSeidel;
        } else if (argument == "scalar") {
            options.arithmetic = cpu::Arithmetic::Scalar;
        } else if (argument.starts_with("threads=")) {
            options.threads = std::atoi(argv[i] + 8);
        } else if (argument.starts_with("dips=")) {
            options.dips = std::max(1, std::atoi(argv[i] + 5));
        } else if (std::sscanf(argv[i], "%dx%d", &columns, &rows) == 2) {
            options.films.emplace_back(columns, rows);
        }
    }
    if (options.films.empty()) {
        options.films = {{8, 12},    {40, 60},   {80, 120},  {120, 180},
                         {160, 240}, {200, 300}, {240, 360}, {280, 420}};
    }
    return options;
}

struct Rate {
    double perSecond = 0;
    double perCoreSecond = 0; // of processor time: what a core would do that is not shared
};

Rate rate(solver::FilmSolver& film, const solver::DipSetup& setup) {
    film.begin(setup);
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t coreStart = std::clock();
    solver::DipState progress;
    while (!progress.finished) {
        progress = film.advance(64);
    }
    const double coreTime = double(std::clock() - coreStart) / CLOCKS_PER_SEC;
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    return {double(progress.steps) / time.count(), double(progress.steps) / coreTime};
}

} // namespace

int main(int argc, char** argv) {
    const Options options = parsed(argc, argv);
    const SampledBody body = sphere(35, 128);
    const bool isScalar = options.arithmetic == cpu::Arithmetic::Scalar;
    std::printf("%s\n%8s %12s %14s %10s %10s %18s\n",
                isScalar ? "scalar" : cpu::paperFilmInstructionSet().c_str(), "points",
                "constraints", "median step/s", "min", "max", "step/core-second");
    for (const auto& [columns, rows] : options.films) {
        solver::DipSetup setup = paperDip(body, -35, columns, rows, 72.5);
        setup.settings.relaxation = options.relaxation;
        setup.settings.threads = options.threads;
        const auto film = cpu::makePaperFilm(options.arithmetic);
        std::vector<Rate> rates;
        for (int dip = 0; dip < options.dips; ++dip) {
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
