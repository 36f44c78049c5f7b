#include "pipeline/JobWarnings.h"

#include "dip/FilmMarks.h"
#include "geometry/SurfacePieces.h"
#include "parallel/ParallelFor.h"
#include "pipeline/JobVerdict.h"
#include "texture/PalePlaces.h"
#include "texture/ReverseTexture.h"
#include "texture/SurfaceColours.h"

#include <algorithm>
#include <utility>

namespace dipwright {
namespace {

constexpr std::size_t mostOfAKind = 4; // of each dip
constexpr double leastArea = 2;        // mm²

// Adds the largest connected pieces of the triangles that are not masked and for which `belongs` is
// not 0.
void addPieces(std::vector<JobWarning>& warnings, WarningKind kind, std::size_t dip,
               const JobResult& result, const std::vector<std::uint32_t>& opposite,
               std::vector<std::uint8_t> belongs) {
    const TriangleMesh& mesh = result.project.model->mesh;
    for (std::uint32_t triangle = 0; triangle < belongs.size() && result.mask; ++triangle) {
        belongs[triangle] = belongs[triangle] && !result.mask->covers(middleOf(triangle));
    }
    std::vector<SurfacePiece> pieces = surfacePieces(
        mesh, opposite, [&](std::uint32_t triangle) { return belongs[triangle] != 0; }, leastArea);
    pieces.resize(std::min(pieces.size(), mostOfAKind));
    for (const SurfacePiece& piece : pieces) {
        warnings.push_back({kind, dip, position(mesh, middleOf(piece.middle)),
                            triangleNormal(mesh, piece.middle), piece.area});
    }
}

std::vector<std::uint8_t> dryTriangles(const PosedBody& body) {
    std::vector<std::uint8_t> dry(body.mesh.triangles.size());
    parallelFor(std::size_t(0), dry.size(), [&](std::size_t triangle) {
        dry[triangle] = body.isDry(middleOf(std::uint32_t(triangle)));
    });
    return dry;
}

// Triangles whose middle needs more ink than the ink limit allows.
std::vector<std::uint8_t> paleTriangles(const ImmersionResult& dip, const TexturedMesh& painted,
                                        const InkSettings& ink) {
    std::vector<SurfacePoint> middles(painted.mesh.triangles.size());
    for (std::uint32_t triangle = 0; triangle < middles.size(); ++triangle) {
        middles[triangle] = middleOf(triangle);
    }
    const InkCompensation compensation(ink);
    std::vector<LinearColour> wanted = SurfaceColours(painted).at(middles);
    parallelFor(std::size_t(0), wanted.size(),
                [&](std::size_t at) { wanted[at] = compensation.toned(wanted[at]); });
    return palePlaces(*dip.laid, middles, wanted, compensation);
}

void addNotReached(std::vector<JobWarning>& warnings, const JobResult& result) {
    const SurfaceQuery query(result.project.model->mesh);
    std::size_t count = 0;
    for (const UnpaintedPlace& place : unreachedPlaces(result)) {
        if (place.area >= leastArea && count++ < mostOfAKind) {
            const SurfacePoint point = query.closest(place.place).point;
            warnings.push_back({WarningKind::NotReached, std::nullopt, place.place,
                                triangleNormal(result.project.model->mesh, point.triangle),
                                place.area});
        }
    }
}

WarningKind kindOf(solver::PointMark mark) {
    return mark == solver::PointMark::Torn         ? WarningKind::Torn
           : mark == solver::PointMark::Unbalanced ? WarningKind::Unbalanced
                                                   : WarningKind::Released;
}

} // namespace

std::vector<JobWarning> jobWarnings(const JobResult& result) {
    const std::vector<std::uint32_t> opposite = oppositeEdges(result.project.model->mesh);
    std::vector<JobWarning> warnings;
    for (std::size_t dip = 0; dip < result.immersions.size(); ++dip) {
        const ImmersionResult& immersion = result.immersions[dip];
        const Coverage& coverage = *immersion.coverage;
        if (coverage.trappedAir.area >= leastArea) {
            addPieces(warnings, WarningKind::TrappedAir, dip, result, opposite,
                      dryTriangles(*immersion.body));
        }
        for (const solver::PointMark mark : filmMarks) {
            if (coverage.marked.of(mark) >= leastArea) {
                std::vector<std::uint8_t> marked(coverage.marks.size());
                std::transform(
                    coverage.marks.begin(), coverage.marks.end(), marked.begin(),
                    [mark](std::uint8_t marks) { return std::uint8_t(has(marks, mark)); });
                addPieces(warnings, kindOf(mark), dip, result, opposite, std::move(marked));
            }
        }
    }
    for (std::size_t dip = 0; dip < result.immersions.size() && result.painted; ++dip) {
        const ImmersionResult& immersion = result.immersions[dip];
        if (immersion.texture && immersion.texture->shortfallArea >= leastArea) {
            addPieces(warnings, WarningKind::TooPale, dip, result, opposite,
                      paleTriangles(immersion, *result.painted, result.project.ink));
        }
    }
    if (result.share) {
        addNotReached(warnings, result);
    }
    std::stable_sort(warnings.begin(), warnings.end(),
                     [](const JobWarning& a, const JobWarning& b) { return a.kind < b.kind; });
    return warnings;
}

} // namespace dipwright
