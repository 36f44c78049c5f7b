// How much a job's sheets depend on the laws that no measurement stands behind: eight more dips an
// immersion, for who asks.
#pragma once

#include "accuracy/certainty/LawChange.h"

namespace dipwright {

class CancelToken;
class LaidFilm;
struct Immersion;
struct PosedBody;

struct Project;
class DistanceField;

inline constexpr double lawVariation = 0.2; // of a law's value, to either side

// Dips immersion `own` is of again, with each law varied as far as its setting goes, as a batch;
// overhang, fading grip, tearing and gathering, in this order. Throws Error when the solver fails
// or a varied film does not follow the body, Cancelled soon after `cancelToken`.
std::vector<LawChange> lawChanges(const Project& project, const Immersion& immersion,
                                  const std::shared_ptr<const PosedBody>& body, const LaidFilm& own,
                                  const DistanceField& field, const solver::SolverModule& module,
                                  const CancelToken& cancelToken);

} // namespace dipwright
