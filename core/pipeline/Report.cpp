#include "pipeline/Report.h"

#include <QJsonArray>

namespace dipwright {
namespace {

QJsonObject toJson(const Distribution& distribution) {
    return {{"min", distribution.minimum},
            {"mean", distribution.mean},
            {"p95", distribution.percentile95},
            {"max", distribution.maximum}};
}

QJsonObject filmJson(const DippedFilm& film) {
    return {{"columns", film.grid.columns},
            {"rows", film.grid.rows},
            {"cell_mm", film.grid.leastSpacing()},
            {"points", qint64(film.grid.pointCount())},
            {"constraints", qint64(constraintCount(film.grid, film.isotropic))}};
}

QJsonObject immersionJson(const ImmersionResult& result) {
    const DippedFilm& film = result.laid->film();
    const FilmContact& contact = result.laid->contact();
    const PaintedStretch& painted = result.laid->painted();
    const Wrinkling& wrinkling = painted.wrinkling;
    const Registration& registration = result.registration;
    qint64 adhered = 0;
    for (std::size_t point = 0; point < film.states.size(); ++point) {
        adhered += film.adhered(point) ? 1 : 0;
    }
    const double seconds = film.wallSeconds;
    return {{"name", result.immersion.name},
            {"film", filmJson(film)},
            {"steps", qint64(film.steps)},
            {"wall_seconds", seconds},
            {"steps_per_second", seconds > 0 ? double(film.steps) / seconds : 0},
            {"equilibrium",
             QJsonObject{{"steps_without", qint64(film.equilibrium.stepsWithout)},
                         {"worst_force_left", film.equilibrium.worstForceLeft},
                         {"linear_iterations", qint64(film.equilibrium.linearIterations)}}},
            {"adhered", adhered},
            {"coverage", result.coverage->share},
            {"painted_area_mm2", result.coverage->paintedArea},
            {"trapped_air_area_mm2", result.coverage->trappedAirArea},
            {"stretch", toJson(distribution(painted.constraints))},
            {"area_stretch", toJson(distribution(painted.areas))},
            {"wrinkling", QJsonObject{{"film_area_mm2", wrinkling.area},
                                      {"share", wrinkling.share},
                                      {"least", wrinkling.least}}},
            {"texture", QJsonObject{{"contact", qint64(contact.contactCount)},
                                    {"filled", qint64(contact.filledCount)},
                                    {"seam_triangles", qint64(result.texture->seamTriangles)}}},
            {"registration_mm", QJsonObject{{"mean", registration.mean},
                                            {"p95", registration.percentile95},
                                            {"max", registration.maximum},
                                            {"samples", qint64(registration.samples)}}},
            {"ink", QJsonObject{{"shortfall_area", result.texture->shortfallArea}}},
            {"job", result.sheet.job.hash}};
}

} // namespace

QJsonObject report(const Project& project, const JobResult& result) {
    QJsonArray immersions;
    for (const ImmersionResult& immersion : result.immersions) {
        immersions.append(immersionJson(immersion));
    }
    return {{"version", 1},
            {"project", project.name},
            {"solver", QJsonObject{{"id", result.solver.id},
                                   {"device", result.solver.device},
                                   {"version", result.solver.version}}},
            {"immersions", immersions},
            {"coverage_total", result.coverageTotal},
            {"notes", QJsonArray::fromStringList(result.notes)}};
}

} // namespace dipwright
