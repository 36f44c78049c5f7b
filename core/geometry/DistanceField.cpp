#include "geometry/DistanceField.h"
