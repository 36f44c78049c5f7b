// The films on the GPU: steps per second of the paper's film, whole dips of the production film,
// and how far they end from the CPU's.
//
//   cuda_film_bench [paper] [production] [batch=N] [dips=N] [check] [COLUMNSxROWS …]

#include "cpu/PaperFilm.h"
#include "cuda/Dips.h"
#include "solvers/TestFilm.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string_view>

using namespace dipwright;
using namespace dipwright::test;

namespace {

struct Options {
    int batch = 1;
    int dips = 5;
    bool checks = false;
    std::vector<std::pair<int, int>> films;
};

Options parsed(int argc, char** argv) {
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        int columns = 0, rows = 0;
        if (argument.starts_with("batch=")) {
            options.batch = std::max(1, std::atoi(argv[i] + 6));
        } else if (argument.starts_with("dips=")) {
            options.dips = std::max(1, std::atoi(argv[i] + 5));
        } else if (argument == "check") {
            options.checks = true;
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

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Ending gpuEnding(const cuda::Dips& dips, std::size_t dip, const solver::FilmGrid& grid) {
    Ending end;
    end.positions.resize(3 * grid.pointCount());
    end.states.resize(grid.pointCount());
    dips.read(dip, end.positions, end.states);
    end.progress = dips.progress(dip);
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

void runPaper(const cuda::Device& device, const Options& options) {
    const SampledBody body = sphere(35, 128);
    for (const auto& [columns, rows] : options.films) {
        const solver::DipSetup setup = paperDip(body, -35, columns, rows, 72.5);
        const std::vector<const solver::DipSetup*> setups(std::size_t(options.batch), &setup);
        std::vector<double> rates;
        Ending first;
        for (int dip = 0; dip < options.dips; ++dip) {
            const auto dips = cuda::makePaperDips(device, setups);
            const auto start = std::chrono::steady_clock::now();
            while (!dips->progress(0).finished) {
                dips->advance(256);
            }
            rates.push_back(options.batch * double(dips->progress(0).steps) / secondsSince(start));
            const Ending end = gpuEnding(*dips, setups.size() - 1, setup.film);
            if (dip == 0) {
                first = end;
            } else if (end.positions != first.positions) {
                std::printf("    not the same bits again\n");
            }
        }
        std::sort(rates.begin(), rates.end());
        std::printf("%10d %14.0f %14.0f %14.0f\n", columns * rows, rates[rates.size() / 2],
                    rates.front(), rates.back());
        if (options.checks) {
            compare(first, dip(*cpu::makePaperFilm(), setup));
        }
        std::fflush(stdout);
    }
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
    runPaper(search.device, options);
}
