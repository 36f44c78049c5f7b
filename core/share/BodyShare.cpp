#include "share/BodyShare.h"

#include "geometry/SurfaceDistance.h"
#include "share/JoinPlaces.h"
#include "share/MinimumCut.h"
#include "share/ShareMarks.h"
#include "share/SmoothJoin.h"
#include "share/Suitability.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::BodyShare)
};

// Constants of ours (docs/film-model.md, "Two dips, one body").
constexpr double fineTriangles = 40'000;   // about so many, if the body has fewer
constexpr double joinWeight = 20;          // mm² of body at cost 1 that a mm of join is worth
constexpr float nearReachEdge = 5;         // the cost of a mm² where the dip's film ends
constexpr double smoothing = 3;            // mm, and no less than two fine triangles
constexpr double reckonedStretches = 0.75; // share of the film along the join
constexpr double worthASwap = 1.1;         // times as much drawn out
constexpr double visibleStep = 0.1;        // of reflectance
constexpr double darkest = 0.01;           // reflectance of printed black
constexpr float farthest = 1e4f;           // mm
constexpr double leastUnpainted = 1;       // mm² of a place that is listed

using Films = std::array<std::shared_ptr<const LaidFilm>, 2>;
using Suitabilities = std::array<Suitability, 2>;

// What a dip reaches, position by position.
struct Reach {
    std::vector<float> depth;          // mm from its end; 0 past it, infinite where it reaches all
    std::vector<std::uint8_t> touches; // 1 where it reaches a triangle round the position
};
using Reaches = std::array<Reach, 2>;

Reach reachOf(const TriangleMesh& mesh, const std::vector<std::uint8_t>& reached) {
    std::vector<float> begin(mesh.positions.size(), std::numeric_limits<float>::infinity());
    std::vector<std::uint8_t> touches(mesh.positions.size());
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        for (const std::uint32_t corner : mesh.triangles[triangle]) {
            begin[corner] = reached[triangle] != 0 ? begin[corner] : 0;
            touches[corner] |= reached[triangle];
        }
    }
    return {surfaceDistance(mesh, std::move(begin)), std::move(touches)};
}

float meanOf(const std::vector<float>& values, const std::array<std::uint32_t, 3>& corners) {
    return (values[corners[0]] + values[corners[1]] + values[corners[2]]) / 3;
}

// What each fine triangle costs the first and the second dip.
std::vector<std::array<double, 2>> costsOf(const TriangleMesh& mesh, const Suitabilities& dips,
                                           const Reaches& reaches, float margin) {
    std::vector<std::array<double, 2>> costs(mesh.triangles.size());
    for (std::size_t triangle = 0; triangle < costs.size(); ++triangle) {
        const double area = triangleArea(mesh, triangle);
        for (std::size_t dip = 0; dip < 2; ++dip) {
            const float depth = meanOf(reaches[dip].depth, mesh.triangles[triangle]);
            const float edge = nearReachEdge * std::max(0.0f, 1 - depth / margin);
            costs[triangle][dip] = area * double(dips[dip].cost[triangle] + edge);
        }
    }
    for (std::size_t triangle = 0; triangle < costs.size(); ++triangle) {
        if (dips[0].reached[triangle] == 0 && dips[1].reached[triangle] == 0) {
            costs[triangle] = {0, 0};
        }
    }
    return costs;
}

std::vector<std::uint8_t> cutBody(const RefinedMesh& body, std::vector<std::array<double, 2>> costs,
                                  std::vector<float> weights, const ShareSettings& settings) {
    obeyMarks(body.mesh(), settings.marks, costs, weights);
    std::vector<CutEdge> edges = joinEdges(body, weights);
    for (CutEdge& edge : edges) {
        edge.cost *= joinWeight;
    }
    return minimumCut(costs, edges);
}

std::vector<std::uint32_t> trianglesOf(const std::vector<LinePiece>& line) {
    std::vector<std::uint32_t> triangles;
    for (const LinePiece& piece : line) {
        triangles.push_back(piece.triangle);
    }
    return triangles;
}

std::vector<LinearColour> coloursOf(const std::vector<std::uint32_t>& triangles,
                                    const std::vector<LinearColour>& colours) {
    std::vector<LinearColour> found;
    for (const std::uint32_t triangle : triangles) {
        found.push_back(colours[triangle]);
    }
    return found;
}

// How far film is drawn out that lies in any of these triangles, but for the most drawn out of it:
// so many times as far off as on the water it lies on the body.
double stretchOf(const std::vector<std::uint32_t>& triangles, const std::vector<float>& stretch,
                 double stretchLimit) {
    std::vector<float> stretches;
    for (const std::uint32_t triangle : triangles) {
        stretches.push_back(stretch[triangle]);
    }
    if (stretches.empty()) {
        return 1;
    }
    const auto least =
        stretches.begin() + std::ptrdiff_t(double(stretches.size() - 1) * reckonedStretches);
    std::nth_element(stretches.begin(), least, stretches.end());
    return std::clamp(double(*least), 1.0, stretchLimit);
}

