// Makes Python's objects for the parts of a result. Private to this folder.
#pragma once

#include "python/Bindings.h"

namespace dipwright::python {

py::object filmOf(const Dip& dip);
py::object bodyOf(const Dip& dip);
py::object sheetOf(const Dip& dip);
py::object certaintyOf(const Dip& dip); // None if it was not requested
py::object verdictOf(const Dip& dip);
py::object verdictOf(const Run& run);

} // namespace dipwright::python
