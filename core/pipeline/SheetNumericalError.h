// Measures the numerical error of a job's sheets by repeating the dips with finer cells and steps.
#pragma once

#include "accuracy/error/SheetChange.h"
#include "base/Units.h"
#include "settings/Immersion.h"
#include "solver/SolverRegistry.h"

#include <QImage>
#include <QJsonObject>

namespace dipwright {

struct JobResult;
struct Project;
class LaidFilm;

// Returns a change as an object of report.json and of `validate --sheet --json`.
QJsonObject toJson(const SheetChange& change);

// The numerical error of one dip's sheet.
struct DipNumericalError {
    Immersion immersion;
    SheetChange halfStep;    // with steps half as long
    SheetChange halfSpacing; // with film cells and steps half as long
    // The same changes without marked film (solver::PointMark): torn, released or not converged.
    SheetChange unmarkedHalfStep, unmarkedHalfSpacing;
    std::shared_ptr<const LaidFilm> laid; // film with the project's settings
    // How far each point of `laid` moves with half the spacing, mm; NaN: only one dip paints it.
    std::vector<float> moves;
    QStringList notes; // sentences for the user if another solver took over
};

// Draws how far the film moves, by numericalErrorMap() in Results.h.
QImage mapOf(const DipNumericalError& numericalError, LengthUnit unit = LengthUnit::Millimetre);

// Tells whether both changes are within their limits; false if nothing is painted.
bool isAccurateEnough(const DipNumericalError& numericalError);

// Simulates each immersion three times with one solver: the project's, or the best CPU solver if
// the project's needs a GPU that is missing or fails. Films with automatic cells are first refined
// as for their sheets (FilmRefinement.h). If `known` is a result of this project, its cells are
// used instead. May be called from any thread; touches no file except the field cache; the maps
// need a QGuiApplication. Throws Cancelled. Throws Error if there is no model, no such solver, no
// contact, or too many film points with half the spacing.
std::vector<DipNumericalError> sheetNumericalError(const Project& project,
                                                   const SolverRegistry& registry,
                                                   const Progress& progress,
                                                   const JobResult* known = nullptr);

// Throws Error if the maps cannot be written into `folder`. Call it before the work begins.
void checkMapFolder(const QString& folder);
// Writes the maps into `folder` as certainty-N.png for immersion N. Replaces the maps of an earlier
// check, all or none (disk/FolderTransaction.h); other files stay. Throws Error.
void writeNumericalErrorMaps(const std::vector<DipNumericalError>& numericalError,
                             const QString& folder);

// {"version":1,"immersions":[{"name","certain","half_step":{"mean_mm","p95_mm","max_mm","painted",
// "painted_once"},"half_spacing":{…},"unmarked":{"half_step":{…},"half_spacing":{…}}}]}
QJsonObject numericalErrorJson(const std::vector<DipNumericalError>& numericalError);

} // namespace dipwright
