#include "BodyActors.h"

#include "VtkConversions.h"
#include "base/Units.h"
#include "reduction/VtkSurface.h"

#include <cmath>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTrivialProducer.h>
#include <vtkUnsignedCharArray.h>

namespace dipwright {

namespace {

// The colour of the cut faces, visible on light and dark backgrounds.
const QColor sectionColour(0x9a, 0xa4, 0xae);

// Draws a patch just over the body, and each layer over the ones before it.
vtkSmartPointer<vtkActor> patchActor(vtkPolyData& data, std::size_t layer) {
    constexpr double perLayer = -4; // depth units
    const double units = perLayer * double(layer + 1);
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(&data);
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(units / 2, units);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetAmbient(0.35);
    actor->GetProperty()->SetDiffuse(0.65);
    return actor;
}

} // namespace

BodyActors::BodyActors(vtkRenderer* renderer)
    : renderer_(renderer), lineData_(vtkSmartPointer<vtkPolyData>::New()),
      lines_(vtkSmartPointer<vtkActor>::New()) {
    auto lines = vtkSmartPointer<vtkTrivialProducer>::New();
    lines->SetOutput(lineData_);
    showLines(*lines_, lines->GetOutputPort());
    for (std::size_t layer = 0; layer < patchLayers; ++layer) {
        patchData_[layer] = vtkSmartPointer<vtkPolyData>::New();
        patches_[layer] = patchActor(*patchData_[layer], layer);
    }
    setPixelRatio(1);
}

void BodyActors::setModel(std::shared_ptr<const TexturedMesh> model) {
    for (const Part& part : parts_) {
        renderer_->RemoveActor(part.actor);
    }
    parts_.clear();
    const std::initializer_list<vtkActor*> lines{
        &waterline_.line(), &section_.line(), &section_.area(), lines_, patches_[0], patches_[1]};
    for (vtkActor* line : lines) {
        renderer_->RemoveActor(line);
    }
    model_ = std::move(model);
    if (!model_) {
        return;
    }
    const auto normals = cornerNormals(model_->mesh);
    for (std::size_t material = 0; material < model_->materials.size(); ++material) {
        addPart(material, normals);
    }
    surface_ = polyDataOf(model_->mesh);
    waterline_.setSurface(surface_);
    section_.setSurface(surface_);
    for (vtkActor* line : lines) {
        renderer_->AddActor(line);
    }
    setTransform(modelToWorld_);
    setVisible(visible_);
}

void BodyActors::addPart(std::size_t material, const CornerNormals& normals) {
    Part part;
    for (std::size_t t = 0; t < model_->mesh.triangles.size(); ++t) {
        if (model_->material[t] == material) {
            part.triangles.push_back(std::uint32_t(t));
        }
    }
    if (part.triangles.empty()) {
        return;
    }
    const auto corners = 3 * vtkIdType(part.triangles.size());
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetNumberOfPoints(corners);
    auto shading = vtkSmartPointer<vtkFloatArray>::New();
    shading->SetNumberOfComponents(3);
    shading->SetNumberOfTuples(corners);
    auto texture = vtkSmartPointer<vtkFloatArray>::New();
    texture->SetNumberOfComponents(2);
    texture->SetNumberOfTuples(corners);
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    vtkIdType corner = 0;
    for (const std::uint32_t t : part.triangles) {
        cells->InsertNextCell({corner, corner + 1, corner + 2});
        for (std::size_t c = 0; c < 3; ++c, ++corner) {
            const Eigen::Vector3f& p = model_->mesh.positions[model_->mesh.triangles[t][c]];
            const Eigen::Vector3f& n = normals[t][c];
            Eigen::Vector2f uv = model_->textureCoordinates[t][c];
            if (!uv.allFinite()) {
                uv.setZero();
            }
            points->SetPoint(corner, p.x(), p.y(), p.z());
            shading->SetTuple3(corner, n.x(), n.y(), n.z());
            texture->SetTuple2(corner, uv.x(), uv.y());
        }
    }
    part.data = vtkSmartPointer<vtkPolyData>::New();
    part.data->SetPoints(points);
    part.data->SetPolys(cells);
    part.data->GetPointData()->SetNormals(shading);
    part.data->GetPointData()->SetTCoords(texture);

    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(part.data);
    part.actor = vtkSmartPointer<vtkActor>::New();
    part.actor->SetMapper(mapper);
    part.actor->GetProperty()->SetAmbient(0.15);
    part.actor->GetProperty()->SetDiffuse(0.85);
    part.actor->GetProperty()->SetSpecular(0.08);
    part.actor->GetProperty()->SetSpecularPower(25);
    part.colour = model_->materials[material].colour;
    const int picture = model_->materials[material].texture;
    if (picture >= 0) {
        part.texture = vtkTextureOf(model_->textures[std::size_t(picture)]);
        part.texture->RepeatOn();
    }
    applyOwnLook(part);
    renderer_->AddActor(part.actor);
    parts_.push_back(std::move(part));
}

void BodyActors::applyOwnLook(const Part& part) const {
    part.data->GetCellData()->SetScalars(nullptr);
    part.actor->SetTexture(part.texture);
    const QColor colour = part.texture ? QColor(Qt::white) : part.colour;
    part.actor->GetProperty()->SetColor(vtkColour(colour).data());
}

void BodyActors::setTriangleColours(const std::vector<QRgb>& colours) {
    for (const Part& part : parts_) {
        if (colours.empty()) {
            applyOwnLook(part);
            continue;
        }
        auto scalars = vtkSmartPointer<vtkUnsignedCharArray>::New();
        scalars->SetNumberOfComponents(3);
        scalars->SetNumberOfTuples(vtkIdType(part.triangles.size()));
        for (std::size_t entry = 0; entry < part.triangles.size(); ++entry) {
            const std::array<unsigned char, 3> rgb = vtkBytes(colours[part.triangles[entry]]);
            scalars->SetTypedTuple(vtkIdType(entry), rgb.data());
        }
        part.data->GetCellData()->SetScalars(scalars);
        part.actor->SetTexture(nullptr);
    }
}

void BodyActors::setLines(const std::vector<ViewLine>& lines) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    auto colours = vtkSmartPointer<vtkUnsignedCharArray>::New();
    colours->SetNumberOfComponents(3);
    for (const ViewLine& line : lines) {
        const auto first =
            points->InsertNextPoint(line.ends[0].x(), line.ends[0].y(), line.ends[0].z());
        points->InsertNextPoint(line.ends[1].x(), line.ends[1].y(), line.ends[1].z());
        cells->InsertNextCell({first, first + 1});
        const std::array<unsigned char, 3> rgb = vtkBytes(line.colour.rgb());
        colours->InsertNextTypedTuple(rgb.data());
    }
    lineData_->SetPoints(points);
    lineData_->SetLines(cells);
    lineData_->GetCellData()->SetScalars(colours);
}

