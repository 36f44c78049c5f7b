#include "marks/SurfaceMask.h"

#include "geometry/SurfaceSpot.h"
#include "parallel/ParallelFor.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Mask)
};

constexpr double sidesAcross = 2000; // the smallest side of a piece, relative to the body's size

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

} // namespace

SurfaceMask::SurfaceMask(std::shared_ptr<const TexturedMesh> model,
                         const std::vector<MaskMark>& marks)
    : model_(std::move(model)), concerns_(model_->mesh.triangles.size()),
      leastSide_(float(std::sqrt(surfaceArea(model_->mesh)) / sidesAcross)) {
    add(marks);
}

SurfaceMask::SurfaceMask(const SurfaceMask& before, const std::vector<MaskMark>& added)
    : SurfaceMask(before) {
    add(added);
}

void SurfaceMask::add(const std::vector<MaskMark>& marks) {
    const TriangleMesh& mesh = model_->mesh;
    std::unique_ptr<SurfaceQuery> query; // made if a mark needs it
    std::vector<std::uint32_t> opposite; // likewise
    for (const MaskMark& mark : marks) {
        marks_.push_back(mark);
        strokes_.emplace_back(mark.extent == MarkExtent::Stroke ? mark.path : BrushPath(),
                              mark.radius);
        const auto number = std::uint32_t(strokes_.size() - 1);
        if (mark.extent == MarkExtent::Stroke) {
            addStroke(number);
            continue;
        }
        if (!query) {
            query = std::make_unique<SurfaceQuery>(mesh);
        }
        const SurfacePoint at =
            query
                ->closest({float(mark.place[0].value()), float(mark.place[1].value()),
                           float(mark.place[2].value())})
                .point;
        if (!at.isValid()) {
            continue;
        }
        if (mark.extent == MarkExtent::Material) {
            std::vector<std::uint32_t> same;
            for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
                if (model_->material[triangle] == model_->material[at.triangle]) {
                    same.push_back(triangle);
                }
            }
            addWhole(number, same);
        } else {
            opposite = opposite.empty() ? oppositeEdges(mesh) : std::move(opposite);
            addWhole(number, faceAround(mesh, opposite, at.triangle));
        }
    }
}

void SurfaceMask::addWhole(std::uint32_t mark, const std::vector<std::uint32_t>& triangles) {
    for (const std::uint32_t triangle : triangles) {
        concerns_[triangle].assign(1, {mark, true});
    }
}

void SurfaceMask::addStroke(std::uint32_t mark) {
    const StrokeArea& stroke = strokes_[mark];
    const TriangleMesh& mesh = model_->mesh;
    parallelFor(std::size_t(0), concerns_.size(), [&](std::size_t triangle) {
        const auto corners = cornersOf(mesh, triangle);
        const BoundingBox box = BoundingBox(corners[0]).extend(corners[1]).extend(corners[2]);
        if (!box.intersects(stroke.box())) {
            return;
        }
        const Eigen::Vector3f middle = middleOf(corners);
        const float reach = farthest(corners, middle);
        const float distance =
            stroke.distance(middle, triangleNormal(mesh, triangle), stroke.radius() + reach);
        if (distance + reach <= stroke.radius()) {
            concerns_[triangle].assign(1, {mark, true});
        } else if (distance <= stroke.radius() + reach) {
            concerns_[triangle].push_back({mark, false});
        }
    });
}

float SurfaceMask::inside(std::uint32_t triangle, const Eigen::Vector3f& place) const {
    constexpr float far = std::numeric_limits<float>::infinity();
    float inside = -far;
    for (const Concern& concern : concerns_[triangle]) {
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
    return !concerns_[place.triangle].empty() &&
           inside(place.triangle, position(model_->mesh, place)) >= 0;
}

float SurfaceMask::finest(std::uint32_t triangle) const {
    float least = std::numeric_limits<float>::infinity();
    for (const Concern& concern : concerns_[triangle]) {
        if (!concern.isWhole) {
            least = std::min(least, sidePerRadius * strokes_[concern.mark].radius());
        }
    }
    return std::max(least, leastSide_);
}

std::vector<MarkedPiece> SurfaceMask::pieces() const {
    std::vector<MarkedPiece> pieces;
    for (std::uint32_t triangle = 0; triangle < concerns_.size(); ++triangle) {
        if (!concerns_[triangle].empty()) {
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
    std::vector<BoundingBox> boxes;
    const Eigen::Vector3f around = Eigen::Vector3f::Constant(MaskedAreas::joined / 2);
    for (const MarkedPiece& piece : pieces) {
        const auto& [a, b, c] = piece.corners;
        areas.area += double((b - a).cross(c - a).norm()) / 2;
        const BoundingBox box = BoundingBox(a).extend(b).extend(c);
        boxes.emplace_back(box.min() - around, box.max() + around);
    }
    // Joins pieces whose boxes overlap, swept along the longest axis (union–find).
    BoundingBox all;
    for (const BoundingBox& box : boxes) {
        all.extend(box);
    }
    int axis = 0;
    if (!all.isEmpty()) {
        all.sizes().maxCoeff(&axis);
    }
    std::vector<std::size_t> order(boxes.size()), parent(boxes.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::iota(parent.begin(), parent.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](std::size_t one, std::size_t other) {
        return boxes[one].min()[axis] < boxes[other].min()[axis];
    });
    const auto root = [&](std::size_t piece) {
        while (parent[piece] != piece) {
            piece = parent[piece] = parent[parent[piece]];
        }
        return piece;
    };
    std::vector<std::size_t> open; // boxes that the sweep is in
    for (const std::size_t piece : order) {
        std::erase_if(open, [&](std::size_t other) {
            return boxes[other].max()[axis] < boxes[piece].min()[axis];
        });
        for (const std::size_t other : open) {
            if (boxes[other].intersects(boxes[piece])) {
                parent[root(piece)] = root(other);
            }
        }
        open.push_back(piece);
    }
    for (std::size_t piece = 0; piece < parent.size(); ++piece) {
        areas.count += parent[piece] == piece ? 1 : 0;
    }
    return areas;
}

QString maskText(const MaskedAreas& areas) {
    return Text::tr("Masked areas: %1 (%2 mm²). Cover them with tape before the first dip.")
        .arg(areas.count)
        .arg(QLocale().toString(areas.area, 'f', 0));
}

} // namespace dipwright
