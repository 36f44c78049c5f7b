#include "model/ImportModel.h"
