// The tone curve that lightens a texture whose dark colours need more ink than the film can carry.
// It keeps colours apart that a plain limit would make equal (docs/ink-limits.md).
#pragma once

namespace dipwright {

// Returns the optical density that a colour of `density` gets. Densities up to a quarter of
// `densest` stay as they are. Above, a hyperbola of initial slope 1 leads to `densest` at
// `limit`, the ink limit. Strictly increasing up to the limit, constant above it. The identity if
// `densest` is not below `limit`. All values above 0.
float tonedDensity(float density, float densest, float limit);

} // namespace dipwright
