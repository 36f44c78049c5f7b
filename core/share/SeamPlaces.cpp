#include "share/SeamPlaces.h"

#include "parallel/ParallelFor.h"
#include "texture/SurfaceColours.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dipwright {
namespace {

// Chosen constants (docs/film-model.md, "Two dips, one body").
// Contrast of a plain place; above 0, so that a short seam costs less.
constexpr float leastContrast = 0.1f;
constexpr float leastVisibility = 0.1f; // visibility of a place that no light reaches
// Difference of sRGB values (0 … 1) that counts as full contrast.
constexpr float fullContrast = 0.3f;
constexpr float creaseAngle = 30; // degrees; a sharper edge of the body is a crease
constexpr float creaseWeight = 0.5f;
constexpr int lines = 24; // lines of sight from each place

// Returns sRGB values; black is 0 and white is 1.
Eigen::Array3f encoded(const LinearColour& colour) {
    return colour.unaryExpr([](float linear) { return float(srgbFromLinear(double(linear))); });
}

// Returns the places at which the texture of each fine triangle is sampled: its middle and one
// place near each corner.
std::vector<SurfacePoint> samplePlaces(const RefinedMesh& body) {
    const std::size_t triangles = body.mesh().triangles.size();
    std::vector<SurfacePoint> places(4 * triangles);
    for (std::uint32_t triangle = 0; triangle < triangles; ++triangle) {
        places[4 * triangle] = body.middle(triangle);
        for (int corner = 0; corner < 3; ++corner) {
            const Eigen::Vector3f weights =
                Eigen::Vector3f::Constant(0.1f) + 0.7f * Eigen::Vector3f::Unit(corner);
            places[4 * triangle + 1 + std::size_t(corner)] = body.onCoarse({triangle, weights});
        }
    }
    return places;
}

// Returns how much the colours in a triangle and its neighbours differ, 0 … 1.
std::vector<float> contrasts(const std::vector<LinearColour>& sampled,
                             const std::vector<std::uint32_t>& opposite) {
    const std::size_t triangles = opposite.size() / 3;
    std::vector<float> contrast(triangles);
    parallelFor(std::size_t(0), triangles, [&](std::size_t triangle) {
        Eigen::Array3f least = encoded(sampled[4 * triangle]);
        Eigen::Array3f most = least;
        const auto add = [&](const LinearColour& colour) {
            const Eigen::Array3f value = encoded(colour);
            least = least.min(value);
            most = most.max(value);
        };
        for (std::size_t sample = 1; sample < 4; ++sample) {
            add(sampled[4 * triangle + sample]);
        }
        for (std::size_t edge = 0; edge < 3; ++edge) {
            if (const std::uint32_t other = opposite[3 * triangle + edge]; other != noEdge) {
                add(sampled[4 * std::size_t(other / 3)]);
            }
        }
        contrast[triangle] = std::min(1.0f, (most - least).maxCoeff() / fullContrast);
    });
    return contrast;
}

// Returns directions above a plane that faces +Z, cosine-weighted like diffuse light on paper.
std::array<Eigen::Vector3f, lines> linesOfSight() {
    std::array<Eigen::Vector3f, lines> directions;
    for (int k = 0; k < lines; ++k) {
        const float height = std::sqrt((float(k) + 0.5f) / lines);
        const float across = std::sqrt(1 - height * height);
        const float turn = 2 * std::numbers::pi_v<float> * 0.618034f * float(k);
        directions[std::size_t(k)] = {across * std::cos(turn), across * std::sin(turn), height};
    }
    return directions;
}

// Returns, per position, the share of lines of sight that do not hit the body.
std::vector<float> openness(const TriangleMesh& mesh, const SurfaceQuery& query) {
    const std::array<Eigen::Vector3f, lines> directions = linesOfSight();
    const std::vector<Eigen::Vector3f> normals = vertexNormals(mesh);
    const float clear = 1e-3f * boundingBox(mesh).diagonal().norm();
    std::vector<float> open(mesh.positions.size());
    parallelFor(std::size_t(0), open.size(), [&](std::size_t position) {
        const Eigen::Quaternionf turn =
            Eigen::Quaternionf::FromTwoVectors(Eigen::Vector3f::UnitZ(), normals[position]);
        int leaving = 0;
        for (const Eigen::Vector3f& direction : directions) {
            const Eigen::Vector3f from = mesh.positions[position] + clear * normals[position];
            leaving += query.isHit(from, turn * direction) ? 0 : 1;
        }
        open[position] = float(leaving) / lines;
    });
    return open;
}

} // namespace

