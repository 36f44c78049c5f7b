#include "search/PoseCandidates.h"

#include "dip/Pose.h"
#include "film/FilmGrid.h"
#include "parallel/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dipwright {
namespace {

constexpr int turnStep = 5; // step of the turn about the vertical, degrees
// Quality of film on an upright wall, relative to film on a horizontal face.
constexpr float qualityOfWalls = 0.4f;
constexpr int signatureBands = 6; // number of bands of height over the lowest point
// Largest difference between similar poses in an entry of their signatures.
constexpr float sameSignature = 0.01f;
constexpr std::size_t sidesOfBox = 6;
// Share of the simulated poses that is spread over all directions.
constexpr double spreadShare = 0.5;
constexpr double closest = 0.002; // least angle between simulated poses, radians

// Returns the six sides of the box, and directions spread evenly by the golden angle.
std::vector<Eigen::Vector3d> directions(int count, int seed) {
    std::vector<Eigen::Vector3d> result;
    for (int axis = 0; axis < 3; ++axis) {
        result.push_back(-Eigen::Vector3d::Unit(axis));
        result.push_back(Eigen::Vector3d::Unit(axis));
    }
    const int spread = count - int(sidesOfBox);
    const double golden = pi * (3 - std::sqrt(5.0));
    for (int i = 0; i < spread; ++i) {
        const double y = 1 - 2 * (i + 0.5) / spread;
        const double across = std::sqrt(1 - y * y);
        const double angle = golden * (i + std::fmod(seed * 0.7548776662466927, 1.0));
        result.emplace_back(across * std::cos(angle), y, across * std::sin(angle));
    }
    return result;
}

Eigen::Matrix3d turnAboutY(double angle) {
    return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()).toRotationMatrix();
}

// Returns the turn about the vertical, in degrees, at which the body's outline is smallest relative
// to the film's sides.
int bestTurn(const TriangleMesh& mesh, const Eigen::Matrix3d& rotation,
             const solver::FilmGrid& film) {
    int best = 0;
    double smallest = std::numeric_limits<double>::infinity();
    for (int turn = 0; turn < 180; turn += turnStep) {
        const Eigen::Matrix3f turned =
            (turnAboutY(radians(Degrees(turn))) * rotation).cast<float>();
        Eigen::AlignedBox2f box;
        for (const Eigen::Vector3f& position : mesh.positions) {
            const Eigen::Vector3f p = turned * position;
            box.extend(Eigen::Vector2f(p.x(), p.z()));
        }
        const double share = std::max(box.sizes().x() / film.width, box.sizes().y() / film.depth);
        if (share < smallest * 0.999) { // ignores rounding differences
            smallest = share;
            best = turn;
        }
    }
    return best;
}

Eigen::Matrix3d rotationThatLowers(const Eigen::Vector3d& down) {
    return Eigen::Quaterniond::FromTwoVectors(down, -Eigen::Vector3d::UnitY()).toRotationMatrix();
}

// Area, slope and distance from the axis of the painted surface in each band of height. The
// signatures of poses are equal if they differ by a turn about the vertical or by mirroring.
using Signature = std::array<float, std::size_t(3 * signatureBands) + 1>;

Signature signatureOf(const CoveragePreview& preview, const std::vector<float>& zoneWeights,
                      const PreviewedCoverage& coverage, const Eigen::Vector3f& down) {
    const TriangleMesh& mesh = preview.mesh();
    float lowest = std::numeric_limits<float>::infinity();
    Eigen::Vector3f middle = Eigen::Vector3f::Zero();
    float area = 0;
    const std::vector<Eigen::Vector3f>& places = preview.middles();
    for (std::size_t triangle = 0; triangle < places.size(); ++triangle) {
        lowest = std::min(lowest, -down.dot(places[triangle]));
        middle += preview.areas()[triangle] * places[triangle];
        area += preview.areas()[triangle];
    }
    middle /= area;
    const float size = boundingBox(mesh).diagonal().norm();
    Signature signature{};
    float weights = 0;
    for (std::size_t triangle = 0; triangle < places.size(); ++triangle) {
        const float weight = preview.areas()[triangle] * zoneWeights[triangle];
        weights += weight;
        signature.back() =
            std::max(signature.back(), (-down.dot(places[triangle]) - lowest) / size);
        if (coverage.covered[triangle] == 0) {
            continue;
        }
        // A triangle counts in its two nearest bands, so that a border between bands does not
        // separate similar poses.
        const float height =
            (-down.dot(places[triangle]) - lowest) / size * float(signatureBands - 1);
        const int band = std::clamp(int(height), 0, signatureBands - 2);
        const Eigen::Vector3f across = places[triangle] - middle;
        const float radius = (across - across.dot(down) * down).norm() / size;
        for (int side = 0; side < 2; ++side) {
            const float share =
                weight *
                std::clamp(side == 0 ? 1 - (height - float(band)) : height - float(band), 0.f, 1.f);
            const auto at = std::size_t(3 * (band + side));
            signature[at] += share;
            signature[at + 1] += share * preview.normals()[triangle].dot(down);
            signature[at + 2] += share * radius;
        }
    }
    for (std::size_t entry = 0; entry + 1 < signature.size(); ++entry) {
        signature[entry] /= std::max(weights, 1e-12f);
    }
    return signature;
}

