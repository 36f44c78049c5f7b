// Describes the film of each dip: its fineness, the expected time, and what was measured.
#pragma once

#include "geometry/SurfaceQuery.h"
#include "pipeline/JobResult.h"
#include "workbench/document/Preferences.h"

#include <memory>

namespace dipwright {

class FilmFacts {
public:
    // Returns one line for each dip and one line on measurements. The expected time is scaled from
    // `result`, the last run, which may be null. The time grows with the number of points and with
    // the number of steps; smaller cells need more steps.
    QString text(const Project& project, const JobResult* result, LengthUnit unit);

private:
    std::shared_ptr<const TexturedMesh> model_; // the model of `query_`
    std::unique_ptr<const SurfaceQuery> query_;
};

} // namespace dipwright
