// Paints the textures of the samples.
#pragma once

#include "model/TexturedMesh.h"

#include <QPainter>
#include <functional>

namespace dipwright::samples {

inline constexpr int texturePixels = 2048;

// Returns a model with one material and one texture. `coordinates` holds the texture coordinates of
// each triangle's corners.
TexturedMesh textured(TriangleMesh mesh, std::vector<std::array<Eigen::Vector2f, 3>> coordinates,
                      QImage texture);

// Draws `text` centred at `centre`, along the painter's axes. The text is `height` pixels high, and
// `widening` times as wide as usual.
void paintLetters(QPainter& painter, QPointF centre, double height, const QString& text,
                  double widening = 1);

// Returns a texture in which each pixel has the colour of its place on the surface. `places` holds,
// for each mesh position, the point at which `colour` is evaluated. Colours continue a few pixels
// beyond the charts, so that texture filtering mixes in no other colours.
QImage bakeTexture(const TriangleMesh& mesh,
                   const std::vector<std::array<Eigen::Vector2f, 3>>& coordinates,
                   const std::vector<Eigen::Vector3f>& places,
                   const std::function<QRgb(const Eigen::Vector3f&)>& colour);

} // namespace dipwright::samples
