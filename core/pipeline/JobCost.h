// Computes the cost and the time of a job.
#pragma once

#include "cost/OrderCost.h"
#include "pipeline/JobPacking.h"
#include "pipeline/JobResult.h"

namespace dipwright {

// Returns what an order costs; `parts` is the number of good parts. Sheets and motion come from the
// job. Prices and times come from `profiles`, which may be newer. `result` must not be a draft. If
// the sheets are packed on other films, `packed` holds them for racksOf() racks.
OrderCost jobCost(const JobResult& result, const ProjectProfiles& profiles, int parts,
                  const std::optional<FilmAmount>& packed = {});

// Returns the cost of one part and, if `project` asks for more parts, of its order. `result` may be
// older than prices and times of `project`.
std::vector<OrderCost> jobCosts(const JobResult& result, const Project& project);
// Returns the result with the prices, times and number of parts of `project`, for its files.
JobResult withCostsOf(JobResult result, const Project& project);
// Tells whether these costs are worth a sentence: there are prices, or several parts.
bool tellsCost(const std::vector<OrderCost>& costs);

// Returns how much film the packed sheets take. The price of a sheet is for a cut film of the size
// `sheet`, in mm; other films have no such price.
FilmAmount filmOf(const PackedFilms& films, QSizeF sheet);

} // namespace dipwright
