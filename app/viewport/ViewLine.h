// A line on the body in the 3D view.
#pragma once

#include <Eigen/Core>
#include <QColor>
#include <array>

namespace dipwright {

struct ViewLine {
    std::array<Eigen::Vector3f, 2> ends; // model coordinates, mm
    QColor colour;
};

} // namespace dipwright
