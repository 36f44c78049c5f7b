// The cache of distance fields on disk. Private to this folder.
#pragma once

#include "geometry/DistanceField.h"

#include <functional>

namespace dipwright {

// Returns the field that the cache holds under this name. Otherwise builds the field, and stores it
// if it is not too large for the cache and the folder can be written. `name` must determine the
// field. Throws what `build` throws.
std::shared_ptr<DistanceField> fieldFromCache(const QString& name,
                                              const std::function<DistanceField()>& build);

} // namespace dipwright
