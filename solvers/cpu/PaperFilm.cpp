#include "cpu/PaperFilm.h"
