#include "search/CoveragePreview.h"

#include "base/Error.h"
#include "dip/AirInPoses.h"
#include "dip/Pose.h"
#include "film/FilmGrid.h"
#include "geometry/BuriedSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright {
namespace {

constexpr double fewestTriangles = 6000;
constexpr float wallSlope = 0.25f; // faces with a smaller −n.y count as upright (n: normal)
constexpr float cellsOfSlack =
    1.5f; // allowed height of a face above its cell's lowest place, in cells
constexpr float steepestSlack = 4; // a slope that is steeper than this counts as this

// The height of the body's lowest place over each cell of the water.
class HeightField {
public:
    // `isClosed`: the mesh has no border, so that its lowest faces all point down.
    HeightField(const TriangleMesh& mesh, const std::vector<Eigen::Vector3f>& places,
                bool isClosed) {
        Eigen::AlignedBox2f box;
        for (const Eigen::Vector3f& place : places) {
            box.extend(Eigen::Vector2f(place.x(), place.z()));
        }
        cell_ = std::max(box.sizes().maxCoeff(), 1e-6f) / float(CoveragePreview::heightCells);
        perCell_ = 1 / cell_;
        corner_ = box.min();
        columns_ = int(box.sizes().x() * perCell_) + 1;
        rows_ = int(box.sizes().y() * perCell_) + 1;
        lowest_.assign(std::size_t(columns_) * std::size_t(rows_),
                       std::numeric_limits<float>::infinity());
        std::vector<Eigen::Vector3f> onGrid; // in cells, but for the height
        onGrid.reserve(places.size());
        for (const Eigen::Vector3f& place : places) {
            onGrid.push_back(inCells(place));
            lower(index(onGrid.back()), place.y());
        }
        for (const auto& corners : mesh.triangles) {
            add(onGrid[corners[0]], onGrid[corners[1]], onGrid[corners[2]], isClosed);
        }
    }

    float cell() const { return cell_; }
    float lowestAt(const Eigen::Vector3f& place) const { return lowest_[index(inCells(place))]; }

private:
    // How far outside a triangle a place is not taken for inside because of rounding, in cells.
    static constexpr float clearlyOutside = 0.05f;
    static constexpr float leastArea = 1e-10f; // twice the area, in cells

    void add(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c,
             bool isClosed) {
        const Eigen::Vector3f ab = b - a, ac = c - a;
        const float area = ab.x() * ac.z() - ab.z() * ac.x(); // positive: the face points down
        if (!((isClosed ? area : std::abs(area)) > leastArea)) {
            return; // the corners of a vertical triangle suffice
        }
        const int first = firstMiddle(std::min({a.x(), b.x(), c.x()}));
        const int last = lastMiddle(std::max({a.x(), b.x(), c.x()}), columns_);
        const int firstRow = firstMiddle(std::min({a.z(), b.z(), c.z()}));
        const int lastRow = lastMiddle(std::max({a.z(), b.z(), c.z()}), rows_);
        if (first > last || firstRow > lastRow) {
            return;
        }
        const float perArea = 1 / area;
        for (int row = firstRow; row <= lastRow; ++row) {
            const float z = float(row) + 0.5f - a.z();
            float* const lowest = &lowest_[std::size_t(row * columns_)];
            for (int column = first; column <= last; ++column) {
                const float x = float(column) + 0.5f - a.x();
                const float ofB = (x * ac.z() - z * ac.x()) * perArea;
                const float ofC = (ab.x() * z - ab.z() * x) * perArea;
                const float height = a.y() + ofB * ab.y() + ofC * ac.y();
                // Branches here would often be predicted wrongly.
                const bool isInside = (ofB >= 0) & (ofC >= 0) & (ofB + ofC <= 1);
                lowest[column] = isInside & (height < lowest[column]) ? height : lowest[column];
            }
        }
    }

    // The first and the last cell whose middle is in a range or not clearly outside it.
    static int firstMiddle(float least) { return int(least + 0.5f - clearlyOutside); }
    static int lastMiddle(float most, int cells) {
        return std::min(int(most - 0.5f + clearlyOutside), cells - 1);
    }
    Eigen::Vector3f inCells(const Eigen::Vector3f& place) const {
        return {(place.x() - corner_.x()) * perCell_, place.y(),
                (place.z() - corner_.y()) * perCell_};
    }
    std::size_t index(const Eigen::Vector3f& onGrid) const {
        const int column = std::clamp(int(onGrid.x()), 0, columns_ - 1);
        const int row = std::clamp(int(onGrid.z()), 0, rows_ - 1);
        return std::size_t(row * columns_ + column);
    }
    void lower(std::size_t at, float height) { lowest_[at] = std::min(lowest_[at], height); }

