// The Python module dipwright._dipwright, from which the package dipwright takes all names.
#include "python/Values.h"

#include "base/ProgramName.h"
#include "project/Samples.h"
#include "python/Bindings.h"
#include "python/Session.h"

namespace dipwright::python {
namespace {

void bindSolvers(py::module_& module) {
    py::class_<SolverInfo>(module, "Solver", "A solver plugin.")
        .def_readonly("id", &SolverInfo::id, "Its id, which Job.run() takes.")
        .def_readonly("name", &SolverInfo::name, "Its name.")
        .def_readonly("version", &SolverInfo::version, "Its version.")
        .def_readonly("device", &SolverInfo::device, "What it computes on.")
        .def_readonly("available", &SolverInfo::available, "Whether it can run here.")
        .def_readonly("reason", &SolverInfo::reason, "Why it cannot run here.")
        .def("__repr__",
             [](const SolverInfo& info) { return QStringLiteral("<Solver %1>").arg(info.id); });
    module.def(
        "solvers", [] { return session().solvers(); },
        "Lists the solver plugins, found where the command line finds them.");
    module.def(
        "samples",
        [] {
            session();
            return listOf(sampleProjects());
        },
        "Lists the files of the sample projects.");
}

// Classes tell Python the module's name when they are declared. They are used from the package.
void bindAll(py::module_& module) {
    const py::object ownName = module.attr("__name__");
    module.attr("__name__") = "dipwright";
    bindErrors(module);
    bindFilm(module);
    bindVerdict(module);
    bindSheet(module);
    bindResult(module);
    bindSearch(module);
    bindJob(module);
    bindSolvers(module);
    module.attr("__name__") = ownName;
}

} // namespace
} // namespace dipwright::python

PYBIND11_MODULE(_dipwright, module) {
    using namespace dipwright::python;
    module.attr("__version__") = dipwright::programVersion();
    bindAll(module);
    py::module_::import("atexit").attr("register")(py::cpp_function(endSession));
}
