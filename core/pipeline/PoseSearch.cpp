#include "pipeline/PoseSearch.h"

#include "base/Error.h"
#include "dip/FilmUnderBody.h"
#include "dip/LaidFilm.h"
#include "geometry/SurfaceSamples.h"
#include "parallel/ParallelFor.h"
#include "project/FilmSizes.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(PoseSearch)
};

constexpr int coarseField = 64;
constexpr double cellsAlongBody = 28; // of the coarse film, along the longest edge of the box
constexpr double coarseTravel = 0.5;  // cells that the contact line travels in one step
constexpr int samplesOfBody = 8'000;
constexpr std::size_t batchSize = 16;
constexpr std::size_t keptPoses = 10;
constexpr int turnStep = 5;       // degrees about the vertical
constexpr double simulated = 0.9; // share of the time

// Directions of the body that go down first.
std::vector<Eigen::Vector3d> directions(int count) {
    std::vector<Eigen::Vector3d> result;
    for (int axis = 0; axis < 3; ++axis) {
        result.push_back(-Eigen::Vector3d::Unit(axis));
        result.push_back(Eigen::Vector3d::Unit(axis));
    }
    const int spread = std::max(count - int(result.size()), 0);
    const double golden = pi * (3 - std::sqrt(5.0));
    for (int i = 0; i < spread; ++i) {
        const double y = 1 - 2 * (i + 0.5) / spread;
        const double across = std::sqrt(1 - y * y);
        result.emplace_back(across * std::cos(golden * i), y, across * std::sin(golden * i));
    }
    result.resize(std::size_t(count), Eigen::Vector3d::Zero());
    return result;
}

Eigen::Matrix3d turnAboutY(double angle) {
    return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()).toRotationMatrix();
}

// The turn about the vertical, in degrees, for which the body's outline takes the smallest share of
// the film's sides.
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
        if (share < smallest * 0.999) { // not for rounding's sake
            smallest = share;
            best = turn;
        }
    }
    return best;
}

Immersion immersionFor(const TriangleMesh& mesh, const Eigen::Vector3d& down,
                       const solver::FilmGrid& film) {
    const Eigen::Matrix3d rotation =
        Eigen::Quaterniond::FromTwoVectors(down, -Eigen::Vector3d::UnitY()).toRotationMatrix();
    const double turn = radians(Degrees(bestTurn(mesh, rotation, film)));
    Immersion immersion;
    immersion.rotation = rotationAngles(turnAboutY(turn) * rotation);
    return immersion;
}

// The same film with cells as large as the search can do with.
FilmSettings coarseFilm(FilmSettings film, const TriangleMesh& mesh) {
    const double body = boundingBox(mesh).sizes().maxCoeff();
    const double own = isGraded(film) ? 0 : film.width.value() / (film.columns - 1);
    const double spacing = std::max(own, body / cellsAlongBody);
    film.resolution = FilmResolution::Points;
    const auto points = [&](Millimetres length) {
        return std::clamp(int(std::lround(length.value() / spacing)) + 1, minimumFilmPoints,
                          maximumFilmPoints);
    };
    film.columns = points(film.width);
    film.rows = points(film.height);
    return film;
}

class Search {
public:
    Search(const Project& project, const solver::SolverModule& module,
           const PoseSearchOptions& options, const Progress& progress)
        : project_(project), module_(module), options_(options), progress_(progress),
          mesh_(project.model->mesh), film_(coarseFilm(project.film, mesh_)),
          process_(project.process),
          samples_(evenSamples(mesh_, surfaceArea(mesh_) / samplesOfBody)),
          field_(cachedDistanceField(mesh_, coarseField, progress.part(0, 0.05))) {
        process_.contactTravel = std::max(process_.contactTravel, coarseTravel);
    }

    std::vector<RankedPoses> run() {
        for (const Eigen::Vector3d& down : directions(options_.candidates)) {
            poses_.push_back(immersionFor(mesh_, down, filmGrid(film_)));
        }
        qualities_.resize(poses_.size(), std::vector<float>(samples_.size(), 0.f));
        for (std::size_t begin = 0; begin < poses_.size(); begin += batchSize) {
            const double share = 0.05 + (simulated - 0.05) * double(begin) / double(poses_.size());
            progress_(share, Text::tr("Trying poses"));
            tryPoses(begin, std::min(begin + batchSize, poses_.size()));
        }
        progress_(simulated, Text::tr("Ranking the poses"));
        return options_.immersions == 1 ? rankedSingles() : rankedPairs();
    }

private:
    void tryPoses(std::size_t begin, std::size_t end) {
        std::vector<std::shared_ptr<const PosedBody>> bodies(end - begin);
        std::vector<solver::BatchItem> items(end - begin);
        parallelFor(begin, end, [&](std::size_t index) {
            const std::size_t item = index - begin;
            bodies[item] =
                std::make_shared<const PosedBody>(posedBody(*project_.model, poses_[index]));
            items[item].setup = dipSetup(*bodies[item], *field_, poses_[index], film_, process_);
        });
        simulateDips(items, module_, [this] { return progress_.cancelSwitch.isCancelled(); });
        parallelFor(begin, end, [&](std::size_t index) {
            const solver::BatchItem& item = items[index - begin];
            DippedFilm film = dippedFilm(item, poses_[index]);
            if (isStable(film, item.setup.motion.travel)) {
                qualities_[index] =
                    judged(*layFilm(bodies[index - begin], std::move(film), process_));
            }
        });
    }

