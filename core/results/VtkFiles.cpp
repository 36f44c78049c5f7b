#include "results/Results.h"
