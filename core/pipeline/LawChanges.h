// Measures how much a job's sheets depend on the assumed film laws, by eight more dips for each
// immersion.
#pragma once

#include "accuracy/numericalError/LawChange.h"

namespace dipwright {

class CancelToken;
class LaidFilm;
struct Immersion;
struct PosedBody;

struct Project;
class DistanceField;

inline constexpr double lawVariation = 0.2; // of a law's value, to either side

// Repeats the dip of `own` as a batch, each law varied by lawVariation within the range of its
// setting. The laws are overhang, fading grip, tearing and gathering, in this order. Throws Error
// if the solver fails or a varied film does not follow the body. Throws Cancelled soon after
// `cancelToken` is cancelled.
std::vector<LawChange> lawChanges(const Project& project, const Immersion& immersion,
                                  const std::shared_ptr<const PosedBody>& body, const LaidFilm& own,
                                  const DistanceField& field, const solver::SolverModule& module,
                                  const CancelToken& cancelToken);

} // namespace dipwright
