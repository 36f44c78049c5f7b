#include "pipeline/JobWarnings.h"

#include "dip/FilmMarks.h"
#include "geometry/RefinedMesh.h"
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

// The fine triangles of the job's part (fineBody() of the model), as coarse ones may be larger than
// the pieces that are looked for.
struct FineTriangles {
    std::shared_ptr<const RefinedMesh> body;
    std::vector<std::uint32_t> opposite; // oppositeEdges() of the fine mesh
    std::vector<SurfacePoint> middles;   // on the model's mesh

    explicit FineTriangles(const JobResult& result)
        : body(result.share ? result.share->fade.mesh : fineBody(result.project.model->mesh)),
          opposite(oppositeEdges(body->mesh())), middles(body->mesh().triangles.size()) {
        parallelFor(std::size_t(0), middles.size(),
                    [&](std::size_t triangle) { middles[triangle] = body->middle(triangle); });
    }

    // Returns `belongs` of each triangle's middle.
    template <typename Belongs>
    std::vector<std::uint8_t> that(const Belongs& belongs) const {
        std::vector<std::uint8_t> found(middles.size());
        parallelFor(std::size_t(0), found.size(),
                    [&](std::size_t triangle) { found[triangle] = belongs(middles[triangle]); });
        return found;
    }
};

// Adds the largest connected pieces of the fine triangles that are not masked and for which
// `belongs` is not 0.
void addPieces(std::vector<JobWarning>& warnings, WarningKind kind, std::size_t dip,
               const JobResult& result, const FineTriangles& fine,
               const std::vector<std::uint8_t>& belongs) {
    const auto isListed = [&](std::uint32_t triangle) {
        return belongs[triangle] != 0 &&
               !(result.mask && result.mask->covers(fine.middles[triangle]));
    };
    const TriangleMesh& mesh = fine.body->mesh();
    std::vector<SurfacePiece> pieces = surfacePieces(mesh, fine.opposite, isListed, leastArea);
    pieces.resize(std::min(pieces.size(), mostOfAKind));
    for (const SurfacePiece& piece : pieces) {
        warnings.push_back({kind, dip, position(mesh, middleOf(piece.middle)),
                            triangleNormal(mesh, piece.middle), piece.area});
    }
}

// Returns the triangles that dip `number` paints and whose middle needs more ink than the ink limit
// allows.
std::vector<std::uint8_t> paleTriangles(const JobResult& result, std::size_t number,
                                        const FineTriangles& fine) {
    const InkCompensation compensation(result.project.ink);
    std::vector<LinearColour> wanted = SurfaceColours(*result.painted).at(fine.middles);
    parallelFor(std::size_t(0), wanted.size(),
                [&](std::size_t at) { wanted[at] = compensation.toned(wanted[at]); });
    std::vector<std::uint8_t> pale =
        palePlaces(*result.immersions[number].laid, fine.middles, wanted, compensation);
    const Painter other = number == 0 ? Painter::Second : Painter::First;
    for (std::size_t triangle = 0; triangle < pale.size() && result.share; ++triangle) {
        pale[triangle] = pale[triangle] && result.share->painters[triangle] != other;
    }
    return pale;
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
    const FineTriangles fine(result);
    std::vector<JobWarning> warnings;
    for (std::size_t dip = 0; dip < result.immersions.size(); ++dip) {
        const ImmersionResult& immersion = result.immersions[dip];
        const Coverage& coverage = *immersion.coverage;
        if (coverage.trappedAir.area >= leastArea) {
            addPieces(
                warnings, WarningKind::TrappedAir, dip, result, fine,
                fine.that([&](const SurfacePoint& place) { return immersion.body->isDry(place); }));
        }
        for (const solver::PointMark mark : filmMarks) {
            if (coverage.marked.of(mark) >= leastArea) {
                addPieces(warnings, kindOf(mark), dip, result, fine,
                          fine.that([&](const SurfacePoint& place) {
                              return has(coverage.marks[place.triangle], mark);
                          }));
            }
        }
        if (result.painted && immersion.texture && immersion.texture->shortfallArea >= leastArea) {
            addPieces(warnings, WarningKind::TooPale, dip, result, fine,
                      paleTriangles(result, dip, fine));
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