std::vector<float> largerOf(const Suitabilities& dips) {
    std::vector<float> larger;
    for (std::size_t triangle = 0; triangle < dips[0].stretch.size(); ++triangle) {
        larger.push_back(std::max(dips[0].stretch[triangle], dips[1].stretch[triangle]));
    }
    return larger;
}

// The triangles that both dips reach.
std::vector<std::uint32_t> reachedByBoth(const Suitabilities& dips) {
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t triangle = 0; triangle < dips[0].reached.size(); ++triangle) {
        if (dips[0].reached[triangle] != 0 && dips[1].reached[triangle] != 0) {
            triangles.push_back(triangle);
        }
    }
    return triangles;
}

// Where the join is to be in the band, in halves of the band: 1 where the first dip is to give all
// the colour, −1 where the second is, for there is less room than a band between the ends of both.
float between(const Reaches& reaches, std::size_t position) {
    const float first = reaches[0].depth[position];
    const float second = reaches[1].depth[position];
    return first + second > 0
               ? (first - second) / (first + second)
               : float(reaches[0].touches[position]) - float(reaches[1].touches[position]);
}

// Moves the join so that the band lies where both dips reach: where one does not, the other gives
// all the colour.
void keepInReach(std::vector<float>& distance, const Reaches& reaches, float overlap) {
    for (std::size_t position = 0; position < distance.size(); ++position) {
        const float least = overlap / 2 - reaches[1].depth[position];
        const float most = reaches[0].depth[position] - overlap / 2;
        distance[position] = least > most ? overlap / 2 * between(reaches, position)
                                          : std::clamp(distance[position], least, most);
    }
}

Painter painterOf(float distance, float overlap, bool byFirst, bool bySecond) {
    const bool first = byFirst && distance > -overlap / 2;
    const bool second = bySecond && distance < overlap / 2;
    return first ? (second ? Painter::Both : Painter::First)
                 : (second ? Painter::Second : Painter::None);
}

double ShareAreas::*areaOf(Painter painter) {
    switch (painter) {
    case Painter::First:
        return &ShareAreas::first;
    case Painter::Second:
        return &ShareAreas::second;
    case Painter::Both:
        return &ShareAreas::both;
    case Painter::None:
        break;
    }
    return &ShareAreas::none;
}

void findPainters(BodyShare& share, const Suitabilities& dips) {
    const TriangleMesh& mesh = share.distance.mesh->mesh();
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const float distance = meanOf(share.distance.values, mesh.triangles[triangle]);
        const Painter painter =
            painterOf(distance, float(share.overlap), dips[0].reached[triangle] != 0,
                      dips[1].reached[triangle] != 0);
        share.painters.push_back(painter);
        (share.areas.*areaOf(painter)) += triangleArea(mesh, triangle);
    }
}

// The pieces of a line that lie where both dips paint: elsewhere nothing is joined.
std::vector<LinePiece> joining(std::vector<LinePiece> line, const Suitabilities& dips) {
    std::erase_if(line, [&](const LinePiece& piece) {
        return dips[0].reached[piece.triangle] == 0 || dips[1].reached[piece.triangle] == 0;
    });
    return line;
}

std::vector<UnpaintedPlace> unpaintedPlaces(const BodyShare& share) {
    const TriangleMesh& mesh = share.distance.mesh->mesh();
    const std::vector<std::uint32_t> opposite = oppositeEdges(mesh);
    const auto middle = [&](std::uint32_t triangle) { return position(mesh, middleOf(triangle)); };
    const auto isUnpainted = [&](std::uint32_t triangle) {
        return share.painters[triangle] == Painter::None;
    };
    std::vector<std::uint8_t> seen(mesh.triangles.size());
    std::vector<UnpaintedPlace> places;
    for (std::uint32_t start = 0; start < seen.size(); ++start) {
        if (seen[start] != 0 || !isUnpainted(start)) {
            continue;
        }
        const std::vector<std::uint32_t> triangles =
            connectedTriangles(opposite, start, isUnpainted, seen);
        double area = 0;
        Eigen::Vector3f mean = Eigen::Vector3f::Zero();
        for (const std::uint32_t triangle : triangles) {
            area += triangleArea(mesh, triangle);
            mean += float(triangleArea(mesh, triangle)) * middle(triangle);
        }
        if (area < leastUnpainted) {
            continue;
        }
        mean /= float(area);
        const std::uint32_t nearest = *std::min_element(
            triangles.begin(), triangles.end(), [&](std::uint32_t a, std::uint32_t b) {
                return (middle(a) - mean).squaredNorm() < (middle(b) - mean).squaredNorm();
            });
        places.push_back({area, middle(nearest)});
    }
    std::stable_sort(places.begin(), places.end(),
                     [](const auto& a, const auto& b) { return a.area > b.area; });
    return places;
}

