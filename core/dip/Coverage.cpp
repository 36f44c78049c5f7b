#include "dip/Coverage.h"

#include "dip/TornFilm.h"
#include "dip/TrianglePieces.h"
#include "geometry/SurfaceSamples.h"
#include "parallel/ParallelFor.h"

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

constexpr double samplesPerFilmCell = 4;
// Number of samples along a side of a triangle; its square limits the samples per triangle.
constexpr int mostPieces = 64;
constexpr int samplesOfBody = 40'000;
// A connected bare surface is put down to torn film if this share of it lies at torn film.
constexpr double leastTornShare = 0.2;

// Result of the samples of one body triangle.
struct TriangleCover {
    double painted = 0;               // mm²
    double bare = 0, bareAtTorn = 0;  // mm² that film might have reached, and of it at torn film
    double masked = 0, maskedAir = 0; // mm², masked in all, and masked in trapped air
    double buried = 0;                // mm²
    MarkedArea marked;
    std::uint8_t marks = 0; // the marks that apply to at least half of the painted area
    bool isCovered = false; // at least half of what is not buried is painted or masked
};

TriangleCover triangleCover(const LaidFilm& laid, const TornFilm* torn, const SurfaceMask* mask,
                            std::size_t triangle, double sampleArea) {
    const double area = triangleArea(laid.body().mesh, triangle);
    const int pieces =
        int(std::clamp(std::ceil(std::sqrt(area / sampleArea)), 1.0, double(mostPieces)));
    const double pieceArea = area / (pieces * pieces);
    int hits = 0, masked = 0, maskedAir = 0, buried = 0;
    TriangleCover cover;
    forEachPiece(std::uint32_t(triangle), pieces, [&](const SurfacePoint& sample) {
        if (laid.body().isBuried(sample)) {
            ++buried;
        } else if (mask && mask->covers(sample)) {
            ++masked;
            maskedAir += laid.body().isDry(sample) ? 1 : 0;
        } else if (const auto place = laid.place(sample)) {
            ++hits;
            cover.marked.add(laid.marks(place->triangle), pieceArea);
        } else if (torn && torn->isInReach(sample)) {
            cover.bare += pieceArea;
            cover.bareAtTorn += torn->isAt(sample) ? pieceArea : 0;
        }
    });
    cover.painted = area * hits / (pieces * pieces);
    cover.masked = area * masked / (pieces * pieces);
    cover.maskedAir = area * maskedAir / (pieces * pieces);
    cover.buried = area * buried / (pieces * pieces);
    const int open = pieces * pieces - buried;
    cover.isCovered = open > 0 && 2 * (hits + masked) >= open;
    for (std::size_t mark = 0; mark < filmMarks.size(); ++mark) {
        if (hits > 0 && 2 * cover.marked.each[mark] >= cover.painted) {
            cover.marks |= std::uint8_t(filmMarks[mark]);
        }
    }
    return cover;
}

// Returns Coverage::tornBare. Beside torn film, the whole connected bare surface counts if torn
// film lies at enough of it: the body that passes a hole is bare beyond the hole, too. But a small
// tear does not explain a large bare surface.
double tornBare(const TriangleMesh& mesh, const std::vector<TriangleCover>& covers) {
    const std::vector<std::uint32_t> opposite = oppositeEdges(mesh);
    const auto isBare = [&](std::uint32_t triangle) { return covers[triangle].bare > 0; };
    std::vector<std::uint8_t> seen(covers.size(), 0);
    double area = 0;
    for (std::uint32_t start = 0; start < covers.size(); ++start) {
        if (!isBare(start) || seen[start] != 0) {
            continue;
        }
        double bare = 0, atTorn = 0;
        for (const std::uint32_t triangle : connectedTriangles(opposite, start, isBare, seen)) {
            bare += covers[triangle].bare;
            atTorn += covers[triangle].bareAtTorn;
        }
        area += atTorn >= leastTornShare * bare ? bare : atTorn;
    }
    return area;
}

} // namespace

Coverage coverage(const LaidFilm& laid, const SurfaceMask* mask, std::optional<Degrees> overhang) {
    const TriangleMesh& mesh = laid.body().mesh;
    const solver::FilmGrid& grid = laid.film().grid;
    const double sampleArea = grid.leastSpacingX() * grid.leastSpacingZ() / samplesPerFilmCell;
    const std::optional<TornFilm> found =
        overhang ? std::optional<TornFilm>(std::in_place, laid, *overhang) : std::nullopt;
    const TornFilm* torn = found && !found->isNone() ? &*found : nullptr;
    std::vector<TriangleCover> covers(mesh.triangles.size());
    parallelFor(std::size_t(0), mesh.triangles.size(), [&](std::size_t triangle) {
        covers[triangle] = triangleCover(laid, torn, mask, triangle, sampleArea);
    });
    Coverage result;
    double masked = 0, maskedAir = 0, buried = 0; // mm²
    for (const TriangleCover& cover : covers) {
        result.covered.push_back(cover.isCovered ? 1 : 0);
        result.marks.push_back(cover.marks);
        result.paintedArea += cover.painted;
        masked += cover.masked;
        maskedAir += cover.maskedAir;
        buried += cover.buried;
        result.marked.add(cover.marked);
    }
    result.tornBare = torn ? tornBare(mesh, covers) : 0;
    result.unburied = surfaceArea(mesh) - buried;
    const double open = result.unburied - masked;
    result.share = open > 0 ? result.paintedArea / open : 0;
    result.trappedAir = trappedAir(laid.body());
    result.trappedAir.area = std::max(result.trappedAir.area - maskedAir, 0.0);
    return result;
}

double coverageTogether(const std::vector<std::shared_ptr<const LaidFilm>>& films,
                        const Progress& progress, const SurfaceMask* mask) {
    const PosedBody& body = films.front()->body();
    std::vector<SurfacePoint> samples =
        evenSamples(body.mesh, surfaceArea(body.mesh) / samplesOfBody);
    std::erase_if(samples, [&](const SurfacePoint& place) {
        return (mask && mask->covers(place)) || body.isBuried(place);
    });
    std::vector<std::uint8_t> painted(samples.size());
    parallelFor(std::size_t(0), samples.size(), [&](std::size_t sample) {
        progress.cancelToken.throwIfCancelled();
        painted[sample] = std::any_of(films.begin(), films.end(), [&](const auto& laid) {
            return laid->place(samples[sample]).has_value();
        });
    });
    return double(std::count(painted.begin(), painted.end(), 1)) /
           double(std::max<std::size_t>(samples.size(), 1));
}

} // namespace dipwright
