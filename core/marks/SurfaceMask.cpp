#include "marks/SurfaceMask.h"

#include "base/NumberText.h"
#include "geometry/SurfaceSpot.h"
#include "geometry/TriangleDistance.h"
#include "model/NamedMaterials.h"
#include "parallel/ParallelFor.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Mask)
};

constexpr double sidesAcross = 2000; // the smallest side of a piece, relative to the body's size
// Sides along the borders of all strokes; the pieces become larger instead of more. As many strokes
// as a project may hold need fewer if they are drawn with the brush.
constexpr double mostSides = 200'000;
constexpr std::size_t partLength = 1024; // triangles that one thread takes at once

Eigen::Vector3f middleOf(const std::array<Eigen::Vector3f, 3>& corners) {
    return (corners[0] + corners[1] + corners[2]) / 3;
}

float farthest(const std::array<Eigen::Vector3f, 3>& corners, const Eigen::Vector3f& from) {
    float most = 0;
    for (const Eigen::Vector3f& corner : corners) {
        most = std::max(most, (corner - from).norm());
    }
    return most;
}

TriangleMesh meshOf(const std::vector<MarkedPiece>& pieces) {
    TriangleMesh mesh;
    for (const MarkedPiece& piece : pieces) {
        const auto first = std::uint32_t(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), piece.corners.begin(), piece.corners.end());
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

// Joins pieces that are nearer to each other than MaskedAreas::joined (union–find).
std::size_t countOfAreas(const std::vector<MarkedPiece>& pieces) {
    if (pieces.empty()) {
        return 0;
    }
    const SurfaceQuery query(meshOf(pieces));
    std::vector<float> reach;
    for (const MarkedPiece& piece : pieces) {
        reach.push_back(farthest(piece.corners, middleOf(piece.corners)));
    }
    std::vector<std::size_t> parent(pieces.size());
    std::iota(parent.begin(), parent.end(), std::size_t(0));
    const auto root = [&](std::size_t piece) {
        while (parent[piece] != piece) {
            piece = parent[piece] = parent[parent[piece]];
        }
        return piece;
    };
    std::size_t count = pieces.size();
    for (std::size_t piece = 0; piece < pieces.size() && count > 1; ++piece) {
        const auto& corners = pieces[piece].corners;
        for (const std::size_t other :
             query.trianglesNear(middleOf(corners), reach[piece] + MaskedAreas::joined)) {
            // The smaller one of two pieces finds the larger one.
            const bool isLarger = std::pair(reach[other], other) > std::pair(reach[piece], piece);
            if (isLarger && root(piece) != root(other) &&
                triangleDistance(corners, pieces[other].corners) < double(MaskedAreas::joined)) {
                parent[root(piece)] = root(other);
                --count;
            }
        }
    }
    return count;
}

} // namespace

SurfaceMask::SurfaceMask(std::shared_ptr<const TexturedMesh> model,
                         const std::vector<MaskMark>& marks)
    : model_(std::move(model)), begins_(model_->mesh.triangles.size() + 1),
      leastSide_(float(std::sqrt(surfaceArea(model_->mesh)) / sidesAcross)) {
    add(marks);
}

SurfaceMask::SurfaceMask(const SurfaceMask& before, const std::vector<MaskMark>& added)
    : SurfaceMask(before) {
    add(added);
}

void SurfaceMask::add(const std::vector<MaskMark>& marks) {
    const auto first = std::uint32_t(marks_.size());
    for (const MaskMark& mark : marks) {
        marks_.push_back(mark);
        strokes_.emplace_back(mark.extent == MarkExtent::Stroke ? mark.path : BrushPath(),
                              mark.radius);
        sides_ += double(strokes_.back().borderLength() / sideOf(strokes_.back()));
    }
    const std::vector<std::uint32_t> whole = lastWhole(first);
    const std::size_t triangles = whole.size();
    std::vector<std::vector<Concern>> parts((triangles + partLength - 1) / partLength);
    std::vector<std::size_t> begins(triangles + 1);
    parallelFor(std::size_t(0), parts.size(), [&](std::size_t part) {
        const std::size_t end = std::min((part + 1) * partLength, triangles);
        for (std::size_t triangle = part * partLength; triangle < end; ++triangle) {
            const std::size_t before = parts[part].size();
            addConcerns(std::uint32_t(triangle), whole[triangle], first, parts[part]);
            begins[triangle + 1] = parts[part].size() - before;
        }
    });
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    begins_ = std::move(begins);
    concerns_.clear();
    concerns_.reserve(begins_.back());
    for (const std::vector<Concern>& part : parts) {
        concerns_.insert(concerns_.end(), part.begin(), part.end());
    }
}

// Returns for each triangle which mark from `first` on covers its face or material: the last one's
// number + 1; 0 if none does.
std::vector<std::uint32_t> SurfaceMask::lastWhole(std::uint32_t first) const {
    const TriangleMesh& mesh = model_->mesh;
    std::vector<std::uint32_t> last(mesh.triangles.size());
    std::vector<std::uint32_t> ofMaterial(model_->materials.size());
    std::optional<SurfaceQuery> query;   // made if a mark needs it
    std::vector<std::uint32_t> opposite; // likewise
    for (std::uint32_t mark = first; mark < marks_.size(); ++mark) {
        if (marks_[mark].extent == MarkExtent::Stroke) {
            continue;
        }
        if (!marks_[mark].material.isEmpty()) {
            for (const std::size_t material : materialsNamed(*model_, marks_[mark].material)) {
                ofMaterial[material] = mark + 1;
            }
            continue;
        }
        if (!query) {
            query.emplace(mesh);
        }
        const SurfacePoint at = query->closest(modelPlace(marks_[mark].place)).point;
        if (!at.isValid()) {
            continue;
        }
        if (marks_[mark].extent == MarkExtent::Material) {
            ofMaterial[model_->material[at.triangle]] = mark + 1;
            continue;
        }
        opposite = opposite.empty() ? oppositeEdges(mesh) : std::move(opposite);
        for (const std::uint32_t triangle : faceAround(mesh, opposite, at.triangle)) {
            last[triangle] = mark + 1;
        }
    }
    for (std::size_t triangle = 0; triangle < last.size(); ++triangle) {
        last[triangle] = std::max(last[triangle], ofMaterial[model_->material[triangle]]);
    }
    return last;
}

