#include "solver/SolverRegistry.h"
