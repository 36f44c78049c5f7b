#include "dip/Coverage.h"
