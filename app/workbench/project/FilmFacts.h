// How fine the film of each immersion will be, about how long its dip will take, and what of it was
// measured.
#pragma once

#include "geometry/SurfaceQuery.h"
#include "pipeline/JobResult.h"
#include "workbench/document/Preferences.h"

#include <memory>

namespace dipwright {

class FilmFacts {
public:
    // A line an immersion, and one on what was measured. The time is told from `result`, the last
    // run's, which may be null: work grows with the points and with the steps, which grow as the
    // cells get smaller.
    QString text(const Project& project, const JobResult* result, LengthUnit unit);

private:
    std::shared_ptr<const TexturedMesh> model_; // of which `query_` is
    std::unique_ptr<const SurfaceQuery> query_;
};

} // namespace dipwright
