// How much the sheet changes with the film's grid and the solver's step: dips one body several
// times and compares, all over the body, where on the flat film its colour comes from.
//
//   sheet_convergence MODEL SIZE_MM [turned=X,Y,Z] COLUMNSxROWS,TRAVEL COLUMNSxROWS,TRAVEL …
//
// `turned` is the pose in degrees.
// TRAVEL is how many cells the contact line travels in one step. Each variant is compared with the
// first. "A4" is the film, 128³ the field.

#include "cpu/QuasiStaticFilm.h"
#include "dip/FilmOnBody.h"
#include "model/ImportModel.h"
#include "pipeline/SurfaceSamples.h"

#include <QGuiApplication>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>

using namespace dipwright;

namespace {

constexpr int samplesOfBody = 40'000;

struct Variant {
    int columns = 0, rows = 0;
    double travel = 0;
};

struct Body {
    Immersion immersion;
    PosedBody posed;
    DistanceField field;
    SurfaceQuery query;
    std::vector<SurfaceSample> samples;
};

// Where on the flat film the colour of each sample comes from, where it is painted.
struct Sheet {
    std::vector<Eigen::Vector2f> places;
    std::vector<std::uint8_t> painted;
};

Sheet sheet(const Body& body, const Variant& variant) {
    FilmSettings settings;
    settings.columns = variant.columns;
    settings.rows = variant.rows;
    const ProcessSettings process;
    solver::DipSetup setup = dipSetup(body.posed, body.field, body.immersion, settings, process);
    setup.settings.contactTravel = variant.travel;

    const auto start = std::chrono::steady_clock::now();
    const std::unique_ptr<solver::FilmSolver> solver = cpu::makeQuasiStaticFilm();
    solver->begin(setup);
    solver::Progress progress;
    while (!progress.finished) {
        progress = solver->advance(16);
    }
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    std::printf("%d x %d, travel %g: %lld steps, %.1f s\n", variant.columns, variant.rows,
                variant.travel, static_cast<long long>(progress.steps), time.count());

    std::vector<float> positions(3 * setup.film.pointCount());
    DippedFilm film;
    film.grid = setup.film;
    film.states.resize(setup.film.pointCount());
    solver->read(positions, film.states);
    for (std::size_t point = 0; point < film.states.size(); ++point) {
        film.positions.emplace_back(
            positions[3 * point], positions[3 * point + 1] + float(progress.descent - startHeight),
            positions[3 * point + 2]);
    }
    const FilmContact contact = locateFilm(film, body.posed, body.query, process);
    const FilmOnBody onBody(film, contact, body.posed);
    Sheet result;
    for (const SurfaceSample& sample : body.samples) {
        Eigen::Vector2f place = Eigen::Vector2f::Zero();
        std::uint32_t triangle = 0;
        result.painted.push_back(onBody.locate(sample.point, place, triangle));
        result.places.push_back(place);
    }
    return result;
}

void compare(const Body& body, const Sheet& first, const Sheet& other) {
    std::vector<std::pair<float, std::size_t>> changes;
    double area = 0, both = 0, gained = 0, lost = 0;
    for (std::size_t i = 0; i < body.samples.size(); ++i) {
        const double share = body.samples[i].area;
        area += share;
        both += first.painted[i] && other.painted[i] ? share : 0;
        gained += !first.painted[i] && other.painted[i] ? share : 0;
        lost += first.painted[i] && !other.painted[i] ? share : 0;
        if (first.painted[i] && other.painted[i]) {
            changes.emplace_back((first.places[i] - other.places[i]).norm(), i);
        }
    }
    std::sort(changes.begin(), changes.end());
    const auto percentile = [&](double share) {
        return changes[std::size_t(share * double(changes.size() - 1))].first;
    };
    std::printf("  change of the sheet, mm: median %.4f, 95 %% %.4f, 99 %% %.4f, most %.3f; "
                "painted in both %.1f %%, only here %.2f %%, no longer here %.2f %%\n",
                percentile(0.5), percentile(0.95), percentile(0.99), percentile(1),
                100 * both / area, 100 * gained / area, 100 * lost / area);
    const std::size_t worst = changes.back().second;
    const Eigen::Vector3f place = position(body.posed.model.mesh, body.samples[worst].point);
    std::printf("  most at %.1f %.1f %.1f\n", place.x(), place.y(), place.z());
}

} // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication application(argc, argv);
    if (argc < 5) {
        std::fprintf(stderr, "sheet_convergence MODEL SIZE_MM COLUMNSxROWS,TRAVEL …\n");
        return 2;
    }
    ImportOptions options;
    options.longestEdge = Millimetres(std::atof(argv[2]));
    const ImportedModel imported = importModel(QString::fromLocal8Bit(argv[1]), options, {});
    Immersion immersion;
    double x = 0, y = 0, z = 0;
    const bool isTurned = std::sscanf(argv[3], "turned=%lf,%lf,%lf", &x, &y, &z) == 3;
    immersion.rotation = {Degrees(x), Degrees(y), Degrees(z)};
    Body body{immersion,
              posedBody(imported.model, immersion),
              buildDistanceField(imported.model.mesh, 128, {}),
              SurfaceQuery(posedBody(imported.model, immersion).model.mesh),
              {}};
    body.samples = spreadOverSurface(body.posed.model.mesh, samplesOfBody);
    std::unique_ptr<Sheet> first;
    for (int i = isTurned ? 4 : 3; i < argc; ++i) {
        Variant variant;
        if (std::sscanf(argv[i], "%dx%d,%lf", &variant.columns, &variant.rows, &variant.travel) !=
            3) {
            std::fprintf(stderr, "%s is not COLUMNSxROWS,TRAVEL\n", argv[i]);
            return 2;
        }
        const Sheet result = sheet(body, variant);
        if (first) {
            compare(body, *first, result);
        } else {
            first = std::make_unique<Sheet>(result);
        }
        std::fflush(stdout);
    }
}
