#include "geometry/SurfaceQuery.h"
