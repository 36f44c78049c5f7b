#include "dip/Dip.h"
