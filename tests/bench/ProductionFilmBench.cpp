// Measures whole dips of the production film on the CPU: wall time, processor time, and a number
// that changes with any bit of the film's final points.
//
//   production_film_bench [threads=N] [dips=N] [steps=N] [stepsPerCell=N] [elastic|viscous]
//                         [sphere|cone|FIELD] [COLUMNSxROWS …]
//
// stepsPerCell: 2 (the default) as in new projects, 4 as in older ones.
// steps=N: at most N steps per dip. FIELD: as in CudaFilmBench.cpp.

#include "Bench.h"
#include "BenchBody.h"
#include "production/cpu/ProductionFilm.h"
#include "solvers/TestFilm.h"

#include <bit>
#include <cstdint>
#include <limits>

using namespace dipwright;
using namespace dipwright::bench;
using namespace dipwright::test;

namespace {

// FNV-1a over the bits of all positions.
std::uint64_t hashOf(const Ending& end) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const float number : end.positions) {
        hash = (hash ^ std::bit_cast<std::uint32_t>(number)) * 0x100000001b3u;
    }
    return hash;
}

} // namespace

int main(int argc, char** argv) {
    Arguments arguments(argc, argv);
    const int threads = arguments.number("threads", 0),
              dips = std::max(1, arguments.number("dips", 3));
    const int steps = arguments.number("steps", std::numeric_limits<int>::max());
    const int stepsPerCell = std::max(1, arguments.number("stepsPerCell", usualStepsPerCell));
    const bool isViscous = arguments.take("viscous");
    arguments.take("elastic");
    const Sizes films = arguments.takeSizes({{120, 170}, {280, 396}});
    const Body body = bodyOf(arguments.words().empty() ? "sphere" : arguments.words().front());
    for (const auto& [columns, rows] : films) {
        solver::DipSetup setup =
            productionDip(body, columns, rows,
                          isViscous ? 0 : std::numeric_limits<double>::infinity(), stepsPerCell);
        setup.settings.threads = threads;
        const auto film = cpu::makeProductionFilm();
        for (int dip = 0; dip < dips; ++dip) {
            Ending end;
            const Elapsed time = elapsed([&] {
                film->begin(setup);
                solver::DipState state;
                while (!state.finished && state.steps < steps) {
                    state = film->advance(std::min(steps, 64));
                }
                end = ending(*film, setup.film);
                end.progress = state;
            });
            std::printf("%8d points: %.3f s, %.3f s of all processors, %lld steps, %lld linear "
                        "iterations, %016llx\n",
                        columns * rows, time.seconds, time.processors,
                        (long long)end.progress.steps,
                        (long long)end.progress.equilibrium.linearIterations,
                        (unsigned long long)hashOf(end));
            std::fflush(stdout);
        }
    }
}
