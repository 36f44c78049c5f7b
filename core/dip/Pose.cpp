#include "dip/Pose.h"
