#include "cradle/FormSurface.h"

#include "reduction/VtkSurface.h"

#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

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

} // namespace

TriangleMesh formSurface(const DistanceField& form) {
    vtkNew<vtkFlyingEdges3D> surface;
    surface->SetInputData(imageOf(form));
    surface->SetValue(0, 0);
    surface->ComputeNormalsOff();
    surface->ComputeScalarsOff();
    surface->Update();
    // The filter expects higher values inside; here they are outside.
    return meshOf(*surface->GetOutput(), true);
}

} // namespace dipwright
