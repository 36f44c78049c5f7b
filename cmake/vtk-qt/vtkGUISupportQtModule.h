// What VTK's build would generate for its module GUISupportQt: export macros, empty in a static
// library.
#pragma once

#define VTKGUISUPPORTQT_EXPORT
#define VTKGUISUPPORTQT_NO_EXPORT
