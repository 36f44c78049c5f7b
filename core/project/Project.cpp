#include "project/Project.h"
