#include "share/BodyShare.h"

#include "parallel/Tasks.h"
#include "share/FadeOverlap.h"
#include "share/MinimumCut.h"
#include "share/SeamPlaces.h"
#include "share/ShareMarks.h"
#include "share/SmoothSeam.h"
#include "share/Suitability.h"
#include "share/UnpaintedPlaces.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::BodyShare)
};

// Chosen constants (docs/film-model.md, "Two dips, one body").
// 1 mm of seam costs as much as this many mm² of body at cost 1.
constexpr double seamWeight = 20;
constexpr float reachEdgeCost = 5; // cost of 1 mm² of body at the end of a dip's film
// In overlap widths: distance from the film's end at which reachEdgeCost has fallen to 0.
constexpr float reachEdgeWidth = 0.75f;
constexpr double smoothing = 3;          // width of the smoothing, mm; at least two fine triangles
constexpr double stretchQuantile = 0.75; // quantile of the stretches along the seam
// Ratio of the two films' stretches from which a dip order is recommended.
constexpr double leastSwapRatio = 1.1;
constexpr float farthest = 1e4f; // in overlap widths: limit of distances from the seam

using Films = std::array<std::shared_ptr<const LaidFilm>, 2>;
using Suitabilities = std::array<Suitability, 2>;

// The part of the body that a dip reaches, per mesh position.
struct Reach {
    // Distance from the end of the dip's film, in overlap widths; 0 where the film does not reach,
    // infinite if the film reaches everything.
    std::vector<float> depth;
    std::vector<std::uint8_t> touches; // 1 if the dip reaches a triangle at the position
};
using Reaches = std::array<Reach, 2>;

Reach reachOf(const TriangleMesh& mesh, const std::vector<std::uint8_t>& reached,
              const UnfoldedTriangles& bands) {
    std::vector<float> begin(mesh.positions.size(), std::numeric_limits<float>::infinity());
    std::vector<std::uint8_t> touches(mesh.positions.size());
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        for (const std::uint32_t corner : mesh.triangles[triangle]) {
            begin[corner] = reached[triangle] != 0 ? begin[corner] : 0;
            touches[corner] |= reached[triangle];
        }
    }
    constexpr float everywhere = std::numeric_limits<float>::infinity();
    return {surfaceDistance(mesh, std::move(begin), everywhere, bands), std::move(touches)};
}

float meanOf(const std::vector<float>& values, const std::array<std::uint32_t, 3>& corners) {
    return (values[corners[0]] + values[corners[1]] + values[corners[2]]) / 3;
}

