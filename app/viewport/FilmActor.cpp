#include "FilmActor.h"

#include "VtkConversions.h"

#include <algorithm>
#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

namespace dipwright {

FilmActor::FilmActor(vtkRenderer* renderer)
    : positions_(vtkSmartPointer<vtkFloatArray>::New()),
      normals_(vtkSmartPointer<vtkFloatArray>::New()), data_(vtkSmartPointer<vtkPolyData>::New()),
      actor_(vtkSmartPointer<vtkActor>::New()) {
    positions_->SetNumberOfComponents(3);
    normals_->SetNumberOfComponents(3);
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(data_);
    // Draws the film in front of the body's surface when both lie in the same place.
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(-1, -4);
    actor_->SetMapper(mapper);
    actor_->GetProperty()->SetSpecular(0.06);
    actor_->GetProperty()->SetSpecularPower(40);
    actor_->PickableOff();
    renderer->AddActor(actor_);
    cut_.setSurface(data_);
    cut_.line().VisibilityOff();
    renderer->AddActor(&cut_.line());
    setPixelRatio(1);
}

void FilmActor::setShape(const FilmShape& shape, std::span<const float> positions) {
    shape_ = shape;
    actor_->GetProperty()->SetAmbient(shape.isOnBody ? 0.15 : 0.74);
    actor_->GetProperty()->SetDiffuse(shape.isOnBody ? 0.85 : 0.36);
    drawn_.clear();
    data_->SetPolys(vtkSmartPointer<vtkCellArray>::New());
    const auto count = vtkIdType(shape.texture.size());
    positions_->SetNumberOfTuples(count);
    normals_->SetNumberOfTuples(count);
    auto texture = vtkSmartPointer<vtkFloatArray>::New();
    texture->SetNumberOfComponents(2);
    texture->SetNumberOfTuples(count);
    for (vtkIdType point = 0; point < count; ++point) {
        const Eigen::Vector2f& uv = shape.texture[std::size_t(point)];
        texture->SetTuple2(point, uv.x(), 1 - uv.y());
    }
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetData(positions_);
    data_->SetPoints(points);
    data_->GetPointData()->SetTCoords(texture);
    data_->GetPointData()->SetNormals(normals_);
    data_->GetPointData()->SetScalars(nullptr);
    actor_->SetTexture(picture_);
    setPositions(positions);
}

void FilmActor::setPositions(std::span<const float> positions) {
    std::copy(positions.begin(), positions.end(), positions_->GetPointer(0));
    updateTriangles();
    updateNormals();
    positions_->Modified();
    normals_->Modified();
    data_->GetPoints()->Modified();
    data_->Modified();
}

void FilmActor::updateTriangles() {
    const auto count = Eigen::Index(positions_->GetNumberOfTuples());
    const Eigen::Map<const Eigen::Matrix3Xf> points(positions_->GetPointer(0), 3, count);
    const auto isShort = [&](std::uint32_t a, std::uint32_t b) {
        return (points.col(a) - points.col(b)).squaredNorm() <=
               shape_.longestSide * shape_.longestSide;
    };
    std::vector<std::array<std::uint32_t, 3>> whole;
    whole.reserve(shape_.triangles.size());
    for (const auto& triangle : shape_.triangles) {
        const auto& [a, b, c] = triangle;
        if (isShort(a, b) && isShort(b, c) && isShort(c, a)) {
            whole.push_back(triangle);
        }
    }
    if (whole == drawn_) {
        return;
    }
    drawn_ = std::move(whole);
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->AllocateExact(vtkIdType(drawn_.size()), vtkIdType(drawn_.size() * 3));
    for (const auto& [a, b, c] : drawn_) {
        cells->InsertNextCell({vtkIdType(a), vtkIdType(b), vtkIdType(c)});
    }
    data_->SetPolys(cells);
}

void FilmActor::updateNormals() {
    const auto count = std::size_t(positions_->GetNumberOfTuples());
    using Points = Eigen::Map<Eigen::Matrix3Xf>;
    const Points points(positions_->GetPointer(0), 3, Eigen::Index(count));
    Points normals(normals_->GetPointer(0), 3, Eigen::Index(count));
    normals.setZero();
    for (const auto& [a, b, c] : drawn_) {
        const Eigen::Vector3f weighted =
            (points.col(b) - points.col(a)).cross(points.col(c) - points.col(a));
        normals.col(a) += weighted;
        normals.col(b) += weighted;
        normals.col(c) += weighted;
    }
    normals.colwise().normalize();
}

void FilmActor::setTransform(const Eigen::Isometry3d& filmToWorld) {
    actor_->SetUserMatrix(vtkMatrix(filmToWorld));
    cut_.setTransform(filmToWorld);
}

void FilmActor::setOpacity(double share) {
    actor_->GetProperty()->SetOpacity(share);
}

void FilmActor::setSection(const std::optional<SectionPlane>& section, vtkPlane* kept) {
    if (section) {
        cut_.setPlane(section->place * Eigen::Vector3d::Unit(section->axis),
                      section->inward().cast<double>());
    }
    cutOpen(*actor_, kept);
    cut_.line().SetVisibility(kept != nullptr);
}

void FilmActor::setCutColour(const QColor& colour) {
    cut_.line().GetProperty()->SetColor(vtkColour(colour).data());
}

void FilmActor::setPixelRatio(double ratio) {
    cut_.line().GetProperty()->SetLineWidth(float(3 * ratio));
}

void FilmActor::setPicture(const QImage& picture) {
    picture_ = picture.isNull() ? nullptr : vtkTextureOf(picture);
    if (picture_) {
        picture_->RepeatOff();
        picture_->EdgeClampOn();
    }
    data_->GetPointData()->SetScalars(nullptr);
    actor_->SetTexture(picture_);
}

void FilmActor::setPointColours(const std::vector<QRgb>& colours) {
    if (colours.empty()) {
        data_->GetPointData()->SetScalars(nullptr);
        actor_->SetTexture(picture_);
        return;
    }
    auto scalars = vtkSmartPointer<vtkUnsignedCharArray>::New();
    scalars->SetNumberOfComponents(3);
    scalars->SetNumberOfTuples(vtkIdType(colours.size()));
    for (std::size_t point = 0; point < colours.size(); ++point) {
        const std::array<unsigned char, 3> rgb = vtkBytes(colours[point]);
        scalars->SetTypedTuple(vtkIdType(point), rgb.data());
    }
    data_->GetPointData()->SetScalars(scalars);
    actor_->SetTexture(nullptr);
}

} // namespace dipwright
