// Draws the linked cursor and the measured distance in the view.
#pragma once

#include <Eigen/Core>
#include <QColor>
#include <QString>
#include <optional>
#include <vector>
#include <vtkActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>

namespace dipwright {

class MarkerActors {
public:
    explicit MarkerActors(vtkRenderer* renderer);

    void setMarker(const std::optional<Eigen::Vector3f>& position);
    // Shows up to two places and, if there are two, the lines between them with their label. The
    // first line is drawn over the surface that it lies in, and carries the label.
    void setMeasure(const std::vector<Eigen::Vector3f>& places,
                    const std::vector<std::vector<Eigen::Vector3f>>& lines, const QString& label);
    void setSize(double sceneSize); // mm, size of the whole scene
    void setColours(const QColor& accent, const QColor& ink);
    void setFontSize(int pixels);
    void setPixelRatio(double ratio); // screen pixels per window pixel

private:
    vtkSmartPointer<vtkSphereSource> ball_;
    vtkSmartPointer<vtkActor> marker_, line_;
    vtkSmartPointer<vtkPolyData> lineData_;
    std::array<vtkSmartPointer<vtkActor>, 2> ends_;
    vtkSmartPointer<vtkBillboardTextActor3D> label_;
};

} // namespace dipwright