// Above 0 on the side of the body that the first dip lets down first.
std::vector<float> equatorField(const TriangleMesh& mesh, const Films& films) {
    const auto down = [](const LaidFilm& laid) {
        return Eigen::Vector3f(
            (laid.body().modelToPose.rotation().transpose() * -Eigen::Vector3d::UnitY())
                .cast<float>());
    };
    const Eigen::Vector3f axis = down(*films[0]) - down(*films[1]);
    const Eigen::Vector3f middle = boundingBox(mesh).center();
    std::vector<float> field;
    for (const Eigen::Vector3f& place : mesh.positions) {
        field.push_back(axis.dot(place - middle));
    }
    return field;
}

} // namespace

std::optional<std::size_t> betterLast(const BodyShare& share) {
    const auto [first, second] = share.joinStretch;
    return second > worthASwap * first   ? std::optional<std::size_t>(0)
           : first > worthASwap * second ? std::optional<std::size_t>(1)
                                         : std::nullopt;
}

double neededOverlap(const std::vector<LinearColour>& colours, double error, double least) {
    double share = 1; // of the band that the error may be
    for (const LinearColour& colour : colours) {
        for (const float channel : colour) {
            const double light = std::clamp(double(channel), darkest, 0.999);
            // Density left out: light^(1 − x) − light. Too much of it: light − light^(1 + x).
            if (light + visibleStep < 1) {
                share = std::min(share, 1 - std::log(light + visibleStep) / std::log(light));
            }
            if (light > visibleStep) {
                share = std::min(share, std::log(light - visibleStep) / std::log(light) - 1);
            }
        }
    }
    return std::max(least, error / share);
}

BodyShare shareBody(const TexturedMesh& model, const Films& films, const ShareSettings& settings,
                    const InkSettings& ink, const Progress& progress) {
    const auto tell = [&](double done) { progress(done, Text::tr("Sharing out the body")); };
    tell(0);
    const float edge = edgeForTriangles(model.mesh, fineTriangles);
    const auto body = std::make_shared<const RefinedMesh>(model.mesh, edge);
    const TriangleMesh& mesh = body->mesh();
    const JoinPlaces places = joinPlaces(*body, model, SurfaceQuery(model.mesh));
    tell(0.3);
    Suitabilities dips;
    Reaches reaches;
    for (std::size_t dip = 0; dip < 2; ++dip) {
        dips[dip] = suitability(*body, *films[dip], places.colours, settings.stretchLimit, ink);
        reaches[dip] = reachOf(mesh, dips[dip].reached);
    }
    tell(0.6);
    // How far off the second film may lie on the body.
    const std::vector<float> larger = largerOf(dips);
    const auto errorOf = [&](const std::vector<std::uint32_t>& triangles) {
        return settings.registrationError.value() *
               stretchOf(triangles, larger, settings.stretchLimit);
    };
    const std::vector<std::uint32_t> twice = reachedByBoth(dips);
    const double widest =
        neededOverlap(coloursOf(twice, places.colours), errorOf(twice), settings.overlap.value());
    const auto margin = float(std::max(widest / 2 + errorOf(twice), 0.01));
    const std::vector<std::uint8_t> labels =
        cutBody(*body, costsOf(mesh, dips, reaches, margin), places.weights, settings);
    tell(0.8);
    BodyShare share;
    const double width = std::max(smoothing, 2 * double(edge));
    share.distance = {body, signedDistance(mesh, smoothBorder(mesh, labels, width), farthest)};
    const std::vector<std::uint32_t> along =
        trianglesOf(joining(zeroLine(mesh, share.distance.values), dips));
    share.overlap =
        neededOverlap(coloursOf(along, places.colours), errorOf(along), settings.overlap.value());
    for (std::size_t dip = 0; dip < 2; ++dip) {
        share.joinStretch[dip] = stretchOf(along, dips[dip].stretch, settings.stretchLimit);
    }
    keepInReach(share.distance.values, reaches, float(share.overlap));
    findPainters(share, dips);
    const std::vector<LinePiece> line = joining(zeroLine(mesh, share.distance.values), dips);
    share.cost = joinCost(line, places.weights);
    std::vector<float> equator = signedDistance(mesh, equatorField(mesh, films), farthest);
    keepInReach(equator, reaches, float(share.overlap));
    share.equator = joinCost(joining(zeroLine(mesh, equator), dips), places.weights);
    for (const LinePiece& piece : line) {
        share.join.push_back(piece.ends);
    }
    share.unpainted = unpaintedPlaces(share);
    tell(1);
    return share;
}

} // namespace dipwright
