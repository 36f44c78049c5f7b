// Stores how far the film's area grows, one value per pixel of its image.
#pragma once

#include <QImage>
#include <cstdint>

namespace dipwright {

// From film that is folded flat to more than any film bears.
inline constexpr float leastAreaStretch = 0.05f, mostAreaStretch = 20;

// One step of the code is about a ten-thousandth of J.
std::uint16_t stretchCode(float areaStretch);
float areaStretchOf(std::uint16_t code);

// Returns the plane of unstretched film: Grayscale16, one code per pixel.
QImage unstretched(QSize pixels);

// Convert the plane to a picture and back, so that it can be moved like an image (wide, the code in
// every channel). On the way back, pixels that nothing covers are unstretched. If a film image
// (RGBA) is given, only its painted pixels are opaque.
QImage pictureOfStretch(const QImage& plane, const QImage& film = {});
QImage stretchOfPicture(const QImage& picture);

} // namespace dipwright
