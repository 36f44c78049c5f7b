// Runs long work for Python. Private to this folder.
#pragma once

#include <pybind11/pybind11.h>

#include "base/Progress.h"

#include <functional>

namespace dipwright::python {

namespace py = pybind11;

// Runs `work` on a thread of its own and waits for it without the GIL, so other threads of Python
// go on. Meanwhile calls `report`, which may be None, on the calling thread with the progress (0 …
// 1) and a text; a progress that is soon followed by another may be left out. `work` is cancelled
// if `report` returns False or throws, or if a signal arrives, such as Ctrl-C; then the exception
// of Python is thrown. Otherwise throws what `work` throws.
void runWork(const py::object& report, const std::function<void(const Progress&)>& work);

// Does the same and returns the result of `work`.
template <typename Work>
auto computed(const py::object& report, const Work& work) {
    std::optional<decltype(work(Progress()))> result;
    runWork(report, [&](const Progress& progress) { result = work(progress); });
    return std::move(*result);
}

} // namespace dipwright::python
