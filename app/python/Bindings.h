// The parts of the module. Each function declares one of them in Python. Private to this folder.
#pragma once

#include <pybind11/pybind11.h>

#include "pipeline/JobResult.h"

namespace dipwright::python {

namespace py = pybind11;

// A result in Python. Each Python object for a part of a result keeps the whole result alive.
struct Run {
    std::shared_ptr<const JobResult> result;
    QString projectFile; // empty if the project was never saved

    const JobResult& operator*() const { return *result; }
    const JobResult* operator->() const { return result.get(); }
};

// One dip of a result.
struct Dip {
    Run run;
    std::size_t number = 0; // counted from 0

    const ImmersionResult& operator*() const { return run->immersions[number]; }
    const ImmersionResult* operator->() const { return &run->immersions[number]; }
    // Keeps the result alive, for arrays that share its memory.
    std::shared_ptr<const void> owner() const { return run.result; }
};

void bindErrors(py::module_& module);
void bindFilm(py::module_& module);
void bindVerdict(py::module_& module);
void bindSheet(py::module_& module);
void bindResult(py::module_& module); // after film, verdict and sheet
void bindSearch(py::module_& module);
void bindJob(py::module_& module); // after result and search

} // namespace dipwright::python
