// Converts the project's values to VTK objects.
#pragma once

#include <Eigen/Geometry>
#include <QColor>
#include <QImage>
#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

namespace dipwright {

vtkSmartPointer<vtkMatrix4x4> vtkMatrix(const Eigen::Isometry3d& transform);
// Returns the picture as a texture. As in OBJ, the picture's row 0 is at the texture coordinate v =
// 1.
vtkSmartPointer<vtkTexture> vtkTextureOf(const QImage& picture);
std::array<double, 3> vtkColour(const QColor& colour);
std::array<unsigned char, 3> vtkBytes(QRgb colour);

} // namespace dipwright
