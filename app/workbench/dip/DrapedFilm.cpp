#include "workbench/dip/DrapedFilm.h"

#include "parallel/ParallelFor.h"

#include <algorithm>

namespace dipwright {

namespace {

constexpr int mostDivisions = 4;         // of one side, into halves
constexpr float mostSag = 0.03f;         // mm between a side and the surface
constexpr float shortestDivided = 0.15f; // mm
constexpr float lift = 0.05f;            // mm above the surface

// A side between two points, the smaller number first.
using Side = std::array<std::uint32_t, 2>;

Side sideOf(const FilmTriangle& triangle, std::size_t from) {
    const std::uint32_t a = triangle[from], b = triangle[(from + 1) % 3];
    return {std::min(a, b), std::max(a, b)};
}

class Draper {
public:
    explicit Draper(const LaidFilm& laid)
        : laid_(laid), drape_{laid.film().positions, {}, laid.triangles(), laid.contact().painted} {
        outward_.resize(drape_.positions.size(), Eigen::Vector3f::Zero());
        isOpen_ = drape_.painted;
    }

    DrapedFilm drape() {
        putOnSurface();
        for (int division = 0; division < mostDivisions && divide(); ++division) {
        }
        parallelFor(std::size_t(0), drape_.positions.size(),
                    [&](std::size_t point) { drape_.positions[point] += lift * outward_[point]; });
        return std::move(drape_);
    }

private:
    // Puts the points of the film that paints exactly on the surface.
    void putOnSurface() {
        const TriangleMesh& body = laid_.body().mesh;
        for (std::size_t t = 0; t < drape_.triangles.size(); ++t) {
            for (const std::uint32_t point : drape_.triangles[t]) {
                const SurfacePoint& place = laid_.contact().surface[point];
                if (drape_.painted[t] && place.isValid()) {
                    drape_.positions[point] = position(body, place);
                    outward_[point] = triangleNormal(body, place.triangle);
                }
            }
        }
    }

    // Divides the sides that are too far from the surface. Returns whether there was one.
    bool divide() {
        const std::vector<Side> sides = openSides();
        std::vector<SurfacePoint> places(sides.size());
        parallelForPieces(std::size_t(0), sides.size(), std::size_t(256),
                          [&](std::size_t first, std::size_t last) {
                              for (std::size_t side = first; side < last; ++side) {
                                  places[side] = placeBetween(sides[side]);
                              }
                          });
        const std::size_t before = drape_.positions.size();
        std::vector<Side> divided;
        for (std::size_t side = 0; side < sides.size(); ++side) {
            if (places[side].isValid()) {
                const TriangleMesh& body = laid_.body().mesh;
                divided.push_back(sides[side]);
                drape_.between.push_back(sides[side]);
                drape_.positions.push_back(position(body, places[side]));
                outward_.push_back(triangleNormal(body, places[side].triangle));
            }
        }
        divideTriangles(divided, std::uint32_t(before));
        return !divided.empty();
    }

    // Returns the sides of the triangles on the body that changed last.
    std::vector<Side> openSides() const {
        std::vector<Side> sides;
        for (std::size_t t = 0; t < drape_.triangles.size(); ++t) {
            for (std::size_t from = 0; from < 3 && isOpen_[t]; ++from) {
                sides.push_back(sideOf(drape_.triangles[t], from));
            }
        }
        std::sort(sides.begin(), sides.end());
        sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
        return sides;
    }

    // Returns the place of the surface for the middle of a side; invalid if the side follows the
    // surface.
    SurfacePoint placeBetween(const Side& side) const {
        const Eigen::Vector3f &a = drape_.positions[side[0]], &b = drape_.positions[side[1]];
        const float length = (b - a).norm();
        if (length < shortestDivided) {
            return {};
        }
        const ClosestPoint found = laid_.body().query.closestNear((a + b) / 2, length);
        return found.distance > mostSag && found.distance < length ? found.point : SurfacePoint();
    }

    // `divided` is sorted; its middles are the points from `first` on.
    void divideTriangles(const std::vector<Side>& divided, std::uint32_t first) {
        std::vector<std::uint8_t> ends(drape_.positions.size(), 0); // of a divided side
        for (const Side& side : divided) {
            ends[side[0]] = ends[side[1]] = 1;
        }
        const auto middleOf = [&](const Side& side) {
            if (ends[side[0]] && ends[side[1]]) {
                const auto found = std::lower_bound(divided.begin(), divided.end(), side);
                if (found != divided.end() && *found == side) {
                    return first + std::uint32_t(found - divided.begin());
                }
            }
            return whole;
        };
        std::vector<FilmTriangle> triangles;
        std::vector<std::uint8_t> painted, open;
        for (std::size_t t = 0; t < drape_.triangles.size(); ++t) {
            const FilmTriangle& triangle = drape_.triangles[t];
            const std::size_t begin = triangles.size();
            addParts(triangles, triangle,
                     {middleOf(sideOf(triangle, 0)), middleOf(sideOf(triangle, 1)),
                      middleOf(sideOf(triangle, 2))});
            const bool isDivided = triangles.size() > begin + 1;
            painted.resize(triangles.size(), drape_.painted[t]);
            open.resize(triangles.size(), isDivided && drape_.painted[t]);
        }
        drape_.triangles = std::move(triangles);
        drape_.painted = std::move(painted);
        isOpen_ = std::move(open);
    }

    // Adds the parts of a triangle whose sides are divided at `middles`.
    static void addParts(std::vector<FilmTriangle>& parts, const FilmTriangle& triangle,
                         const std::array<std::uint32_t, 3>& middles) {
        const auto count = std::count_if(middles.begin(), middles.end(),
                                         [](std::uint32_t middle) { return middle != whole; });
        // Turned so that the divided sides come first.
        std::size_t turn = 0;
        while (count % 3 != 0 && (middles[turn] == whole || middles[(turn + 2) % 3] != whole)) {
            ++turn;
        }
        const std::uint32_t a = triangle[turn], b = triangle[(turn + 1) % 3],
                            c = triangle[(turn + 2) % 3], ab = middles[turn],
                            bc = middles[(turn + 1) % 3], ca = middles[(turn + 2) % 3];
        if (count == 0) {
            parts.push_back(triangle);
        } else if (count == 1) {
            parts.insert(parts.end(), {{a, ab, c}, {ab, b, c}});
        } else if (count == 2) {
            parts.insert(parts.end(), {{a, ab, c}, {ab, bc, c}, {ab, b, bc}});
        } else {
            parts.insert(parts.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
    }

    static constexpr std::uint32_t whole = 0xffffffffu; // no middle: the side is not divided

    const LaidFilm& laid_;
    DrapedFilm drape_;
    std::vector<Eigen::Vector3f> outward_; // per point: the surface's normal; zero off the body
    std::vector<std::uint8_t> isOpen_;     // per triangle: its sides are still to be checked
};

} // namespace

DrapedFilm drapedFilm(const LaidFilm& laid) {
    return Draper(laid).drape();
}

} // namespace dipwright
