#include "share/FadeOverlap.h"

#include "parallel/ParallelFor.h"
#include "share/SmoothSeam.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

// Chosen constants (docs/film-model.md, "Two dips, one body").
constexpr double visibleStep = 0.1; // smallest visible difference of reflectance
constexpr double darkest = 0.01;    // reflectance of printed black
constexpr double leastBand = 0.1;   // narrowest overlap, mm
// The film counts as having a gap where its flat length is more than this many times the length of
// the body's surface under it.
constexpr float gapRatio = 2;
// Factor on the overlap width, because neighbouring film may be stretched less.
constexpr float widthReserve = 1.15f;
// Relative tolerance, so that a fade of exactly the needed width passes.
constexpr double widthTolerance = 0.05;

using Corners = std::array<Eigen::Vector3f, 3>;

std::array<float, 3> lengthsOf(const Corners& corners) {
    return {(corners[1] - corners[0]).norm(), (corners[2] - corners[1]).norm(),
            (corners[0] - corners[2]).norm()};
}

// Returns the corners that the film on a fine triangle had when it was flat. Returns nothing if the
// film does not cover the whole triangle in one piece.
std::optional<Corners> onFlatFilm(const RefinedMesh& body, std::uint32_t triangle,
                                  const LaidFilm& laid) {
    Corners flat;
    for (int corner = 0; corner < 3; ++corner) {
        const Eigen::Vector3f weights = Eigen::Vector3f::Unit(corner);
        const std::optional<FilmPlace> place = laid.place(body.onCoarse({triangle, weights}));
        if (!place) {
            return std::nullopt;
        }
        flat[std::size_t(corner)] = {place->rest.x(), place->rest.y(), 0};
    }
    const std::array<float, 3> there = lengthsOf(cornersOf(body.mesh(), triangle));
    const std::array<float, 3> lengths = lengthsOf(flat);
    for (std::size_t edge = 0; edge < 3; ++edge) {
        if (lengths[edge] > gapRatio * there[edge]) {
            return std::nullopt;
        }
    }
    return flat;
}

// Returns, per triangle, the largest value of the triangle and its neighbours.
std::vector<float> largestAround(const TriangleMesh& mesh, const std::vector<float>& values) {
    std::vector<float> most(mesh.positions.size(), 0);
    for (std::size_t triangle = 0; triangle < values.size(); ++triangle) {
        for (const std::uint32_t corner : mesh.triangles[triangle]) {
            most[corner] = std::max(most[corner], values[triangle]);
        }
    }
    std::vector<float> around;
    for (const auto& [a, b, c] : mesh.triangles) {
        around.push_back(std::max({most[a], most[b], most[c]}));
    }
    return around;
}

// Returns the edges from the first corner to the two others, in the triangle's plane.
Eigen::Matrix2f edgesInPlane(const Corners& corners) {
    const Eigen::Vector3f first = corners[1] - corners[0];
    const Eigen::Vector3f second = corners[2] - corners[0];
    const Eigen::Vector3f along = first.normalized();
    const float across = (second - second.dot(along) * along).norm();
    Eigen::Matrix2f edges;
    edges << first.norm(), second.dot(along), 0, across;
    return edges;
}

// Returns the triangle `onBody` in units of the overlap width. This width is `band` mm on the flat
// film (`measured`), and at least `least` mm on the body in every direction.
Corners inOverlapWidths(const Corners& measured, const Corners& onBody, float band, float least) {
    const Eigen::Matrix2f body = edgesInPlane(onBody);
    if (!(body.determinant() > 0)) {
        return onBody;
    }
    const Eigen::JacobiSVD<Eigen::Matrix2f> stretch(edgesInPlane(measured) * body.inverse() / band,
                                                    Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Matrix2f edges = stretch.matrixU() *
                                  stretch.singularValues().cwiseMin(1 / least).asDiagonal() *
                                  stretch.matrixV().transpose() * body;
    return {Eigen::Vector3f::Zero(), Eigen::Vector3f(edges(0, 0), edges(1, 0), 0),
            Eigen::Vector3f(edges(0, 1), edges(1, 1), 0)};
}

} // namespace

double neededOverlap(const LinearColour& colour, double error, double least) {
    double share = 1; // largest displacement of the film, as a share of the overlap width
    for (const float channel : colour) {
        const double light = std::clamp(double(channel), darkest, 0.999);
        // If a share x of the density is missing, the light rises by light^(1 − x) − light. If a
        // share x is added, the light falls by light − light^(1 + x).
        if (light + visibleStep < 1) {
            share = std::min(share, 1 - std::log(light + visibleStep) / std::log(light));
        }
        if (light > visibleStep) {
            share = std::min(share, std::log(light - visibleStep) / std::log(light) - 1);
        }
    }
    return std::max(least, error / share);
}

FadeOverlap::FadeOverlap(const RefinedMesh& body, const LaidFilm& second,
                         const std::vector<LinearColour>& colours, const ShareSettings& settings)
    : body_(body), narrowest_(float(std::max(settings.overlap.value(), leastBand))),
      flat_(colours.size()), needed_(colours.size()), measure_(colours.size()) {
    parallelFor(std::size_t(0), flat_.size(), [&](std::size_t triangle) {
        flat_[triangle] = onFlatFilm(body, std::uint32_t(triangle), second);
        needed_[triangle] =
            float(neededOverlap(colours[triangle], settings.registrationError.value(), leastBand));
    });
    const std::vector<float> around = largestAround(body.mesh(), needed_);
    parallelFor(std::size_t(0), measure_.size(), [&](std::size_t triangle) {
        const Corners corners = cornersOf(body.mesh(), triangle);
        measure_[triangle] = inOverlapWidths(flat_[triangle].value_or(corners), corners,
                                             widthReserve * around[triangle], narrowest_);
    });
}

double FadeOverlap::tooNarrow(const std::vector<float>& fade,
                              const std::vector<Painter>& painters) const {
    double both = 0, narrow = 0;
    for (std::size_t triangle = 0; triangle < painters.size(); ++triangle) {
        if (painters[triangle] != Painter::Both) {
            continue;
        }
        const double area = triangleArea(body_.mesh(), triangle);
        const auto& [a, b, c] = body_.mesh().triangles[triangle];
        const Corners corners = flat_[triangle].value_or(cornersOf(body_.mesh(), triangle));
        const double steep = double(steepness(corners, {fade[a], fade[b], fade[c]}));
        both += area;
        narrow += steep * double(needed_[triangle]) > 1 + widthTolerance ? area : 0;
    }
    return both > 0 ? narrow / both : 0;
}

} // namespace dipwright
