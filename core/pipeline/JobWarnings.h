// Finds the places of a job's part that the user should look at: pieces of the surface in trapped
// air, painted by marked film (dip/FilmMarks.h), reached by neither of two dips, or too pale
// because the ink limit does not allow enough ink.
#pragma once

#include "pipeline/JobResult.h"

namespace dipwright {

enum class WarningKind { TrappedAir, NotReached, Torn, Unbalanced, Released, TooPale };

// A connected piece of the surface. `place` is on it, near its middle, and `outward` is the
// surface's normal there; model coordinates, mm.
struct JobWarning {
    WarningKind kind = WarningKind::TrappedAir;
    std::optional<std::size_t> dip; // none: about all dips together
    Eigen::Vector3f place = Eigen::Vector3f::Zero(), outward = Eigen::Vector3f::UnitY();
    double area = 0; // mm²
};

// Returns the largest pieces of each kind and dip, at least 2 mm² each, without masked surface; the
// kinds in their order, larger pieces first. Uses all cores; deterministic.
std::vector<JobWarning> jobWarnings(const JobResult& result);

} // namespace dipwright
