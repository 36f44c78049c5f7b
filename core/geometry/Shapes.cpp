#include "geometry/Shapes.h"
