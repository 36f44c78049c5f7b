#include "pipeline/Pipeline.h"
