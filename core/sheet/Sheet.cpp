#include "sheet/Sheet.h"
