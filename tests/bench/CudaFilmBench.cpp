// Measures the films on the GPU: steps per second of the paper's film, seconds per dip of the
// production film, and how far the final points are from those on the CPU.
//
//   cuda_film_bench paper|production [batch=N] [dips=N] [steps=N] [stepsPerCell=N] [check]
//                   [elastic|viscous] [sphere|cone|FIELD] [COLUMNSxROWS …]
//
// stepsPerCell: of the production film; 2 (the default) as in new projects, 4 as in older ones.
// steps=N: at most N steps per dip. Meant for compute-sanitizer, under which a whole dip takes
// hours.
//
// FIELD: a file with the text "nx ny nz x y z spacing lowest height", a line break, and the samples
// as floats.

#include "Bench.h"
#include "BenchBody.h"
#include "paper/cpu/PaperFilm.h"
#include "paper/cuda/PaperDips.h"
#include "production/cpu/ProductionFilm.h"
#include "production/cuda/ProductionDips.h"
#include "solvers/TestFilm.h"

#include <limits>

using namespace dipwright;
using namespace dipwright::bench;
using namespace dipwright::test;

namespace {

struct Options {
    bool isProduction = false;
    int batch = 1;
    int dips = 5;
    int steps = std::numeric_limits<int>::max(); // largest number of steps per dip
    int stepsPerCell = usualStepsPerCell;        // of the production film
    bool checks = false;
    double relaxationTime = std::numeric_limits<double>::infinity();
    std::string body = "sphere";
    Sizes films;
};

Options parsed(int argc, char** argv) {
    Arguments arguments(argc, argv);
    Options options;
    options.batch = std::max(1, arguments.number("batch", options.batch));
    options.dips = std::max(1, arguments.number("dips", options.dips));
    options.steps = std::max(1, arguments.number("steps", options.steps));
    options.stepsPerCell = std::max(1, arguments.number("stepsPerCell", options.stepsPerCell));
    options.checks = arguments.take("check");
    options.isProduction = arguments.take("production");
    if (arguments.take("viscous")) {
        options.relaxationTime = 0;
    }
    options.films =
        arguments.takeSizes(options.isProduction ? Sizes{{120, 170}, {280, 396}} : tableOneFilms);
    for (const std::string& word : arguments.words()) {
        options.body = word == "paper" || word == "elastic" ? options.body : word;
    }
    return options;
}

Ending gpuEnding(const cuda::Dips& dips, std::size_t dip, const solver::FilmGrid& grid) {
    Ending end;
    end.positions.resize(3 * grid.pointCount());
    end.states.resize(grid.pointCount());
    dips.read(dip, end.positions, end.states);
    end.progress = dips.state(dip);
    return end;
}

void compare(const Ending& a, const Ending& b) {
    double largest = 0;
    std::size_t far = 0, differing = 0, adhered = 0;
    for (std::size_t point = 0; point < a.states.size(); ++point) {
        const double apart = length(a.position(point) - b.position(point));
        largest = std::max(largest, apart);
        far += apart > 0.02;
        differing += a.states[point] != b.states[point];
        adhered += a.isAdhered(point);
    }
    std::printf("    against the CPU: %.3g mm at most, %zu points past 0.02 mm, %zu of %zu adhered "
                "differ, steps %lld and %lld\n",
                largest, far, differing, adhered, (long long)a.progress.steps,
                (long long)b.progress.steps);
}

solver::DipSetup setupOf(const Options& options, const Body& body, int columns, int rows) {
    return options.isProduction
               ? productionDip(body, columns, rows, options.relaxationTime, options.stepsPerCell)
               : paperDip(body.sampled, body.lowest, columns, rows, body.height + 2.5);
}

void run(const cuda::Device& device, const Options& options, const Body& body, int columns,
         int rows) {
    const solver::DipSetup setup = setupOf(options, body, columns, rows);
    const std::vector<const solver::DipSetup*> setups(std::size_t(options.batch), &setup);
    const auto makeDips = options.isProduction ? cuda::makeProductionDips : cuda::makePaperDips;
    std::vector<double> seconds;
    Ending first;
    for (int dip = 0; dip < options.dips; ++dip) {
        const auto dips = makeDips(device, setups);
        const double all = secondsOf([&] {
            while (!dips->state(0).finished && dips->state(0).steps < options.steps) {
                dips->advance(std::min(options.steps, 256));
            }
        });
        seconds.push_back(all / options.batch);
        const Ending end = gpuEnding(*dips, setups.size() - 1, setup.film);
        if (dip == 0) {
            first = end;
        } else if (end.positions != first.positions || end.states != first.states) {
            std::printf("    not the same bits again\n");
        }
    }
    const Statistics dip = statistics(std::move(seconds));
    std::printf("%8d points: %.4f s a dip (%.4f … %.4f), %.0f steps/s\n", columns * rows,
                dip.median, dip.minimum, dip.maximum, double(first.progress.steps) / dip.median);
    if (options.checks) {
        const auto film = options.isProduction ? cpu::makeProductionFilm() : cpu::makePaperFilm();
        compare(first, test::dip(*film, setup));
    }
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    const Options options = parsed(argc, argv);
    const cuda::DeviceSearch search = cuda::findDevice();
    if (!search.found) {
        std::fprintf(stderr, "%s\n", search.reason.c_str());
        return 1;
    }
    std::printf("%s, %d multiprocessors\n", search.device.name.c_str(),
                search.device.multiprocessors);
    const Body body = bodyOf(options.body);
    for (const auto& [columns, rows] : options.films) {
        run(search.device, options, body, columns, rows);
    }
}
