#include "film/DippedFilm.h"
