#include "dip/FilledField.h"

#include "parallel/ParallelFor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace dipwright {

namespace {

// Depth in the filled body up to which distances are computed, in cells.
constexpr int exactCells = 5;
// Each iteration spreads distances by one sample. The remaining iterations let them converge.
constexpr int iterations = 2 * exactCells + 2;
// In cells: a new distance replaces the body's own one only if it is larger by this much.
constexpr float clearlyMore = 0.25f;
// In cells of the air grid. A pocket is looked up this far above its level, surely inside it.
constexpr float overLevel = 0.02f;

using Index = Eigen::Matrix<std::ptrdiff_t, 3, 1>;

class Filling {
public:
    Filling(const PosedBody& body, const DistanceField& own, DistanceField& filled)
        : body_(body), own_(own), filled_(filled),
          deepest_(float(exactCells * own.spacing)), strides_{1, own.size[0],
                                                              std::ptrdiff_t(own.size[0]) *
                                                                  own.size[1]} {}

    void fill() {
        forEachSample([&](std::size_t sample, const Eigen::Vector3f& place) {
            if (own_.distance[sample] >= 0) {
                filled_.distance[sample] = filledOver(own_.distance[sample], place);
            }
        });
        const std::vector<std::size_t> inside = insideNearPockets();
        std::vector<float> next(inside.size());
        for (const std::size_t sample : inside) {
            filled_.distance[sample] = -deepest_;
        }
        for (int i = 0; i < iterations; ++i) {
            parallelFor(std::size_t(0), inside.size(),
                        [&](std::size_t at) { next[at] = depthAt(inside[at]); });
            parallelFor(std::size_t(0), inside.size(),
                        [&](std::size_t at) { filled_.distance[inside[at]] = -next[at]; });
        }
        parallelFor(std::size_t(0), inside.size(), [&](std::size_t at) {
            const std::size_t sample = inside[at];
            const float own = own_.distance[sample];
            const bool isWall = own < 0;
            if (isWall && next[at] < -own + clearlyMore * float(own_.spacing)) {
                filled_.distance[sample] = own;
            }
        });
        if (isTilting(body_.path)) {
            bringNearer();
        }
    }

private:
    // Lowers the distances outside the filled body so that none exceeds the distance to a pocket
    // along the grid's axes. The pockets of a body that tilts have no flat level, which would give
    // the distance to them.
    void bringNearer() {
        const int width = own_.size[0], height = own_.size[1], depth = own_.size[2];
        const auto lower = [&](int i, int j, int k, std::ptrdiff_t towards) {
            const std::ptrdiff_t sample = i + strides_[1] * j + strides_[2] * k;
            float& distance = filled_.distance[std::size_t(sample)];
            for (const auto& [axis, at, last] :
                 {std::tuple(0, i, width), std::tuple(1, j, height), std::tuple(2, k, depth)}) {
                const bool hasNeighbour = towards < 0 ? at > 0 : at + 1 < last;
                if (hasNeighbour && distance > 0) {
                    const std::ptrdiff_t other = sample + towards * strides_[std::size_t(axis)];
                    distance =
                        std::min(distance, std::max(filled_.distance[std::size_t(other)], 0.f) +
                                               float(own_.spacing));
                }
            }
        };
        for (int sweep = 0; sweep < 2; ++sweep) {
            for (int k = 0; k < depth; ++k) {
                for (int j = 0; j < height; ++j) {
                    for (int i = 0; i < width; ++i) {
                        lower(i, j, k, -1);
                    }
                }
            }
            for (int k = depth; k-- > 0;) {
                for (int j = height; j-- > 0;) {
                    for (int i = width; i-- > 0;) {
                        lower(i, j, k, 1);
                    }
                }
            }
        }
    }

    // Calls visit(sample, place) for all samples that pockets may change; `place` is in the pose
    // frame. Uses all cores.
    template <typename Visit>
    void forEachSample(const Visit& visit) const {
        const Eigen::AlignedBox<std::ptrdiff_t, 3> box = changedBox();
        const Eigen::Isometry3f pose = body_.bodyToPose.cast<float>();
        parallelFor(box.min()[2], box.max()[2] + 1, [&](std::ptrdiff_t k) {
            for (std::ptrdiff_t j = box.min()[1]; j <= box.max()[1]; ++j) {
                for (std::ptrdiff_t i = box.min()[0]; i <= box.max()[0]; ++i) {
                    const Eigen::Vector3d place =
                        own_.origin +
                        own_.spacing * Eigen::Vector3d(double(i), double(j), double(k));
                    visit(std::size_t(i + strides_[1] * j + strides_[2] * k),
                          Eigen::Vector3f(pose * place.cast<float>()));
                }
            }
        });
    }

