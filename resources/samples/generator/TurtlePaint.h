// Computes the turtle's colours from the place on it.
#pragma once

#include <Eigen/Core>
#include <QtGui/QRgb>

namespace dipwright::samples {

// Returns the colour of a place on the level turtle's surface (TurtleShape.h), independent of the
// charts.
QRgb turtleColour(const Eigen::Vector3f& place);

} // namespace dipwright::samples
