// Draws the film in the view. Its triangles are fixed; its points move.
#pragma once

#include "DipView.h"
#include "SurfaceCut.h"

#include <span>
#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

namespace dipwright {

class FilmActor {
public:
    explicit FilmActor(vtkRenderer* renderer);

    void setShape(const FilmShape& shape, std::span<const float> positions);
    void setPositions(std::span<const float> positions);
    void setTransform(const Eigen::Isometry3d& filmToWorld);
    void setPicture(const QImage& picture);
    void setPointColours(const std::vector<QRgb>& colours);
    void setOpacity(double share);
    // `kept` is the section plane as a VTK object, or null.
    void setSection(const std::optional<SectionPlane>& section, vtkPlane* kept);
    void setCutColour(const QColor& colour);
    void setPixelRatio(double ratio); // screen pixels per window pixel

private:
    void updateTriangles();
    void updateNormals();

    FilmShape shape_;
    std::vector<std::array<std::uint32_t, 3>> drawn_; // the triangles that are not torn
    vtkSmartPointer<vtkFloatArray> positions_;
    vtkSmartPointer<vtkFloatArray> normals_;
    vtkSmartPointer<vtkPolyData> data_;
    vtkSmartPointer<vtkActor> actor_;
    vtkSmartPointer<vtkTexture> picture_;
    SurfaceCut cut_;
};

} // namespace dipwright