// Adds all concerns of a triangle to `found`: the earlier ones, then the concerns with the marks
// from number `first` on. `whole` is the result of lastWhole().
void SurfaceMask::addConcerns(std::uint32_t triangle, std::uint32_t whole, std::uint32_t first,
                              std::vector<Concern>& found) const {
    const auto begin = std::ptrdiff_t(found.size());
    if (whole > 0) {
        found.push_back({whole - 1, true});
    } else {
        const std::span<const Concern> earlier = concerns(triangle);
        found.insert(found.end(), earlier.begin(), earlier.end());
    }
    const auto corners = cornersOf(model_->mesh, triangle);
    const BoundingBox box = BoundingBox(corners[0]).extend(corners[1]).extend(corners[2]);
    const Eigen::Vector3f middle = middleOf(corners),
                          normal = triangleNormal(model_->mesh, triangle);
    const float reach = farthest(corners, middle);
    for (std::uint32_t mark = std::max(whole, first); mark < strokes_.size(); ++mark) {
        const StrokeArea& stroke = strokes_[mark];
        if (!box.intersects(stroke.box())) {
            continue;
        }
        const float distance = stroke.distance(middle, normal, stroke.radius() + reach);
        if (distance + reach <= stroke.radius()) {
            found.erase(found.begin() + begin, found.end());
            found.push_back({mark, true});
        } else if (distance <= stroke.radius() + reach) {
            found.push_back({mark, false});
        }
    }
}

std::span<const SurfaceMask::Concern> SurfaceMask::concerns(std::uint32_t triangle) const {
    return {concerns_.data() + begins_[triangle], begins_[triangle + 1] - begins_[triangle]};
}

float SurfaceMask::inside(std::uint32_t triangle, const Eigen::Vector3f& place) const {
    constexpr float far = std::numeric_limits<float>::infinity();
    float inside = -far;
    for (const Concern& concern : concerns(triangle)) {
        const StrokeArea& stroke = strokes_[concern.mark];
        const float here =
            concern.isWhole
                ? far
                : stroke.radius() - stroke.distance(place, triangleNormal(model_->mesh, triangle));
        inside = marks_[concern.mark].erases ? std::min(inside, -here) : std::max(inside, here);
    }
    return inside;
}

bool SurfaceMask::covers(const SurfacePoint& place) const {
    return !concerns(place.triangle).empty() &&
           inside(place.triangle, position(model_->mesh, place)) >= 0;
}

float SurfaceMask::sideOf(const StrokeArea& stroke) const {
    return std::max(sidePerRadius * stroke.radius(), leastSide_);
}

float SurfaceMask::finest(std::uint32_t triangle) const {
    float least = std::numeric_limits<float>::infinity();
    for (const Concern& concern : concerns(triangle)) {
        if (!concern.isWhole) {
            least = std::min(least, sideOf(strokes_[concern.mark]));
        }
    }
    return least * float(std::max(sides_ / mostSides, 1.0));
}

std::vector<MarkedPiece> SurfaceMask::pieces() const {
    std::vector<MarkedPiece> pieces;
    for (std::uint32_t triangle = 0; triangle + 1 < begins_.size(); ++triangle) {
        if (!concerns(triangle).empty()) {
            addPieces(
                {triangle, cornersOf(model_->mesh, triangle)},
                [&](const Eigen::Vector3f& place) { return inside(triangle, place); },
                finest(triangle), pieces);
        }
    }
    return pieces;
}

std::shared_ptr<const SurfaceMask> surfaceMask(std::shared_ptr<const TexturedMesh> model,
                                               const std::vector<MaskMark>& marks,
                                               const std::shared_ptr<const SurfaceMask>& earlier) {
    if (marks.empty()) {
        return nullptr;
    }
    if (!earlier || earlier->model() != model || earlier->marks().size() > marks.size() ||
        !std::equal(earlier->marks().begin(), earlier->marks().end(), marks.begin())) {
        return std::make_shared<const SurfaceMask>(std::move(model), marks);
    }
    const std::vector<MaskMark> added(marks.begin() + std::ptrdiff_t(earlier->marks().size()),
                                      marks.end());
    return added.empty() ? earlier : std::make_shared<const SurfaceMask>(*earlier, added);
}

MaskedAreas maskedAreas(const SurfaceMask& mask) {
    const std::vector<MarkedPiece> pieces = mask.pieces();
    MaskedAreas areas;
    areas.count = countOfAreas(pieces);
    for (const MarkedPiece& piece : pieces) {
        const auto& [a, b, c] = piece.corners;
        areas.area += double((b - a).cross(c - a).norm()) / 2;
    }
    return areas;
}

QString maskText(const MaskedAreas& areas) {
    return Text::tr("Masked areas: %1 (%2 mm²). Cover them with tape before the first dip.")
        .arg(areas.count)
        .arg(numberText(areas.area, 0));
}

} // namespace dipwright
