// Included by VTK's Qt widget on Windows for warnings that are of no concern here.
#pragma once
