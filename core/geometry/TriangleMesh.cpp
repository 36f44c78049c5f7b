#include "geometry/TriangleMesh.h"
