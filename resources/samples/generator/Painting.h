// Pictures for texture charts.
#pragma once

#include "model/TexturedMesh.h"

#include <QPainter>
#include <functional>

namespace dipwright::samples {

inline constexpr int texturePixels = 2048;

// A model of one material with one texture. `coordinates`: a triangle's corners each.
TexturedMesh textured(TriangleMesh mesh, std::vector<std::array<Eigen::Vector2f, 3>> coordinates,
                      QImage texture);

// Writes `text` round `centre`, `height` pixels high and stretched sideways by `widening`, in the
// direction of the painter's own axes.
void paintLetters(QPainter& painter, QPointF centre, double height, const QString& text,
                  double widening = 1);

// A texture in which each pixel gets the colour of the place on the surface that shows it; `places`
// gives the positions that `colour` is asked about, a mesh position each. Colours run on a few
// pixels beyond the charts, so that filtering finds no foreign ones there.
QImage bakeTexture(const TriangleMesh& mesh,
                   const std::vector<std::array<Eigen::Vector2f, 3>>& coordinates,
                   const std::vector<Eigen::Vector3f>& places,
                   const std::function<QRgb(const Eigen::Vector3f&)>& colour);

} // namespace dipwright::samples
