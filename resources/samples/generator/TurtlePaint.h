// The turtle's colours, as a function of the place on it.
#pragma once

#include <Eigen/Core>
#include <QtGui/QRgb>

namespace dipwright::samples {

// The colour of a place on the level turtle's surface (TurtleShape.h), over all charts alike.
QRgb turtleColour(const Eigen::Vector3f& place);

} // namespace dipwright::samples