void BodyActors::setPatch(PatchLayer layer, const ViewPatch& patch) {
    const auto index = std::size_t(layer);
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetNumberOfPoints(3 * vtkIdType(patch.triangles.size()));
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    vtkIdType corner = 0;
    for (const auto& triangle : patch.triangles) {
        cells->InsertNextCell({corner, corner + 1, corner + 2});
        for (const Eigen::Vector3f& place : triangle) {
            points->SetPoint(corner++, place.x(), place.y(), place.z());
        }
    }
    patchData_[index]->SetPoints(points);
    patchData_[index]->SetPolys(cells);
    patches_[index]->GetProperty()->SetColor(vtkColour(patch.colour).data());
    patches_[index]->GetProperty()->SetOpacity(patch.colour.alphaF());
}

void BodyActors::setTransform(const Eigen::Isometry3d& modelToWorld) {
    modelToWorld_ = modelToWorld;
    const auto matrix = vtkMatrix(modelToWorld);
    for (const Part& part : parts_) {
        part.actor->SetUserMatrix(matrix);
    }
    lines_->SetUserMatrix(matrix);
    for (const auto& patch : patches_) {
        patch->SetUserMatrix(matrix);
    }
    waterline_.setTransform(modelToWorld);
    section_.setTransform(modelToWorld);
}

void BodyActors::setVisible(bool visible) {
    visible_ = visible;
    for (const Part& part : parts_) {
        part.actor->SetVisibility(visible);
    }
    waterline_.line().SetVisibility(visible);
    lines_->SetVisibility(visible);
    for (const auto& patch : patches_) {
        patch->SetVisibility(visible);
    }
    showSection();
}

void BodyActors::setSection(const std::optional<SectionPlane>& section, vtkPlane* kept) {
    if (section) {
        const Eigen::Vector3d normal = section->inward().cast<double>();
        section_.setPlane(section->place * Eigen::Vector3d::Unit(section->axis), normal);
    }
    kept_ = kept;
    showSection();
}

void BodyActors::showSection() {
    for (const Part& part : parts_) {
        cutOpen(*part.actor, kept_);
    }
    cutOpen(waterline_.line(), kept_);
    cutOpen(*lines_, kept_);
    for (const auto& patch : patches_) {
        cutOpen(*patch, kept_);
    }
    section_.line().SetVisibility(visible_ && kept_);
    section_.area().SetVisibility(visible_ && kept_);
}

void BodyActors::setLineColours(const QColor& accent, const QColor& ink) {
    waterline_.line().GetProperty()->SetColor(vtkColour(accent).data());
    section_.line().GetProperty()->SetColor(vtkColour(ink).data());
    section_.area().GetProperty()->SetColor(vtkColour(sectionColour).data());
}

BoundingBox BodyActors::worldBox() const {
    BoundingBox box;
    if (model_) {
        const BoundingBox own = boundingBox(model_->mesh);
        for (int corner = 0; corner < 8; ++corner) {
            const Eigen::Vector3d point =
                own.corner(BoundingBox::CornerType(corner)).cast<double>();
            box.extend((modelToWorld_ * point).cast<float>());
        }
    }
    return box;
}

void BodyActors::setPixelRatio(double ratio) {
    for (vtkActor* line : {&waterline_.line(), &section_.line(), lines_.Get()}) {
        line->GetProperty()->SetLineWidth(float(2.5 * ratio));
    }
}

} // namespace dipwright
