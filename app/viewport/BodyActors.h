// Draws the body in the view: one actor for each material, the waterline on the body, and the
// section through it.
#pragma once

#include "SectionPlane.h"
#include "SurfaceCut.h"
#include "ViewLine.h"
#include "ViewPatch.h"
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
    // Sets one colour for each triangle. If `colours` is empty, shows the model's own appearance.
    void setTriangleColours(const std::vector<QRgb>& colours);
    void setLines(const std::vector<ViewLine>& lines);
    void setPatch(PatchLayer layer, const ViewPatch& patch);
    void setVisible(bool visible);
    // `kept` is the section plane as a VTK object, or null.
    void setSection(const std::optional<SectionPlane>& section, vtkPlane* kept);
    void setLineColours(const QColor& accent, const QColor& ink);
    BoundingBox worldBox() const;     // empty if there is no body
    void setPixelRatio(double ratio); // screen pixels per window pixel

private:
    struct Part {
        std::vector<std::uint32_t> triangles;
        vtkSmartPointer<vtkPolyData> data;
        vtkSmartPointer<vtkActor> actor;
        vtkSmartPointer<vtkTexture> texture;
        QColor colour;
    };
    void addPart(std::size_t material, const CornerNormals& normals);
    void applyOwnLook(const Part& part) const;
    void showSection();

    vtkRenderer* renderer_;
    std::shared_ptr<const TexturedMesh> model_;
    Eigen::Isometry3d modelToWorld_ = Eigen::Isometry3d::Identity();
    std::vector<Part> parts_;
    vtkSmartPointer<vtkPolyData> surface_; // with merged vertices, for cutting
    SurfaceCut waterline_, section_;
    vtkSmartPointer<vtkPlane> kept_; // null: the body is not cut
    vtkSmartPointer<vtkPolyData> lineData_;
    vtkSmartPointer<vtkActor> lines_;
    std::array<vtkSmartPointer<vtkPolyData>, patchLayers> patchData_;
    std::array<vtkSmartPointer<vtkActor>, patchLayers> patches_;
    bool visible_ = true;
};

} // namespace dipwright
