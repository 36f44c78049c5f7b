// How much the sheet changes with the film's grid and the solver's step: dips one body several
// times and compares, all over the body, where on the flat film its colour comes from.
//
//   sheet_convergence MODEL SIZE_MM [turned=X,Y,Z] COLUMNSxROWS,TRAVEL COLUMNSxROWS,TRAVEL …
//
// `turned` is the pose in degrees.
// TRAVEL is how many cells the contact line travels in one step. Each variant is compared with the
// first. "A4" is the film, 128³ the field.

#include "dip/Dip.h"
#include "dip/FilmOnBody.h"
#include "geometry/SurfaceSamples.h"
#include "model/ImportModel.h"
#include "solver/SolverRegistry.h"

#include <QGuiApplication>
#include <algorithm>
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
    Body(const TexturedMesh& model, const Immersion& held)
        : immersion(held), posed(posedBody(model, held)),
          field(buildDistanceField(model.mesh, 128, {})), query(posed.model.mesh),
          samples(evenSamples(posed.model.mesh, surfaceArea(posed.model.mesh) / samplesOfBody)) {}

    Immersion immersion;
    PosedBody posed;
    DistanceField field;
    SurfaceQuery query;
    std::vector<SurfacePoint> samples;
};

// Where on the flat film the colour of each sample comes from, where it is painted.
struct Sheet {
    std::vector<Eigen::Vector2f> places;
    std::vector<std::uint8_t> painted;
};

Sheet sheet(const Body& body, const Variant& variant, const solver::SolverModule& solver) {
    FilmSettings settings;
    settings.columns = variant.columns;
    settings.rows = variant.rows;
    ProcessSettings process;
    process.contactTravel = variant.travel;
    const DippedFilm film =
        simulateDip(body.posed, body.field, body.immersion, settings, process, solver, {}, {});
    std::printf("%d x %d, travel %g: %lld steps, %.1f s\n", variant.columns, variant.rows,
                variant.travel, static_cast<long long>(film.steps), film.wallSeconds);

    const FilmContact contact = locateFilm(film, body.posed, body.query, process);
    const FilmOnBody onBody(film, contact, body.posed);
    Sheet result;
    for (const SurfacePoint& sample : body.samples) {
        Eigen::Vector2f place = Eigen::Vector2f::Zero();
        std::uint32_t triangle = 0;
        result.painted.push_back(onBody.locate(sample, place, triangle));
        result.places.push_back(place);
    }
    return result;
}

void compare(const Body& body, const Sheet& first, const Sheet& other) {
    std::vector<std::pair<float, std::size_t>> changes;
    int both = 0, gained = 0, lost = 0;
    for (std::size_t i = 0; i < body.samples.size(); ++i) {
        both += first.painted[i] && other.painted[i] ? 1 : 0;
        gained += !first.painted[i] && other.painted[i] ? 1 : 0;
        lost += first.painted[i] && !other.painted[i] ? 1 : 0;
        if (first.painted[i] && other.painted[i]) {
            changes.emplace_back((first.places[i] - other.places[i]).norm(), i);
        }
    }
    std::sort(changes.begin(), changes.end());
    const auto percentile = [&](double share) {
        return changes[std::size_t(share * double(changes.size() - 1))].first;
    };
    const auto percent = [&](int count) { return 100.0 * count / double(body.samples.size()); };
    std::printf("  change of the sheet, mm: median %.4f, 95 %% %.4f, 99 %% %.4f, most %.3f; "
                "painted in both %.1f %%, only here %.2f %%, no longer here %.2f %%\n",
                percentile(0.5), percentile(0.95), percentile(0.99), percentile(1), percent(both),
                percent(gained), percent(lost));
    const std::size_t worst = changes.back().second;
    const Eigen::Vector3f place = position(body.posed.model.mesh, body.samples[worst]);
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
    const Body body(imported.model, immersion);
    const SolverRegistry registry({QStringLiteral(DIPWRIGHT_PLUGINS)});
    const solver::SolverModule& solver = registry.module(QStringLiteral("pbd-cpu"));
    std::unique_ptr<Sheet> first;
    for (int i = isTurned ? 4 : 3; i < argc; ++i) {
        Variant variant;
        if (std::sscanf(argv[i], "%dx%d,%lf", &variant.columns, &variant.rows, &variant.travel) !=
            3) {
            std::fprintf(stderr, "%s is not COLUMNSxROWS,TRAVEL\n", argv[i]);
            return 2;
        }
        const Sheet result = sheet(body, variant, solver);
        if (first) {
            compare(body, *first, result);
        } else {
            first = std::make_unique<Sheet>(result);
        }
        std::fflush(stdout);
    }
}
