// The films by which a search judges a dip as the job would judge it. The job can reuse them
// (pipeline/JobSearch.h).
#pragma once

#include "accuracy/error/NumericalErrorEstimate.h"
#include "accuracy/verdict/Verdict.h"

#include <memory>
#include <optional>

namespace dipwright {

struct JobFilms {
    std::shared_ptr<const LaidFilm> own;                 // never null
    std::shared_ptr<const CoarserFilms> coarser;         // never null
    std::shared_ptr<const NumericalErrorEstimate> error; // never null
    double refinement = 1; // of `own`, relative to the film with which the job begins
    // The refinement with which the job would repeat the dip; none: the job ends with this film.
    std::optional<double> next;
    Verdict verdict;          // by these films, on everything but the ink and torn film
    double tornBareShare = 0; // Coverage::tornBareShare()
};

} // namespace dipwright