bool areAlike(const Signature& one, const Signature& other) {
    for (std::size_t entry = 0; entry < one.size(); ++entry) {
        if (!(std::abs(one[entry] - other[entry]) <= sameSignature)) {
            return false;
        }
    }
    return true;
}

double promiseOf(const CoveragePreview& preview, const std::vector<float>& zoneWeights,
                 const PreviewedCoverage& coverage, const Eigen::Vector3f& down) {
    double promise = 0, whole = 0;
    for (std::size_t triangle = 0; triangle < coverage.covered.size(); ++triangle) {
        const double weight = double(preview.areas()[triangle] * zoneWeights[triangle]);
        whole += weight;
        if (coverage.covered[triangle] != 0) {
            const float flat = std::clamp(preview.normals()[triangle].dot(down), 0.f, 1.f);
            promise += weight * double(qualityOfWalls + (1 - qualityOfWalls) * flat);
        }
    }
    return whole > 0 ? promise / whole : 0;
}

// Sets PoseCandidate::like of each candidate.
void findAlike(std::vector<PoseCandidate>& all, const std::vector<Signature>& signatures) {
    std::vector<std::size_t> kinds;
    for (std::size_t index = 0; index < all.size(); ++index) {
        const auto like = std::find_if(kinds.begin(), kinds.end(), [&](std::size_t kind) {
            return areAlike(signatures[kind], signatures[index]);
        });
        all[index].like = like == kinds.end() ? index : *like;
        if (like == kinds.end()) {
            kinds.push_back(index);
        }
    }
}

// Chooses the sides of the box, then the best candidates that are far enough apart. Halves the
// required angle between them until enough are chosen.
std::vector<std::size_t> choose(const std::vector<PoseCandidate>& all, std::size_t wanted) {
    std::vector<std::size_t> order, chosen;
    for (std::size_t index = 0; index < all.size(); ++index) {
        if (all[index].like == index) {
            (index < sidesOfBox ? chosen : order).push_back(index);
        }
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return all[a].promise > all[b].promise; });
    // Caps with this half-angle round half of the wanted candidates would together have the area of
    // the whole sphere.
    double apart = std::acos(1 - 2 / (std::max(spreadShare * double(wanted), 2.0)));
    const auto isFree = [&](std::size_t index) {
        return std::none_of(chosen.begin(), chosen.end(), [&](std::size_t other) {
            return all[index].down.dot(all[other].down) > std::cos(apart);
        });
    };
    std::vector<std::uint8_t> taken(all.size(), 0);
    for (; chosen.size() < wanted && apart > closest; apart /= 2) {
        for (const std::size_t index : order) {
            if (chosen.size() < wanted && taken[index] == 0 && isFree(index)) {
                chosen.push_back(index);
                taken[index] = 1;
            }
        }
    }
    chosen.resize(std::min(chosen.size(), wanted));
    return chosen;
}

} // namespace

Immersion immersionFor(const TriangleMesh& mesh, const Eigen::Vector3d& down,
                       const solver::FilmGrid& film) {
    const Eigen::Matrix3d rotation = rotationThatLowers(down);
    const double turn = radians(Degrees(bestTurn(mesh, rotation, film)));
    Immersion immersion;
    immersion.rotation = rotationAngles(turnAboutY(turn) * rotation);
    return immersion;
}

Eigen::Vector3d downOf(const Immersion& immersion) {
    return rotationMatrix(immersion.rotation).transpose() * -Eigen::Vector3d::UnitY();
}

PoseCandidates poseCandidates(const CoveragePreview& preview, const std::vector<float>& zoneWeights,
                              const FilmSettings& film, const ProcessSettings& process,
                              const SearchSettings& settings, const Progress& progress) {
    PoseCandidates result;
    for (const Eigen::Vector3d& down : directions(settings.directions, settings.seed)) {
        result.all.push_back({down, 0, 0, {}, result.all.size()});
    }
    const solver::FilmGrid grid = filmGrid(film);
    // A search for two dips keeps similar poses, because these may paint different places.
    const bool leavesOutAlike = settings.immersions == 1;
    std::vector<Signature> signatures(result.all.size());
    parallelFor(std::size_t(0), result.all.size(), [&](std::size_t index) {
        progress.cancelToken.throwIfCancelled();
        PoseCandidate& candidate = result.all[index];
        Immersion immersion;
        immersion.rotation = rotationAngles(rotationThatLowers(candidate.down));
        const PreviewedCoverage coverage = preview.at(immersion, film, process);
        const Eigen::Vector3f down = candidate.down.cast<float>();
        candidate.coverage = coverage.share;
        candidate.promise = promiseOf(preview, zoneWeights, coverage, down);
        if (leavesOutAlike) {
            signatures[index] = signatureOf(preview, zoneWeights, coverage, down);
        }
    });
    if (leavesOutAlike) {
        findAlike(result.all, signatures);
    }
    result.chosen = choose(result.all, std::size_t(settings.simulated));
    parallelFor(std::size_t(0), result.chosen.size(), [&](std::size_t index) {
        PoseCandidate& candidate = result.all[result.chosen[index]];
        candidate.immersion = immersionFor(preview.model(), candidate.down, grid);
    });
    return result;
}

} // namespace dipwright
