#include "cradle/FormSurface.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace dipwright {
namespace {

// Returns an image that refers to the form's values; they must outlive it.
vtkNew<vtkImageData> imageOf(const DistanceField& form) {
    vtkNew<vtkFloatArray> values;
    values->SetArray(const_cast<float*>(form.distance.data()), vtkIdType(form.distance.size()), 1);
    vtkNew<vtkImageData> image;
    image->SetDimensions(form.size[0], form.size[1], form.size[2]);
    image->SetSpacing(form.spacing, form.spacing, form.spacing);
    image->SetOrigin(form.origin.x(), form.origin.y(), form.origin.z());
    image->GetPointData()->SetScalars(values);
    return image;
}

TriangleMesh meshOf(vtkPolyData& surface) {
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
        // The filter expects higher values inside; here they are outside.
        mesh.triangles.push_back(
            {std::uint32_t(corners[0]), std::uint32_t(corners[2]), std::uint32_t(corners[1])});
    }
    return mesh;
}

} // namespace

TriangleMesh formSurface(const DistanceField& form) {
    vtkNew<vtkFlyingEdges3D> surface;
    surface->SetInputData(imageOf(form));
    surface->SetValue(0, 0);
    surface->ComputeNormalsOff();
    surface->ComputeScalarsOff();
    surface->Update();
    return meshOf(*surface->GetOutput());
}

} // namespace dipwright
