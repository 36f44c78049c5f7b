#include "reduction/VtkSurface.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <utility>

namespace dipwright {

TriangleMesh meshOf(vtkPolyData& surface, bool flipped) {
    TriangleMesh mesh;
    for (vtkIdType i = 0; i < surface.GetNumberOfPoints(); ++i) {
        mesh.positions.push_back(
            Eigen::Map<const Eigen::Vector3d>(surface.GetPoint(i)).cast<float>());
    }
    const auto triangles = vtk::TakeSmartPointer(surface.GetPolys()->NewIterator());
    for (triangles->GoToFirstCell(); !triangles->IsDoneWithTraversal(); triangles->GoToNextCell()) {
        vtkIdType count = 0;
        const vtkIdType* corners = nullptr;
        triangles->GetCurrentCell(count, corners);
        auto& triangle = mesh.triangles.emplace_back(std::array{
            std::uint32_t(corners[0]), std::uint32_t(corners[1]), std::uint32_t(corners[2])});
        if (flipped) {
            std::swap(triangle[1], triangle[2]);
        }
    }
    return mesh;
}

vtkSmartPointer<vtkPolyData> polyDataOf(const TriangleMesh& mesh) {
    vtkNew<vtkPoints> points; // single precision
    points->SetNumberOfPoints(vtkIdType(mesh.positions.size()));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        points->SetPoint(vtkIdType(i), mesh.positions[i].cast<double>().eval().data());
    }
    vtkNew<vtkCellArray> triangles;
    for (const auto& [a, b, c] : mesh.triangles) {
        triangles->InsertNextCell({vtkIdType(a), vtkIdType(b), vtkIdType(c)});
    }
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    surface->SetPoints(points);
    surface->SetPolys(triangles);
    return surface;
}

} // namespace dipwright
