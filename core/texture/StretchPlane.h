// How far the film's area grows, a value for each pixel of its image.
#pragma once

#include <QImage>
#include <cstdint>

namespace dipwright {

// From what film that is folded flat has to more than any film bears.
inline constexpr float leastAreaStretch = 0.05f, mostAreaStretch = 20;

// A step is a ten-thousandth of J.
std::uint16_t stretchCode(float areaStretch);
float areaStretchOf(std::uint16_t code);

// The plane of a film that is nowhere stretched: Grayscale16, a code a pixel.
QImage unstretched(QSize pixels);

// The plane as a picture whose colours and cover can be moved as an image's are (wide, a code in
// every channel), and back: film that none came to is not stretched. With a film image (RGBA) only
// what that paints is covered.
QImage pictureOfStretch(const QImage& plane, const QImage& film = {});
QImage stretchOfPicture(const QImage& picture);

} // namespace dipwright
