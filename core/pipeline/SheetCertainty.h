// How certain a job's sheets are: how far they move when the same dips are computed more finely.
#pragma once

#include "accuracy/certainty/SheetChange.h"
#include "base/Units.h"
#include "settings/Immersion.h"
#include "solver/SolverRegistry.h"

#include <QImage>
#include <QJsonObject>

namespace dipwright {

struct Project;
class LaidFilm;

struct ImmersionCertainty {
    Immersion immersion;
    SheetChange halfStep;    // steps half as long
    SheetChange halfSpacing; // film cells half as wide, and steps half as long with them
    // The same over what no mark of the film lies on (solver::PointMark): where it neither tore nor
    // was let go of.
    SheetChange unmarkedHalfStep, unmarkedHalfSpacing;
    std::shared_ptr<const LaidFilm> laid; // as the project has it
    std::vector<float> moves; // of its points in the latter, mm; NaN: paints in one dip only
    QStringList notes;        // sentences for the user, where another solver took over
};

// Where the film moves: certaintyMap() in Results.h.
QImage mapOf(const ImmersionCertainty& certainty, LengthUnit unit = LengthUnit::Millimetre);

// False where nothing is painted.
bool isCertain(const ImmersionCertainty& certainty);

// Dips every immersion three times, all on one solver: the project's or, where that needs a GPU
// that is missing or fails, the best on the CPU. From any thread; touches no file but the field
// cache; the maps need a QGuiApplication. Throws Error (no model, no such solver, no contact, a
// film that cannot have twice the points a side) or Cancelled.
std::vector<ImmersionCertainty>
sheetCertainty(const Project& project, const SolverRegistry& registry, const Progress& progress);

// Writes the maps into `folder`, certainty-N.png for immersion N, in place of those of an earlier
// check; other files are left alone. All of them or none (disk/FolderTransaction.h). Throws Error,
// and so does checkMapFolder where this could not be: worth asking before the work.
void checkMapFolder(const QString& folder);
void writeCertaintyMaps(const std::vector<ImmersionCertainty>& certainty, const QString& folder);

// {"version":1,"immersions":[{"name","certain","half_step":{"mean_mm","p95_mm","max_mm","painted",
// "painted_once"},"half_spacing":{…},"unmarked":{"half_step":{…},"half_spacing":{…}}}]}
QJsonObject certaintyJson(const std::vector<ImmersionCertainty>& certainty);

} // namespace dipwright
