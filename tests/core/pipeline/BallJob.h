// A small job with a textured ball, for tests of the whole pipeline.
#pragma once

#include "geometry/Shapes.h"
#include "project/Project.h"

namespace dipwright::test {

// Returns the job of a ball of 30 mm with one dip, on a film of 90 × 90 mm, for the CPU solver.
inline Project ballJob() {
    auto model = std::make_shared<TexturedMesh>();
    model->mesh = sphereMesh(15, 20, 40);
    model->textureCoordinates.resize(model->mesh.triangles.size());
    model->material.resize(model->mesh.triangles.size(), 0);
    QImage picture(8, 8, QImage::Format_RGBA8888);
    picture.fill(QColor(200, 80, 20));
    model->textures = {picture};
    model->materials = {{QStringLiteral("ball"), Qt::white, 0}};
    model->chart = findCharts(*model);
    Project project;
    project.name = QStringLiteral("ball");
    project.model = model;
    project.film.width = project.film.height = Millimetres(90);
    project.fieldResolution = 64;
    project.sheet.resolution = DotsPerInch(72);
    project.process.solver = QStringLiteral("pbd-cpu");
    return project;
}

} // namespace dipwright::test
