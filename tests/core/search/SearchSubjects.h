// Makes subjects of the pose search from meshes.
#pragma once

#include "geometry/Shapes.h"
#include "model/TexturedMesh.h"
#include "search/SearchSubject.h"

#include <limits>

namespace dipwright {

// Returns a subject of the mesh with a film of 100 × 100 mm and 25 × 25 points.
inline SearchSubject subjectOf(const TriangleMesh& mesh) {
    auto model = std::make_shared<TexturedMesh>();
    model->mesh = mesh;
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    const Eigen::Vector2f noCoordinate(none, none);
    model->textureCoordinates.resize(model->mesh.triangles.size(),
                                     {noCoordinate, noCoordinate, noCoordinate});
    model->material.resize(model->mesh.triangles.size(), 0);
    model->materials.resize(1);
    model->chart = findCharts(*model);
    SearchSubject subject;
    subject.name = QStringLiteral("body");
    subject.identity = "body";
    subject.model = model;
    subject.film.width = subject.film.height = Millimetres(100);
    subject.film.columns = subject.film.rows = 25;
    subject.fieldResolution = 64;
    return subject;
}

} // namespace dipwright