    // Returns the range of samples in and round the pockets, and from there down to the field's
    // end.
    Eigen::AlignedBox<std::ptrdiff_t, 3> changedBox() const {
        const double bottom = -(own_.size[0] + own_.size[1] + own_.size[2]) * own_.spacing;
        const Eigen::Isometry3d fromPose = body_.bodyToPose.inverse();
        Eigen::AlignedBox3d cells;
        for (const AirPocket& pocket : body_.air.all()) {
            Eigen::AlignedBox3d box(pocket.box.min().cast<double>(),
                                    pocket.box.max().cast<double>());
            box.extend(Eigen::Vector3d(box.min().x(), bottom, box.min().z()));
            for (int corner = 0; corner < 8; ++corner) {
                const Eigen::Vector3d at =
                    fromPose * box.corner(Eigen::AlignedBox3d::CornerType(corner));
                cells.extend(Eigen::Vector3d((at - own_.origin) / own_.spacing));
            }
        }
        Eigen::AlignedBox<std::ptrdiff_t, 3> box;
        for (int axis = 0; axis < 3; ++axis) {
            // Leave out the outermost samples, which lack neighbours.
            const double last = own_.size[std::size_t(axis)] - 2;
            box.min()[axis] =
                std::ptrdiff_t(std::clamp(std::floor(cells.min()[axis]) - exactCells, 1.0, last));
            box.max()[axis] =
                std::ptrdiff_t(std::clamp(std::ceil(cells.max()[axis]) + exactCells, 1.0, last));
        }
        return box;
    }

    // Returns how far a place outside the body is from the filled body. `own` is the place's
    // distance from the body itself. The result is negative in a pocket. Below a pocket it is at
    // most the distance to the pocket's level.
    float filledOver(float own, const Eigen::Vector3f& place) const {
        if (body_.air.at(place, body_.query)) {
            return -deepest_;
        }
        float distance = own;
        for (const AirPocket& pocket : body_.air.all()) {
            const float below = float(pocket.level) - place.y();
            const bool isUnder =
                below >= 0 && below < distance && place.x() > pocket.box.min().x() &&
                place.x() < pocket.box.max().x() && place.z() > pocket.box.min().z() &&
                place.z() < pocket.box.max().z();
            const Eigen::Vector3f air(place.x(), float(pocket.level) + overLevel * body_.air.cell(),
                                      place.z());
            if (isUnder && body_.air.at(air, body_.query) == &pocket) {
                distance = below;
            }
        }
        return distance;
    }

    // Returns the samples in pockets, and the samples in walls at most `deepest_` below the
    // surface.
    std::vector<std::size_t> insideNearPockets() const {
        const Eigen::AlignedBox<std::ptrdiff_t, 3> box = changedBox();
        std::vector<std::size_t> samples;
        for (std::ptrdiff_t k = box.min()[2]; k <= box.max()[2]; ++k) {
            for (std::ptrdiff_t j = box.min()[1]; j <= box.max()[1]; ++j) {
                for (std::ptrdiff_t i = box.min()[0]; i <= box.max()[0]; ++i) {
                    const auto sample = std::size_t(i + strides_[1] * j + strides_[2] * k);
                    if (filled_.distance[sample] < 0 && own_.distance[sample] > -deepest_) {
                        samples.push_back(sample);
                    }
                }
            }
        }
        return samples;
    }

    // Returns the depth of a sample in the filled body from its neighbours, by the upwind scheme
    // for |∇φ| = 1 (Rouy & Tourin 1992).
    float depthAt(std::size_t sample) const {
        const auto spacing = float(own_.spacing);
        std::array<float, 3> least{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            least[axis] = -std::max(filled_.distance[sample - std::size_t(strides_[axis])],
                                    filled_.distance[sample + std::size_t(strides_[axis])]);
        }
        std::sort(least.begin(), least.end());
        float depth = least[0] + spacing;
        for (std::size_t count = 2; count <= 3 && depth > least[count - 1]; ++count) {
            float sum = 0, squares = 0;
            for (std::size_t axis = 0; axis < count; ++axis) {
                sum += least[axis] - least[0];
                squares += (least[axis] - least[0]) * (least[axis] - least[0]);
            }
            const auto number = float(count);
            const float root = sum * sum - number * (squares - spacing * spacing);
            depth = least[0] + (sum + std::sqrt(std::max(root, 0.f))) / number;
        }
        return std::clamp(depth, 0.f, deepest_);
    }

    const PosedBody& body_;
    const DistanceField& own_;
    DistanceField& filled_;
    float deepest_; // mm
    std::array<std::ptrdiff_t, 3> strides_;
};

} // namespace

FilledField::FilledField(const PosedBody& body, const DistanceField& own) : own_(own) {
    if (!body.air.isEmpty()) {
        auto filled = std::make_shared<DistanceField>(own);
        Filling(body, own, *filled).fill();
        filled_ = std::move(filled);
    }
}

} // namespace dipwright
