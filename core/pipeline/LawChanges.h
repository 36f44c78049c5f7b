// Measures how much a job's sheets depend on the assumed film laws. Simulates each dip eight more
// times.
#pragma once

#include "accuracy/error/LawChange.h"

namespace dipwright {

class CancelToken;
class LaidFilm;
struct Immersion;
struct PosedBody;

struct Project;
struct DistanceField;

inline constexpr double lawVariation = 0.2; // variation to either side, as a share of the value

// Repeats the dip of `own` as a batch of dips. In each dip, one law is varied by lawVariation
// within the range of its setting (an overhang of 0 by this share of the default). The laws are
// overhang, fading grip, tearing and gathering, in this order. Throws Error if the solver fails, or
// if a varied simulation becomes unstable. Throws Cancelled soon after `cancelToken` is cancelled.
std::vector<LawChange> lawChanges(const Project& project, const Immersion& immersion,
                                  const std::shared_ptr<const PosedBody>& body, const LaidFilm& own,
                                  const DistanceField& field, const solver::SolverModule& module,
                                  const CancelToken& cancelToken);

} // namespace dipwright
