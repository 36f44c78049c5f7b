// Converts the project's values to VTK's.
#pragma once

#include <Eigen/Geometry>
#include <QColor>
#include <QImage>
#include <vtkMatrix4x4.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

namespace dipwright {

vtkSmartPointer<vtkMatrix4x4> vtkMatrix(const Eigen::Isometry3d& transform);
// Picture row 0 is at texture coordinate v = 1, as in OBJ.
vtkSmartPointer<vtkTexture> vtkTextureOf(const QImage& picture);
std::array<double, 3> vtkColour(const QColor& colour);
std::array<unsigned char, 3> vtkBytes(QRgb colour);

} // namespace dipwright
