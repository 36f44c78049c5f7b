// The body in the view: an actor a material, and the line in which the water meets it.
#pragma once

#include "ViewLine.h"
#include "geometry/CornerNormals.h"
#include "model/TexturedMesh.h"

#include <QRgb>
#include <memory>
#include <vector>
#include <vtkActor.h>
#include <vtkCutter.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace dipwright {

class BodyActors {
public:
    explicit BodyActors(vtkRenderer* renderer);

    void setModel(std::shared_ptr<const TexturedMesh> model);
    void setTransform(const Eigen::Isometry3d& modelToWorld);
    void setTriangleColours(const std::vector<QRgb>& colours); // empty: the model's own look
    void setLines(const std::vector<ViewLine>& lines);
    void setVisible(bool visible);
    void setWaterlineColour(const QColor& colour);
    BoundingBox worldBox() const;     // empty without a body
    void setPixelRatio(double ratio); // pixels of the screen to one of the window

private:
    struct Part {
        std::vector<std::uint32_t> triangles;
        vtkSmartPointer<vtkPolyData> data;
        vtkSmartPointer<vtkActor> actor;
        vtkSmartPointer<vtkTexture> texture;
        QColor colour;
    };
    void addPart(std::size_t material, const CornerNormals& normals);
    void wearOwnLook(const Part& part) const;

    vtkRenderer* renderer_;
    std::shared_ptr<const TexturedMesh> model_;
    Eigen::Isometry3d modelToWorld_ = Eigen::Isometry3d::Identity();
    std::vector<Part> parts_;
    vtkSmartPointer<vtkPolyData> surface_; // welded, for the waterline
    vtkSmartPointer<vtkPlane> waterPlane_;
    vtkSmartPointer<vtkCutter> waterCut_;
    vtkSmartPointer<vtkActor> waterline_;
    vtkSmartPointer<vtkPolyData> lineData_;
    vtkSmartPointer<vtkActor> lines_;
    bool visible_ = true;
};

} // namespace dipwright
