#include "film/FilmSettings.h"
