// Computes the line in which a world plane cuts a moving surface, and the area inside the line.
#pragma once

#include <Eigen/Geometry>
#include <vtkActor.h>
#include <vtkCutter.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace dipwright {

class SurfaceCut {
public:
    SurfaceCut();

    // Returns the line. It is drawn over the surface that it lies in.
    vtkActor& line() const { return *line_; }
    // Returns the area inside the line of a closed surface. It is invisible until it is shown.
    vtkActor& area() const { return *area_; }

    void setSurface(vtkPolyData* surface);
    void setTransform(const Eigen::Isometry3d& surfaceToWorld);
    // World coordinates.
    void setPlane(const Eigen::Vector3d& origin, const Eigen::Vector3d& normal);

private:
    void placePlane();

    Eigen::Isometry3d surfaceToWorld_ = Eigen::Isometry3d::Identity();
    Eigen::Vector3d origin_ = Eigen::Vector3d::Zero(), normal_ = Eigen::Vector3d::UnitY();
    vtkSmartPointer<vtkPlane> plane_; // in the surface's coordinates
    vtkSmartPointer<vtkCutter> cutter_;
    vtkSmartPointer<vtkActor> line_, area_;
};

// Draws lines over the surface in which they lie.
void showLines(vtkActor& actor, vtkAlgorithmOutput* lines);
// Draws only the side of `plane` to which its normal points; null draws everything.
void cutOpen(vtkActor& actor, vtkPlane* plane);

} // namespace dipwright
