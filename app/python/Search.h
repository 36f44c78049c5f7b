// Searches poses for Python. Private to this folder.
#pragma once

#include "python/Session.h"
#include "python/Values.h"
#include "search/PoseSearch.h"

#include <map>

namespace dipwright {

struct Project;

namespace python {

using Weights = std::map<QString, double>;
using Limits = std::map<QString, std::optional<double>>; // none removes a limit

// Searches with the project's aims, in which `weights` and `limits` replace single values.
// `progress` is as in runWork(). A cancelled search returns the best poses so far. Throws Error or
// Cancelled.
SearchResult searched(const Project& project, SearchSettings settings, const Weights& weights,
                      const Limits& limits, const QString& solver, const py::object& progress);

} // namespace python
} // namespace dipwright
