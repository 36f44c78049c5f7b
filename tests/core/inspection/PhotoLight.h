// What light, a lens out of focus and a camera's chip make of a picture. In linear light, then
// encoded.
#pragma once

#include <QImage>
#include <vector>

namespace dipwright::test {

struct PhotoLight {
    double blur = 0.7;    // pixels, standard deviation
    double noise = 1;     // levels of 255
    double uneven = 0.4;  // how much darker it is on the left
    bool glare = false;   // a bright spot
    int jpegQuality = 85; // 0: none
    unsigned seed = 1;
};

// `reflected`: 0 … 1, a pixel each, by rows.
QImage developed(std::vector<float> reflected, QSize size, const PhotoLight& light);

} // namespace dipwright::test
