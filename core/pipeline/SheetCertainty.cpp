#include "pipeline/SheetCertainty.h"

#include "base/Error.h"
#include "base/Png.h"
#include "dip/FilmOnBody.h"
#include "geometry/SurfaceSamples.h"
#include "pipeline/ResultFolder.h"
#include "project/FilmSizes.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <algorithm>
#include <optional>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

constexpr double wantedSamples = 40'000; // of the body
constexpr int mapEdge = 1600;            // pixels

// Shares of the time of an immersion: the film of twice the points takes most of it.
constexpr double ownDone = 0.1;
constexpr double halfStepDone = 0.3;

struct HeldBody {
    HeldBody(const TexturedMesh& model, const Immersion& held)
        : immersion(held), posed(posedBody(model, held)), query(posed.model.mesh),
          samples(evenSamples(posed.model.mesh, surfaceArea(posed.model.mesh) / wantedSamples)) {}

    Immersion immersion;
    PosedBody posed;
    SurfaceQuery query;
    std::vector<SurfacePoint> samples;
};

class LaidFilm {
public:
    LaidFilm(DippedFilm dipped, const HeldBody& body, const ProcessSettings& process)
        : film_(std::make_shared<DippedFilm>(std::move(dipped))),
          contact_(
              std::make_shared<FilmContact>(locateFilm(*film_, body.posed, body.query, process))),
          onBody_(*film_, *contact_, body.posed) {}

    const std::shared_ptr<const DippedFilm>& film() const { return film_; }
    const std::shared_ptr<const FilmContact>& contact() const { return contact_; }

    // The place on the flat film that is over a place of the body, if any is.
    std::optional<Eigen::Vector2f> over(const SurfacePoint& point) const {
        Eigen::Vector2f place = Eigen::Vector2f::Zero();
        std::uint32_t triangle = 0;
        return onBody_.locate(point, place, triangle) ? std::optional(place) : std::nullopt;
    }

private:
    std::shared_ptr<const DippedFilm> film_;
    std::shared_ptr<const FilmContact> contact_;
    FilmOnBody onBody_;
};

Project withHalfStep(Project project) {
    project.process.contactTravel /= 2;
    project.process.timeStep = Seconds(project.process.timeStep.value() / 2);
    return project;
}

Project withHalfSpacing(Project project) {
    FilmSettings& film = project.film;
    film.columns = 2 * film.columns - 1;
    film.rows = 2 * film.rows - 1;
    if (std::max(film.columns, film.rows) > maximumFilmPoints ||
        film.columns * film.rows > maximumFilmGrid) {
        throw Error(Text::tr("The film would need %1 × %2 points to compare with, more than it may "
                             "have; give it fewer")
                        .arg(film.columns)
                        .arg(film.rows),
                    QStringLiteral("film.points"));
    }
    return project;
}

SheetChange change(const LaidFilm& own, const LaidFilm& finer, const HeldBody& body) {
    std::vector<double> distances;
    for (const SurfacePoint& sample : body.samples) {
        const auto before = own.over(sample);
        const auto after = finer.over(sample);
        if (before && after) {
            distances.push_back(double((*after - *before).norm()));
        }
    }
    SheetChange result;
    if (!distances.empty()) {
        std::sort(distances.begin(), distances.end());
        const auto below = [&](double share) {
            return distances[std::size_t(share * double(distances.size() - 1))];
        };
        result.median = below(0.5);
        result.percentile95 = below(0.95);
        result.percentile99 = below(0.99);
        result.maximum = below(1);
        result.painted = double(distances.size()) / double(body.samples.size());
    }
    const std::vector<SurfacePoint>& surface = own.contact()->surface;
    result.points.assign(surface.size(), 0);
    for (std::size_t point = 0; point < surface.size(); ++point) {
        if (surface[point].isValid()) {
            if (const auto after = finer.over(surface[point])) {
                result.points[point] = (*after - restPosition(own.film()->grid, point)).norm();
            }
        }
    }
    return result;
}

QJsonObject toJson(const SheetChange& change) {
    return {{"median_mm", change.median},
            {"p95_mm", change.percentile95},
            {"p99_mm", change.percentile99},
            {"max_mm", change.maximum},
            {"painted", change.painted}};
}

} // namespace

std::vector<ImmersionCertainty>
sheetCertainty(const Project& project, const SolverRegistry& registry, const Progress& progress) {
    if (!project.model) {
        throw Error(Text::tr("The project has no model, import one first"), project.name);
    }
    const Project halfStep = withHalfStep(project);
    const Project halfSpacing = withHalfSpacing(project);
    const solver::SolverModule& module = registry.module(project.process.solver);
    const auto field =
        cachedDistanceField(project.model->mesh, project.fieldResolution, progress.part(0, 0.02));
    std::vector<ImmersionCertainty> result;
    const double share = 0.98 / double(project.immersions.size());
    for (const Immersion& immersion : project.immersions) {
        const HeldBody body(*project.model, immersion);
        const double begin = 0.02 + share * double(result.size());
        const Progress part = progress.part(begin, begin + share);
        const auto laid = [&](const Project& job, double from, double to) {
            return LaidFilm(simulateDip(body.posed, *field, immersion, job.film, job.process,
                                        module, part.part(from, to), {}),
                            body, job.process);
        };
        const LaidFilm own = laid(project, 0, ownDone);
        ImmersionCertainty certainty{immersion, own.film(), own.contact(), {}, {}};
        certainty.halfStep = change(own, laid(halfStep, ownDone, halfStepDone), body);
        certainty.halfSpacing = change(own, laid(halfSpacing, halfStepDone, 1), body);
        result.push_back(std::move(certainty));
    }
    return result;
}

QStringList certaintyWarnings(const std::vector<ImmersionCertainty>& certainty) {
    QStringList warnings;
    for (const ImmersionCertainty& one : certainty) {
        if (one.halfStep.percentile95 > certainHalfStep ||
            one.halfSpacing.percentile95 > certainHalfSpacing) {
            warnings.append(
                Text::tr("%1: a twentieth of this sheet moves by more than %2 mm when it is "
                         "computed more finely; give the film more points, or turn the part")
                    .arg(one.immersion.name)
                    .arg(std::max(one.halfStep.percentile95, one.halfSpacing.percentile95), 0, 'f',
                         2));
        }
    }
    return warnings;
}

QImage certaintyMap(const ImmersionCertainty& certainty) {
    return certaintyMap(*certainty.film, *certainty.contact, certainty.halfSpacing.points, mapEdge);
}

void writeCertaintyMaps(const std::vector<ImmersionCertainty>& certainty, const QString& folder) {
    ResultFolder results(folder);
    QStringList names;
    for (const ImmersionCertainty& one : certainty) {
        const QString name = QStringLiteral("certainty-%1.png").arg(names.size() + 1);
        results.write(name, pngBytes(certaintyMap(one), name));
        names.append(name);
    }
    results.commit(names);
}

QJsonObject certaintyJson(const std::vector<ImmersionCertainty>& certainty) {
    QJsonArray immersions;
    for (const ImmersionCertainty& one : certainty) {
        immersions.append(QJsonObject{{"name", one.immersion.name},
                                      {"half_step", toJson(one.halfStep)},
                                      {"half_spacing", toJson(one.halfSpacing)}});
    }
    return {{"version", 1}, {"immersions", immersions}};
}

} // namespace dipwright
