// Stores how far the film's area grows, one value per pixel of its image.
#pragma once

#include <QImage>
#include <cstdint>

namespace dipwright {

// Range of stored area stretches: from film folded flat to more than film can stretch.
inline constexpr float leastAreaStretch = 0.05f, mostAreaStretch = 20;

// Convert an area stretch J to its code and back. One step of the code is about 0.01 % of J.
std::uint16_t stretchCode(float areaStretch);
float areaStretchOf(std::uint16_t code);

// Returns the plane of unstretched film: Grayscale16, one code per pixel.
QImage unstretched(QSize pixels);

// Convert a plane to a picture and back, so that it can be transformed like an image. The picture
// has 16 bits per channel (RGBA64) and the code in every channel. If a film image (RGBA) is given,
// only its painted pixels are opaque. Transparent pixels become unstretched on the way back.
QImage pictureOfStretch(const QImage& plane, const QImage& film = {});
QImage stretchOfPicture(const QImage& picture);

} // namespace dipwright