// Returns the cost of each fine triangle for the first and the second dip.
std::vector<std::array<double, 2>> costsOf(const TriangleMesh& mesh, const Suitabilities& dips,
                                           const Reaches& reaches) {
    std::vector<std::array<double, 2>> costs(mesh.triangles.size());
    for (std::size_t triangle = 0; triangle < costs.size(); ++triangle) {
        const double area = triangleArea(mesh, triangle);
        for (std::size_t dip = 0; dip < 2; ++dip) {
            const float depth = meanOf(reaches[dip].depth, mesh.triangles[triangle]);
            const float edge = reachEdgeCost * std::max(0.0f, 1 - depth / reachEdgeWidth);
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

using AssignedDips = std::vector<std::optional<std::size_t>>; // per fine triangle, by marks

struct Cut {
    std::vector<std::uint8_t> labels; // per fine triangle
    AssignedDips assigned;
};

Cut cutBody(const RefinedMesh& body, std::vector<std::array<double, 2>> costs,
            std::vector<float> weights, const ShareSettings& settings) {
    AssignedDips assigned = applyShareMarks(body.mesh(), settings.marks, costs, weights);
    std::vector<CutEdge> edges = seamCutEdges(body, weights);
    for (CutEdge& edge : edges) {
        edge.cost *= seamWeight;
    }
    return {minimumCut(costs, edges), std::move(assigned)};
}

std::vector<std::uint32_t> trianglesOf(const std::vector<LinePiece>& line) {
    std::vector<std::uint32_t> triangles;
    for (const LinePiece& piece : line) {
        triangles.push_back(piece.triangle);
    }
    return triangles;
}

// Returns the third quartile of the film's stretch in these triangles. A displacement on the water
// is multiplied by this stretch on the body.
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
        stretches.begin() + std::ptrdiff_t(double(stretches.size() - 1) * stretchQuantile);
    std::nth_element(stretches.begin(), least, stretches.end());
    return std::clamp(double(*least), 1.0, stretchLimit);
}

// Returns the fade where the films overlap by less than the overlap width. The fade is ½ where only
// the first dip gives colour and −½ where only the second does.
float fadeBetween(const Reaches& reaches, std::size_t position) {
    const float first = reaches[0].depth[position];
    const float second = reaches[1].depth[position];
    return first + second > 0
               ? (first - second) / (first + second) / 2
               : float(reaches[0].touches[position] - reaches[1].touches[position]) / 2;
}

// Moves the seam so that the overlap lies where both dips reach. A place that only one dip reaches
// gets all its colour from that dip.
void keepInReach(std::vector<float>& fade, const Reaches& reaches) {
    for (std::size_t position = 0; position < fade.size(); ++position) {
        const float least = 0.5f - reaches[1].depth[position];
        const float most = reaches[0].depth[position] - 0.5f;
        fade[position] =
            least > most ? fadeBetween(reaches, position) : std::clamp(fade[position], least, most);
    }
}

Painter painterOf(float fade, bool byFirst, bool bySecond) {
    const bool first = byFirst && fade > -0.5f;
    const bool second = bySecond && fade < 0.5f;
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

void findPainters(BodyShare& share, const Suitabilities& dips, const PosedBody& body) {
    const RefinedMesh& fine = *share.fade.mesh;
    const TriangleMesh& mesh = fine.mesh();
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const Painter painter =
            painterOf(meanOf(share.fade.values, mesh.triangles[triangle]),
                      dips[0].reached[triangle] != 0, dips[1].reached[triangle] != 0);
        const double area = triangleArea(mesh, triangle);
        share.painters.push_back(painter);
        if (painter != Painter::None || !body.isBuried(fine.middle(std::uint32_t(triangle)))) {
            (share.areas.*areaOf(painter)) += area;
        }
    }
}

// Returns the share of the assigned and painted area that only the other dip paints.
double misassignedShare(const TriangleMesh& mesh, const AssignedDips& assigned,
                        const std::vector<Painter>& painters) {
    double painted = 0, byOther = 0;
    for (std::size_t triangle = 0; triangle < assigned.size(); ++triangle) {
        if (assigned[triangle] && painters[triangle] != Painter::None) {
            const double area = triangleArea(mesh, triangle);
            painted += area;
            const Painter other = *assigned[triangle] == 0 ? Painter::Second : Painter::First;
            byOther += painters[triangle] == other ? area : 0;
        }
    }
    return painted > 0 ? byOther / painted : 0;
}

OverlapWidth overlapAlong(const std::vector<LinePiece>& line, const TriangleMesh& mesh,
                          const std::vector<float>& fade) {
    std::vector<double> widths;
    for (const LinePiece& piece : line) {
        widths.push_back(1 / std::max(double(steepness(mesh, piece.triangle, fade)), 1e-3));
    }
    if (widths.empty()) {
        return {};
    }
    std::sort(widths.begin(), widths.end());
    const auto at = [&](double share) {
        return widths[std::size_t(share * double(widths.size() - 1))];
    };
    return {at(0.05), at(0.5), at(0.95)};
}

// Keeps the pieces of a line where both dips paint; elsewhere there is no seam.
std::vector<LinePiece> seamPieces(std::vector<LinePiece> line, const Suitabilities& dips) {
    std::erase_if(line, [&](const LinePiece& piece) {
        return dips[0].reached[piece.triangle] == 0 || dips[1].reached[piece.triangle] == 0;
    });
    return line;
}

// Runs both functions at the same time.
void inParallel(const std::function<void()>& first, const std::function<void()>& second) {
    Tasks tasks;
    tasks.run(second);
    runIsolated(first);
    tasks.wait();
}

// Returns a field that is positive on the side of the body that faces down in the first dip.
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

struct ShareStage {
    ShareStage(const TexturedMesh& model, std::shared_ptr<const RefinedMesh> fine)
        : edge(fineEdge(model.mesh)), body(std::move(fine)),
          places(seamPlaces(*body, model, SurfaceQuery(model.mesh))) {}

    float edge; // longest edge of the fine triangles, mm
    std::shared_ptr<const RefinedMesh> body;
    SeamPlaces places;
};

std::shared_ptr<const ShareStage> shareStage(const TexturedMesh& model,
                                             std::shared_ptr<const RefinedMesh> fine) {
    return std::make_shared<const ShareStage>(model, std::move(fine));
}

std::optional<std::size_t> recommendedLastDip(const BodyShare& share) {
    const auto [first, second] = share.seamStretch;
    return second > leastSwapRatio * first   ? std::optional<std::size_t>(0)
           : first > leastSwapRatio * second ? std::optional<std::size_t>(1)
                                             : std::nullopt;
}

BodyShare shareBody(const ShareStage& stage, const Films& films, const ShareSettings& settings,
                    const InkSettings& ink, const Progress& progress) {
    const auto reportProgress = [&](double done) {
        progress(done, Text::tr("Splitting the part between the dips"));
    };
    reportProgress(0);
    const RefinedMesh& body = *stage.body;
    const TriangleMesh& mesh = body.mesh();
    const SeamPlaces& places = stage.places;
    std::optional<FadeOverlap> overlap;
    Suitabilities dips;
    inParallel([&] { overlap.emplace(body, *films[1], places.colours, settings); },
               [&] {
                   for (std::size_t dip = 0; dip < 2; ++dip) {
                       dips[dip] = suitability(body, *films[dip], places.colours,
                                               settings.stretchLimit, ink);
                   }
               });
    const FadeOverlap& band = *overlap;
    reportProgress(0.3);
    Reaches reaches;
    inParallel([&] { reaches[0] = reachOf(mesh, dips[0].reached, band.measure()); },
               [&] { reaches[1] = reachOf(mesh, dips[1].reached, band.measure()); });
    reportProgress(0.6);
    Cut cut;
    std::vector<float> equator;
    inParallel([&] { cut = cutBody(body, costsOf(mesh, dips, reaches), places.weights, settings); },
               [&] {
                   equator =
                       signedDistance(mesh, equatorField(mesh, films), farthest, band.measure());
                   keepInReach(equator, reaches);
               });
    reportProgress(0.8);
    BodyShare share;
    share.narrowest = band.narrowest();
    const double width = std::max(smoothing, 2 * double(stage.edge));
    share.fade = {stage.body, signedDistance(mesh, smoothBorder(mesh, cut.labels, width), farthest,
                                             band.measure())};
    keepInReach(share.fade.values, reaches);
    findPainters(share, dips, films[0]->body());
    share.misassigned = misassignedShare(mesh, cut.assigned, share.painters);
    share.narrow = band.tooNarrow(share.fade.values, share.painters);
    const std::vector<LinePiece> line = seamPieces(zeroLine(mesh, share.fade.values), dips);
    for (std::size_t dip = 0; dip < 2; ++dip) {
        share.seamStretch[dip] =
            stretchOf(trianglesOf(line), dips[dip].stretch, settings.stretchLimit);
    }
    share.overlap = overlapAlong(line, mesh, share.fade.values);
    share.cost = seamCost(line, places.weights);
    share.equator = seamCost(seamPieces(zeroLine(mesh, equator), dips), places.weights);
    for (const LinePiece& piece : line) {
        share.join.push_back(piece.ends);
    }
    share.unpainted = unpaintedPlaces(share, films[0]->body(), nullptr);
    reportProgress(1);
    return share;
}

} // namespace dipwright