    // A quality for each sample: 0 where nothing is painted, never below a trace where it is.
    std::vector<float> judged(const LaidFilm& laid) const {
        std::vector<float> qualities(samples_.size(), 0.f);
        for (std::size_t index = 0; index < samples_.size(); ++index) {
            if (const std::optional<FilmPlace> place = laid.place(samples_[index])) {
                const PrincipalStretch& stretch = laid.stretches()[place->triangle];
                qualities[index] =
                    std::max(float(printQuality(stretch.larger, stretch.smaller)), 1e-6f);
            }
        }
        return qualities;
    }

    // Of the poses `members` together, each place painted by the one that does it best.
    RankedPoses together(const std::vector<std::size_t>& members) const {
        RankedPoses ranked;
        for (std::size_t index = 0; index < samples_.size(); ++index) {
            float best = 0;
            for (const std::size_t member : members) {
                best = std::max(best, qualities_[member][index]);
            }
            ranked.quality += double(best);
            ranked.coverage += best > 0 ? 1 : 0;
        }
        ranked.quality /= double(samples_.size());
        ranked.coverage /= double(samples_.size());
        for (const std::size_t member : members) {
            ranked.immersions.push_back(poses_[member]);
        }
        return ranked;
    }

    std::vector<RankedPoses> rankedSingles() const {
        std::vector<RankedPoses> all;
        for (std::size_t pose = 0; pose < poses_.size(); ++pose) {
            all.push_back(together({pose}));
        }
        return bestOf(std::move(all));
    }

    std::vector<RankedPoses> rankedPairs() const {
        std::vector<RankedPoses> all;
        for (std::size_t first = 0; first < poses_.size(); ++first) {
            progress_.cancelSwitch.throwIfCancelled();
            for (std::size_t second = first + 1; second < poses_.size(); ++second) {
                all.push_back(together({first, second}));
            }
        }
        return bestOf(std::move(all));
    }

    std::vector<RankedPoses> bestOf(std::vector<RankedPoses> all) const {
        std::stable_sort(all.begin(), all.end(), [](const RankedPoses& a, const RankedPoses& b) {
            return a.quality > b.quality;
        });
        all.resize(std::min(all.size(), keptPoses));
        if (all.empty() || !(all.front().coverage > 0)) {
            throw Error(Text::tr("No pose paints anything; choose a larger film"), project_.name);
        }
        for (RankedPoses& ranked : all) {
            nameImmersions(ranked.immersions);
        }
        return all;
    }

    // The project's own names, where there are as many.
    void nameImmersions(std::vector<Immersion>& immersions) const {
        for (std::size_t index = 0; index < immersions.size(); ++index) {
            immersions[index].name = project_.immersions.size() == immersions.size()
                                         ? project_.immersions[index].name
                                         : Text::tr("Immersion %1").arg(index + 1);
        }
    }

    const Project& project_;
    const solver::SolverModule& module_;
    const PoseSearchOptions& options_;
    const Progress& progress_;
    const TriangleMesh& mesh_;
    FilmSettings film_;
    ProcessSettings process_;
    std::vector<SurfacePoint> samples_;
    std::shared_ptr<const DistanceField> field_;
    std::vector<Immersion> poses_;
    std::vector<std::vector<float>> qualities_; // of each pose: one a sample
};

// 1 at `good`, 0 at `bad`, linear between.
double ramp(double value, double good, double bad) {
    return std::clamp((value - bad) / (good - bad), 0.0, 1.0);
}

} // namespace

double printQuality(double larger, double smaller) {
    return ramp(larger, 1.2, 2.5) * ramp(smaller, 0.7, 0.2);
}

std::vector<RankedPoses> searchPoses(const Project& project, const solver::SolverModule& module,
                                     const PoseSearchOptions& options, const Progress& progress) {
    if (!project.model) {
        throw Error(Text::tr("The project has no model, import one first"), project.name);
    }
    return Search(project, module, options, progress).run();
}

} // namespace dipwright
