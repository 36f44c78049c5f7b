#include "model/TexturedMesh.h"