    Eigen::Vector2f corner_;
    float cell_ = 0, perCell_ = 0;
    int columns_ = 0, rows_ = 0;
    std::vector<float> lowest_;
};

bool isSeenFromBelow(const HeightField& heights, const Eigen::Vector3f& place, float up) {
    const float slope = std::sqrt(std::max(1 - up * up, 0.f)) / -up;
    const float slack = cellsOfSlack * heights.cell() * std::min(0.5f + slope, steepestSlack);
    return place.y() <= heights.lowestAt(place) + slack;
}

// Returns the y of the normal of the steepest upward face that is still painted
// (docs/film-model.md, "Where film does not go"). On a face whose normal has y = u, the solver lays
// a share g − (1 − g) u of the film's length. The grip g falls from 1 at u₁, where the fade begins,
// to 0 at u₀ + u₀ (u₀ − u₁), where u₀ is the y at the overhang. If the share is less than 1/t,
// the film is stretched by more than the tear stretch t.
float steepestPainted(const FilmSettings& film, const ProcessSettings& process) {
    const double overhang = std::sin(radians(process.overhang));
    if (!solver::isProductionFilm(film.lattice, film.support)) {
        return float(overhang);
    }
    const double fade = std::sin(radians(process.overhang) - radians(film.gripFade));
    const double zero = overhang + overhang * (overhang - fade);
    const double laid = zero - (zero - fade) / process.tearStretch;
    return float((std::sqrt((1 - fade) * (1 - fade) + 4 * laid) - (1 - fade)) / 2);
}

// Extends the covered area to all triangles that are connected with it through triangles for which
// `holds` is true.
template <typename Holds>
void spread(std::vector<std::uint8_t>& covered, const std::vector<std::uint32_t>& opposite,
            const Holds& holds) {
    std::vector<std::uint32_t> open;
    for (std::uint32_t triangle = 0; triangle < covered.size(); ++triangle) {
        if (covered[triangle] != 0) {
            open.push_back(triangle);
        }
    }
    while (!open.empty()) {
        const std::uint32_t triangle = open.back();
        open.pop_back();
        for (std::uint32_t edge = 3 * triangle; edge < 3 * triangle + 3; ++edge) {
            const std::uint32_t next = opposite[edge] == noEdge ? triangle : opposite[edge] / 3;
            if (covered[next] == 0 && holds(next)) {
                covered[next] = 1;
                open.push_back(next);
            }
        }
    }
}

// The body at a moment of the dip: its place in the world, without the shift below the water in a
// straight dip.
struct Moment {
    Moment(const TriangleMesh& mesh, bool isClosed, const Eigen::Isometry3f& place,
           const AirInPoses& air)
        : toWorld(place), upward(toWorld.linear().row(1).transpose()),
          heights(mesh, placed(mesh, toWorld), isClosed), dry(air.dry(upward)) {}
    static std::vector<Eigen::Vector3f> placed(const TriangleMesh& mesh,
                                               const Eigen::Isometry3f& toWorld) {
        std::vector<Eigen::Vector3f> places;
        places.reserve(mesh.positions.size());
        for (const Eigen::Vector3f& position : mesh.positions) {
            places.push_back(toWorld * position);
        }
        return places;
    }

    Eigen::Isometry3f toWorld;
    Eigen::Vector3f upward; // in the model's coordinates
    HeightField heights;
    std::vector<std::uint8_t> dry;
};

constexpr int momentsOnPath = 6;

// Returns moments at equal distances along the path. `path` is that of the model.
std::vector<Moment> momentsOnTheWay(const solver::BodyPath& path, const TriangleMesh& mesh,
                                    bool isClosed, const AirInPoses& air) {
    std::vector<Moment> moments;
    for (int i = 0; i < momentsOnPath; ++i) {
        const double way = path.poses.back().travelled * i / (momentsOnPath - 1);
        moments.emplace_back(mesh, isClosed, placeOnPath(path, way).cast<float>(), air);
    }
    return moments;
}

// Returns for each triangle the index of the moment nearest to that at which it goes under water;
// noMoment if it stays above.
constexpr std::uint8_t noMoment = 0xff;
std::vector<std::uint8_t> momentsOfEntry(const solver::BodyPath& path,
                                         const std::vector<Eigen::Vector3f>& middles) {
    std::vector<std::uint8_t> moments;
    moments.reserve(middles.size());
    for (const Eigen::Vector3f& middle : middles) {
        const auto way = firstUnderWater(path, middle.cast<double>());
        moments.push_back(way ? std::uint8_t(std::lround(*way / path.poses.back().travelled *
                                                         (momentsOnPath - 1)))
                              : noMoment);
    }
    return moments;
}

} // namespace

CoveragePreview::CoveragePreview(const TriangleMesh& model)
    : model_(model), fine_(model, edgeForTriangles(model, fewestTriangles)),
      opposite_(oppositeEdges(fine_.mesh())),
      air_(std::make_shared<const AirInPoses>(fine_.mesh())) {
    std::vector<SurfacePoint> middles;
    for (std::size_t triangle = 0; triangle < mesh().triangles.size(); ++triangle) {
        middles.push_back(middleOf(std::uint32_t(triangle)));
    }
    const std::vector<std::uint8_t> buried = buriedPlaces(mesh(), middles);
    for (std::size_t triangle = 0; triangle < middles.size(); ++triangle) {
        areas_.push_back(buried[triangle] != 0 ? 0 : float(triangleArea(mesh(), triangle)));
        normals_.push_back(triangleNormal(mesh(), triangle));
        middles_.push_back(position(mesh(), middles[triangle]));
        area_ += double(areas_.back());
    }
    isClosed_ = std::find(opposite_.begin(), opposite_.end(), noEdge) == opposite_.end();
}

