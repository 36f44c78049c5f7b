// Makes a ball of 30 mm in one colour, whose texture is projected from above.
#pragma once

#include "geometry/Shapes.h"
#include "model/TexturedMesh.h"

#include <QImage>
#include <memory>

namespace dipwright::test {

inline std::shared_ptr<const TexturedMesh> texturedBall(const QColor& colour) {
    auto model = std::make_shared<TexturedMesh>();
    model->mesh = sphereMesh(15, 30, 60);
    for (const auto& corners : model->mesh.triangles) {
        auto& coordinates = model->textureCoordinates.emplace_back();
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Eigen::Vector3f& place = model->mesh.positions[corners[corner]];
            coordinates[corner] = {place.x() / 30 + 0.5f, place.z() / 30 + 0.5f};
        }
    }
    model->material.resize(model->mesh.triangles.size(), 0);
    QImage picture(64, 64, QImage::Format_RGBA8888);
    picture.fill(colour);
    model->textures = {picture};
    model->materials = {{QStringLiteral("ball"), Qt::white, 0}};
    model->chart = findCharts(*model);
    return model;
}

} // namespace dipwright::test