SeamPlaces seamPlaces(const RefinedMesh& body, const TexturedMesh& model,
                      const SurfaceQuery& query) {
    const TriangleMesh& mesh = body.mesh();
    const std::vector<LinearColour> sampled = SurfaceColours(model).at(samplePlaces(body));
    const std::vector<float> contrast = contrasts(sampled, oppositeEdges(mesh));
    const std::vector<float> open = openness(mesh, query);
    SeamPlaces places;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const auto& [a, b, c] = mesh.triangles[triangle];
        const LinearColour* sample = &sampled[4 * triangle];
        places.colours.push_back((sample[0] + sample[1] + sample[2] + sample[3]) / 4);
        const float visibility = (open[a] + open[b] + open[c]) / 3;
        places.weights.push_back((leastContrast + contrast[triangle]) *
                                 (leastVisibility + visibility));
    }
    return places;
}

std::vector<CutEdge> seamCutEdges(const RefinedMesh& body, const std::vector<float>& weights) {
    const TriangleMesh& mesh = body.mesh();
    const std::vector<std::uint32_t> opposite = oppositeEdges(mesh);
    const float crease = std::cos(creaseAngle * std::numbers::pi_v<float> / 180);
    std::vector<CutEdge> edges;
    for (std::uint32_t edge = 0; edge < opposite.size(); ++edge) {
        if (opposite[edge] == noEdge || edge > opposite[edge]) {
            continue;
        }
        const std::uint32_t here = edge / 3;
        const std::uint32_t there = opposite[edge] / 3;
        const auto& corners = mesh.triangles[here];
        const float length =
            (mesh.positions[corners[edge % 3]] - mesh.positions[corners[(edge + 1) % 3]]).norm();
        const bool isCrease = triangleNormal(mesh, here).dot(triangleNormal(mesh, there)) < crease;
        const float weight = (weights[here] + weights[there]) / 2;
        edges.push_back({here, there, length * weight * (isCrease ? creaseWeight : 1)});
    }
    return edges;
}

std::vector<LinePiece> zeroLine(const TriangleMesh& mesh, const std::vector<float>& field) {
    std::vector<LinePiece> line;
    for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const auto& corners = mesh.triangles[triangle];
        LinePiece piece{triangle, {}};
        std::size_t found = 0;
        for (std::size_t edge = 0; edge < 3 && found < 2; ++edge) {
            const std::uint32_t from = corners[edge];
            const std::uint32_t to = corners[(edge + 1) % 3];
            if ((field[from] >= 0) != (field[to] >= 0)) {
                const float share = field[from] / (field[from] - field[to]);
                piece.ends[found++] =
                    mesh.positions[from] + share * (mesh.positions[to] - mesh.positions[from]);
            }
        }
        if (found == 2) {
            line.push_back(piece);
        }
    }
    return line;
}

SeamCost seamCost(const std::vector<LinePiece>& line, const std::vector<float>& weights) {
    SeamCost sum;
    for (const LinePiece& piece : line) {
        const double length = double((piece.ends[1] - piece.ends[0]).norm());
        sum.length += length;
        sum.cost += length * double(weights[piece.triangle]);
    }
    return sum;
}

} // namespace dipwright
