// How certain a job's sheets are: how far they move when the same dips are computed more finely.
#pragma once

#include "pipeline/Pipeline.h"

namespace dipwright {

// How far, on the flat film, the places move that the places of the body take their colour from.
// mm, over points spread evenly over the body's surface that are painted both times.
struct SheetChange {
    double median = 0, percentile95 = 0, percentile99 = 0, maximum = 0;
    double painted = 0; // share of the body's surface that is painted both times
    // Of each point of the job's own film that is on the body; 0 of what is not, or where the finer
    // dip paints nothing.
    std::vector<float> points;
};

struct ImmersionCertainty {
    Immersion immersion;
    std::shared_ptr<const DippedFilm> film; // as the job computes it
    std::shared_ptr<const FilmContact> contact;
    SheetChange halfStep;    // steps half as long
    SheetChange halfSpacing; // film cells half as wide, and steps with them
};

// What a sheet that is computed finely enough moves by at most, 95 % of it; mm.
inline constexpr double certainHalfStep = 0.05;
inline constexpr double certainHalfSpacing = 0.15;

// Dips every immersion three times on the project's solver. Throws Error (no model, no such solver,
// no contact, a film that cannot have so many points) or Cancelled.
std::vector<ImmersionCertainty>
sheetCertainty(const Project& project, const SolverRegistry& registry, const Progress& progress);

// A sentence for each immersion that moves by more.
QStringList certaintyWarnings(const std::vector<ImmersionCertainty>& certainty);

// Where the sheet moves when the film's cells are half as wide.
QImage certaintyMap(const ImmersionCertainty& certainty);
// Writes the map of each immersion into `folder`, certainty-N.png; other files are left alone. All
// of them or none. Throws Error.
void writeCertaintyMaps(const std::vector<ImmersionCertainty>& certainty, const QString& folder);

QJsonObject certaintyJson(const std::vector<ImmersionCertainty>& certainty);

} // namespace dipwright
