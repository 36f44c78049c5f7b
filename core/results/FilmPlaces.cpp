#include "results/FilmPlaces.h"

#include "parallel/ParallelFor.h"

namespace dipwright {
namespace {

// Largest distance on the flat film between an interpolated and a found place, mm. A pixel at
// 300 dpi is 0.085 mm wide.
constexpr float tolerance = 0.05f;

} // namespace

FilmPlaces::FilmPlaces(const RefinedMesh& body, const LaidFilm& laid)
    : body_(body), laid_(laid), triangles_(body.mesh().triangles.size()) {
    parallelFor(std::size_t(0), triangles_.size(), [&](std::size_t triangle) {
        triangles_[triangle] = triangleAt(std::uint32_t(triangle));
    });
}

FilmPlaces::Triangle FilmPlaces::triangleAt(std::uint32_t fine) const {
    const std::optional<FilmPlace> middle = laid_.place(body_.middle(fine));
    Triangle triangle;
    int painted = 0;
    for (int corner = 0; corner < 3; ++corner) {
        const SurfacePoint onBody = body_.onCoarse({fine, Eigen::Vector3f::Unit(corner)});
        if (const std::optional<FilmPlace> place = laid_.place(onBody)) {
            triangle.corners[std::size_t(corner)] = place->rest;
            ++painted;
        }
    }
    if (painted == 0 && !middle) {
        triangle.painted = Painted::No;
    } else if (painted == 3 && middle) {
        const auto& [a, b, c] = triangle.corners;
        triangle.painted = (middle->rest - (a + b + c) / 3).norm() <= tolerance ? Painted::Linearly
                                                                                : Painted::Unevenly;
    }
    return triangle;
}

std::optional<FilmPlace> FilmPlaces::at(const SurfacePoint& fine) const {
    const Triangle& triangle = triangles_[fine.triangle];
    if (triangle.painted == Painted::No) {
        return std::nullopt;
    }
    if (triangle.painted == Painted::Linearly) {
        const auto& [a, b, c] = triangle.corners;
        const auto flat =
            laid_.flat(fine.weights[0] * a + fine.weights[1] * b + fine.weights[2] * c);
        if (flat) {
            return flat;
        }
    }
    return laid_.place(body_.onCoarse(fine));
}

} // namespace dipwright
