// The module's own file on the disk. Private to this folder.
#pragma once

#include <QString>

namespace dipwright::python {

// Returns the path of the module's file; empty if the system does not tell it.
QString moduleFile();

} // namespace dipwright::python
