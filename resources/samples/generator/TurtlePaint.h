// Computes the turtle's colours from places on its surface.
#pragma once

#include <Eigen/Core>
#include <QtGui/QRgb>

namespace dipwright::samples {

// Returns the colour of a place on the surface of the turtle before bending (TurtleShape.h). It
// does not depend on the charts.
QRgb turtleColour(const Eigen::Vector3f& place);

} // namespace dipwright::samples