PreviewedCoverage CoveragePreview::at(const Immersion& immersion, const FilmSettings& film,
                                      const ProcessSettings& process) const {
    const Eigen::Isometry3d pose = poseTransform(model_, immersion);
    solver::BodyPath path;
    if (!immersion.path.isStraightDown()) {
        try {
            path = pathOfModel(bodyPath(transformed(model_, pose), immersion, process), pose,
                               immersion);
        } catch (const Error&) {
            return {0, std::vector<std::uint8_t>(areas_.size(), 0)};
        }
    }
    return on(path, pose, immersion, film, process);
}

PreviewedCoverage CoveragePreview::on(const solver::BodyPath& path, const Eigen::Isometry3d& pose,
                                      const Immersion& immersion, const FilmSettings& film,
                                      const ProcessSettings& process) const {
    const bool isStraight = path.isStraightDown();
    std::vector<Moment> moments;
    std::vector<std::uint8_t> entries; // per triangle; empty: all at the only moment
    if (isStraight) {
        moments.emplace_back(mesh(), isClosed_, pose.cast<float>(), *air_);
    } else {
        moments = momentsOnTheWay(path, mesh(), isClosed_, *air_);
        entries = momentsOfEntry(path, middles_);
    }
    const float steepest = steepestPainted(film, process);
    const float deepest = isStraight && process.depth ? float(process.depth->value())
                                                      : std::numeric_limits<float>::infinity();
    const solver::FilmGrid grid = filmGrid(film);
    const Eigen::Vector2f reach(float(grid.width / 2), float(grid.depth / 2));
    const Eigen::Vector2f offset = isStraight ? Eigen::Vector2f(float(immersion.offset[0].value()),
                                                                float(immersion.offset[1].value()))
                                              : Eigen::Vector2f::Zero();
    // Returns the moment at which a triangle meets the film; null if it stays above the water.
    const auto momentOf = [&](std::uint32_t triangle) -> const Moment* {
        const std::uint8_t entry = entries.empty() ? 0 : entries[triangle];
        return entry == noMoment ? nullptr : &moments[entry];
    };
    // Whether a triangle at `place` is under water, over the film and outside trapped air.
    const auto canHold = [&](const Moment& moment, std::uint32_t triangle,
                             const Eigen::Vector3f& place) {
        const Eigen::Vector2f onWater = Eigen::Vector2f(place.x(), place.z()) + offset;
        return moment.dry[triangle] == 0 && place.y() <= deepest &&
               (onWater.cwiseAbs().array() <= reach.array()).all();
    };
    PreviewedCoverage result;
    result.covered.assign(areas_.size(), 0);
    for (std::uint32_t triangle = 0; triangle < areas_.size(); ++triangle) {
        const Moment* moment = momentOf(triangle);
        const float up = moment ? normals_[triangle].dot(moment->upward) : 0;
        if (up < -wallSlope) {
            const Eigen::Vector3f place = moment->toWorld * middles_[triangle];
            result.covered[triangle] =
                canHold(*moment, triangle, place) && isSeenFromBelow(moment->heights, place, up);
        }
    }
    spread(result.covered, opposite_, [&](std::uint32_t triangle) {
        const Moment* moment = momentOf(triangle);
        const float up = moment ? normals_[triangle].dot(moment->upward) : 1;
        return up >= -wallSlope && up <= steepest &&
               canHold(*moment, triangle, moment->toWorld * middles_[triangle]);
    });
    for (std::uint32_t triangle = 0; triangle < areas_.size(); ++triangle) {
        result.share += result.covered[triangle] != 0 ? double(areas_[triangle]) : 0;
    }
    result.share = area_ > 0 ? result.share / area_ : 0;
    return result;
}

std::vector<std::uint8_t> CoveragePreview::ofModel(const PreviewedCoverage& coverage) const {
    std::vector<float> painted(model_.triangles.size(), 0.f), whole(painted);
    for (std::size_t triangle = 0; triangle < areas_.size(); ++triangle) {
        const std::uint32_t coarse = fine_.middle(triangle).triangle;
        whole[coarse] += areas_[triangle];
        painted[coarse] += coverage.covered[triangle] != 0 ? areas_[triangle] : 0;
    }
    std::vector<std::uint8_t> covered;
    for (std::size_t triangle = 0; triangle < whole.size(); ++triangle) {
        covered.push_back(whole[triangle] > 0 && 2 * painted[triangle] >= whole[triangle] ? 1 : 0);
    }
    return covered;
}

} // namespace dipwright
