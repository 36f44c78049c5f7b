// The body in the view: an actor a material, the line in which the water meets it, and where it is
// cut open.
#pragma once

#include "SectionPlane.h"
#include "SurfaceCut.h"
#include "ViewLine.h"
#include "geometry/CornerNormals.h"
#include "model/TexturedMesh.h"

#include <QRgb>
#include <memory>
#include <vector>
#include <vtkActor.h>
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
    // `kept`: the plane as VTK has it, or null.
    void setSection(const std::optional<SectionPlane>& section, vtkPlane* kept);
    void setLineColours(const QColor& accent, const QColor& ink);
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
    void showSection();

    vtkRenderer* renderer_;
    std::shared_ptr<const TexturedMesh> model_;
    Eigen::Isometry3d modelToWorld_ = Eigen::Isometry3d::Identity();
    std::vector<Part> parts_;
    vtkSmartPointer<vtkPolyData> surface_; // welded, to be cut
    SurfaceCut waterline_, section_;
    vtkSmartPointer<vtkPlane> kept_; // null: the body is whole
    vtkSmartPointer<vtkPolyData> lineData_;
    vtkSmartPointer<vtkActor> lines_;
    bool visible_ = true;
};

} // namespace dipwright
