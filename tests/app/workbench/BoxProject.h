// A project with a plain box, for tests that need a document and do not care what it contains.
#pragma once

#include "geometry/Shapes.h"
#include "model/TexturedMesh.h"
#include "project/Project.h"

#include <limits>

namespace dipwright {

inline Project boxProject() {
    auto model = std::make_shared<TexturedMesh>();
    model->mesh = boxMesh({30, 20, 40});
    const std::size_t count = model->mesh.triangles.size();
    model->textureCoordinates.resize(count);
    for (auto& corners : model->textureCoordinates) {
        corners.fill(Eigen::Vector2f::Constant(std::numeric_limits<float>::quiet_NaN()));
    }
    model->material.resize(count, 0);
    model->materials.resize(1);
    model->chart = findCharts(*model);
    Project project;
    project.name = QStringLiteral("Box");
    project.date = QStringLiteral("2026-01-02");
    project.model = model;
    return project;
}

} // namespace dipwright
