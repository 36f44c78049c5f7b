// How colour-blind readers see colours. Simulates dichromats after Machado, Oliveira and Fernandes,
// "A physiologically-based model for simulation of color vision deficiency", 2009 (severity 1), and
// measures distances in OKLab (B. Ottosson, 2020).
#pragma once

#include <QColor>
#include <array>
#include <cmath>

namespace dipwright {

enum class ColourVision { Usual, Protan, Deutan, Tritan };
inline constexpr std::array allColourVisions{ColourVision::Usual, ColourVision::Protan,
                                             ColourVision::Deutan, ColourVision::Tritan};

namespace vision {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

inline Triple product(const Matrix& matrix, const Triple& values) {
    Triple result{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            result[row] += matrix[row][column] * values[column];
        }
    }
    return result;
}

inline const Matrix& matrixOf(ColourVision kind) {
    static constexpr std::array<Matrix, 4> matrices{{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                                                     {{{0.152286, 1.052583, -0.204868},
                                                       {0.114503, 0.786281, 0.099216},
                                                       {-0.003882, -0.048116, 1.051998}}},
                                                     {{{0.367322, 0.860646, -0.227968},
                                                       {0.280085, 0.672501, 0.047413},
                                                       {-0.011820, 0.042940, 0.968881}}},
                                                     {{{1.255528, -0.076749, -0.178779},
                                                       {-0.078411, 0.930809, 0.147602},
                                                       {0.004733, 0.691367, 0.303900}}}}};
    return matrices[std::size_t(kind)];
}

} // namespace vision

// Returns the colour as it is seen, in OKLab: lightness, a, b.
inline vision::Triple seen(const QColor& colour, ColourVision kind) {
    using namespace vision;
    const auto linear = [](double value) {
        return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    Triple light = product(
        matrixOf(kind), {linear(colour.redF()), linear(colour.greenF()), linear(colour.blueF())});
    for (double& part : light) {
        part = std::min(1.0, std::max(0.0, part));
    }
    Triple cones = product({{{0.4122214708, 0.5363325363, 0.0514459929},
                             {0.2119034982, 0.6806995451, 0.1073969566},
                             {0.0883024619, 0.2817188376, 0.6299787005}}},
                           light);
    for (double& part : cones) {
        part = std::cbrt(part);
    }
    return product({{{0.2104542553, 0.7936177850, -0.0040720468},
                     {1.9779984951, -2.4285922050, 0.4505937099},
                     {0.0259040371, 0.7827717662, -0.8086757660}}},
                   cones);
}

// Returns the distance of the colours as they are seen. About 0.02 is just visible; 0.1 is safe for
// areas that do not touch.
inline double seenDistance(const QColor& one, const QColor& other, ColourVision kind) {
    const vision::Triple a = seen(one, kind), b = seen(other, kind);
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

} // namespace dipwright
