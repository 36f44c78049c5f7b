#include "share/ShareMarks.h"

#include "geometry/SurfaceSpot.h"
#include "marks/StrokeArea.h"
#include "share/SeamPlaces.h"

namespace dipwright {
namespace {

// Chosen constants (docs/film-model.md, "Two dips, one body").
constexpr double assignedCost = 1e5; // cost of a mm² that the user assigned to the other dip
constexpr float avoidFactor = 20;    // factor on a seam's visibility where the user avoids a seam
constexpr float allowFactor = 0.05f; // factor on a seam's visibility where the user allows a seam

SurfacePoint placeOf(const ShareMark& mark, const SurfaceQuery& query) {
    return query.closest(modelPlace(mark.place)).point;
}

std::vector<std::uint32_t> trianglesOf(const TriangleMesh& mesh, const SurfaceQuery& query,
                                       const ShareMark& mark) {
    if (!mark.path.empty()) {
        return trianglesOf(mesh, StrokeArea(mark.path, mark.radius));
    }
    const SurfacePoint middle = placeOf(mark, query);
    const auto radius = float(mark.radius.value());
    return radius > 0 ? trianglesWithin(mesh, middle, radius) : faceAround(mesh, middle.triangle);
}

// Returns the edges between triangles of a set and triangles outside the set.
std::vector<std::array<Eigen::Vector3f, 2>> borderOf(const TriangleMesh& mesh,
                                                     const std::vector<std::uint32_t>& set) {
    std::vector<std::uint8_t> isIn(mesh.triangles.size());
    for (const std::uint32_t triangle : set) {
        isIn[triangle] = 1;
    }
    const std::vector<std::uint32_t> opposite = oppositeEdges(mesh);
    std::vector<std::array<Eigen::Vector3f, 2>> border;
    for (const std::uint32_t triangle : set) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t other = opposite[3 * triangle + k];
            if (other == noEdge || isIn[other / 3] == 0) {
                border.push_back({mesh.positions[mesh.triangles[triangle][k]],
                                  mesh.positions[mesh.triangles[triangle][(k + 1) % 3]]});
            }
        }
    }
    return border;
}

} // namespace

std::vector<std::array<Eigen::Vector3f, 2>>
markOutline(const TriangleMesh& mesh, const SurfaceQuery& query, const ShareMark& mark) {
    if (!mark.path.empty()) {
        return borderOf(mesh, trianglesOf(mesh, query, mark));
    }
    const SurfacePoint middle = placeOf(mark, query);
    const auto radius = float(mark.radius.value());
    if (radius <= 0) {
        return borderOf(mesh, faceAround(mesh, middle.triangle));
    }
    std::vector<float> inside = distanceFrom(mesh, middle, 2 * radius);
    for (float& value : inside) {
        value = radius - std::min(value, 2 * radius);
    }
    std::vector<std::array<Eigen::Vector3f, 2>> circle;
    for (const LinePiece& piece : zeroLine(mesh, inside)) {
        circle.push_back(piece.ends);
    }
    return circle;
}

std::vector<std::optional<std::size_t>> applyShareMarks(const TriangleMesh& mesh,
                                                        const std::vector<ShareMark>& marks,
                                                        std::vector<std::array<double, 2>>& costs,
                                                        std::vector<float>& weights) {
    std::vector<std::optional<std::size_t>> assigned(mesh.triangles.size());
    if (marks.empty()) {
        return assigned;
    }
    const SurfaceQuery query(mesh);
    const std::vector<std::array<double, 2>> unmarkedCosts = costs;
    const std::vector<float> unmarkedWeights = weights;
    for (const ShareMark& mark : marks) {
        for (const std::uint32_t triangle : trianglesOf(mesh, query, mark)) {
            const double area = triangleArea(mesh, triangle);
            switch (mark.kind) {
            case ShareMarkKind::First:
                assigned[triangle] = 0;
                costs[triangle] = {unmarkedCosts[triangle][0],
                                   unmarkedCosts[triangle][1] + assignedCost * area};
                break;
            case ShareMarkKind::Second:
                assigned[triangle] = 1;
                costs[triangle] = {unmarkedCosts[triangle][0] + assignedCost * area,
                                   unmarkedCosts[triangle][1]};
                break;
            case ShareMarkKind::Avoid:
                weights[triangle] = avoidFactor * unmarkedWeights[triangle];
                break;
            case ShareMarkKind::Allow:
                weights[triangle] = allowFactor * unmarkedWeights[triangle];
                break;
            case ShareMarkKind::None:
                assigned[triangle].reset();
                costs[triangle] = unmarkedCosts[triangle];
                weights[triangle] = unmarkedWeights[triangle];
                break;
            }
        }
    }
    return assigned;
}

} // namespace dipwright
