// The pose search and the poses that it found.
#include "python/Values.h"

#include "pipeline/JobSearch.h"
#include "pipeline/SolverChoice.h"
#include "python/Bindings.h"
#include "python/Job.h"
#include "python/Search.h"
#include "python/Work.h"

namespace dipwright::python {
namespace {

void applyAims(PoseAims& aims, const Weights& weights, const Limits& limits) {
    for (const auto& [name, weight] : weights) {
        setWeight(aims, name, weight);
    }
    for (const auto& [name, limit] : limits) {
        setLimit(aims, name, limit);
    }
}

std::map<QString, double> measuresOf(const RankedPoses& poses) {
    std::map<QString, double> measures;
    for (const Measure measure : allMeasures()) {
        measures[measureKey(measure)] = poses.measures[measure];
    }
    return measures;
}

std::vector<Values> immersionsOf(const RankedPoses& poses) {
    std::vector<Values> immersions;
    for (const Immersion& immersion : poses.immersions) {
        immersions.push_back(immersionValues(immersion));
    }
    return immersions;
}

} // namespace

SearchResult searched(const Project& project, SearchSettings settings, const Weights& weights,
                      const Limits& limits, const QString& solver, const py::object& progress) {
    settings.aims = project.poseAims;
    applyAims(settings.aims, weights, limits);
    requireValid(settings);
    const SolverRegistry& registry = session();
    return computed(progress, [&](const Progress& reported) {
        SolverChoice choice = chooseSolver(solver.isEmpty() ? project.process.solver : solver,
                                           registry, reported.cancelToken);
        return withFallback(choice, registry, [&](const dipwright::solver::SolverModule& module) {
            return searchPoses(searchSubject(project, choice.solver.id), settings, module, {}, {},
                               reported);
        });
    });
}

void bindSearch(py::module_& module) {
    py::class_<RankedPoses>(module, "Poses", "One pose, or a pair of poses, that a search found.")
        .def_property_readonly("immersions", immersionsOf,
                               "The values of each dip by their paths, such as \"rotation_deg\"; "
                               "new() and\nJob.add_immersion() take them.")
        .def_readonly("objective", &RankedPoses::objective, "How good it is, 0 to 1.")
        .def_property_readonly("measures", measuresOf,
                               "Its measures: \"coverage\" … as in docs/pose-search.md. Shares are "
                               "0 to 1, lengths mm.")
        .def_property_readonly(
            "advice", [](const RankedPoses& poses) { return adviceKey(poses.advice()); },
            "The worst verdict on its dips and on all of them together; \"not_judged\" if not\n"
            "confirmed.")
        .def_readonly("confirmed", &RankedPoses::isConfirmed,
                      "Whether it was simulated with the job's own film.")
        .def_readonly("limits_missed", &RankedPoses::limitsMissed, "0 if all limits are kept.")
        .def_property_readonly(
            "tank_faults", [](const RankedPoses& poses) { return listOf(poses.tankFaults); },
            "Sentences on the limits of the tank that the dips exceed.")
        .def("__repr__", [](const RankedPoses& poses) {
            return QStringLiteral("<Poses: objective %1, coverage %2 %>")
                .arg(100 * poses.objective, 0, 'f', 2)
                .arg(100 * poses.measures[Measure::Coverage], 0, 'f', 1);
        });
    py::class_<SearchResult>(module, "Search", "The result of Job.search().")
        .def_readonly("ranking", &SearchResult::ranking, "All ranked poses, the best first.")
        .def_readonly("current", &SearchResult::current,
                      "The job's own poses, judged in the same way; None if they cannot be dipped.")
        .def_readonly("complete", &SearchResult::isComplete,
                      "False if the search was cancelled; the ranking is then the best so far.")
        .def("__repr__", [](const SearchResult& result) {
            return QStringLiteral("<Search: %1 ranked>").arg(result.ranking.size());
        });
}

} // namespace dipwright::python
