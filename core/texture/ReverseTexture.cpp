#include "texture/ReverseTexture.h"
