#include "search/PoseSearch.h"

#include "base/Error.h"
#include "base/Sha256.h"
#include "parallel/ParallelFor.h"
#include "parallel/Tasks.h"
#include "reduction/ReducedMesh.h"
#include "search/DipNames.h"
#include "search/JudgedPose.h"
#include "search/Objective.h"
#include "search/PlaceWeights.h"
#include "search/PoseCandidates.h"
#include "search/PoseDips.h"

#include <QCoreApplication>
#include <QDataStream>
#include <QIODevice>
#include <QStringList>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(PoseSearch)
};

constexpr std::size_t keptPoses = 24;
constexpr double leastPainted = 0.01;  // share of the body that each dip of a pair should paint
constexpr int confirmedRounds = 3;     // at most; in each, `confirmed` poses are confirmed
constexpr std::size_t keptFilms = 3;   // number of ranks whose films stay in the result
constexpr int mostFinal = 3;           // at most so many confirmed poses get their final films
constexpr std::size_t firstRanked = 8; // number of dips before the first ranking
// Number of best pairs from which distinct ones are ranked.
constexpr std::size_t comparedPairs = 200;
constexpr double distinct = 5; // least angle between ranked poses, degrees
// Tilts in refinement, degrees: in its rounds by coarse film, and at the end by finer film.
constexpr std::array<double, 2> tilts{10, 5};
constexpr double lastTilt = 2.5;
constexpr std::size_t triedNear = 4;      // number of poses that neighbours() returns
constexpr std::size_t triedWithPaths = 6; // number of best poses that are tried with paths
// Objective that a doubling of the work counts for, and a verdict that is worse by one step
// (docs/pose-search.md, "Certain sheets").
constexpr double lostPerDoubling = 0.01, lostPerAdvice = 0.02;
constexpr double fieldShare = 0.05, geometryShare = 0.1; // progress after these steps, 0 … 1

// Share of the best pairs' dips that are distinct; most pairs have a dip in common with another
// pair.
constexpr double distinctDips = 0.6;

using Judged = std::shared_ptr<const JudgedPose>;

// One dip or a pair, as one entry of the ranking.
struct Entry {
    std::vector<Judged> dips;
    RankedPoses ranked;
};

bool exceedsTank(const Entry& entry) {
    return !entry.ranked.tankFaults.isEmpty();
}

bool canBePrinted(const Entry& entry) {
    return entry.ranked.adviceOnDips() == Advice::Print;
}

bool isRepeated(const Judged& dip) {
    return dip->isRepeated();
}

// Whether the job would end with the films of the pose.
bool hasFinalFilms(const Entry& entry) {
    return std::none_of(entry.dips.begin(), entry.dips.end(), isRepeated);
}

// Returns the advice on the sheets that coarser dips predict.
Advice predictedAdvice(const Entry& entry) {
    Advice advice = Advice::NotJudged;
    for (const Judged& dip : entry.dips) {
        advice = std::max(advice, dip->predicted.advice);
    }
    return advice;
}

// Whether the sheets must not be printed: by their verdicts if the poses are confirmed, otherwise
// by the prediction.
bool isForbidden(const Entry& entry) {
    return (entry.ranked.isConfirmed ? entry.ranked.adviceOnDips() : predictedAdvice(entry)) ==
           Advice::DoNotPrint;
}

// Whether one dip of a pair paints hardly anything. Such a pair would get good values for its short
// seam and for the film that is left.
bool hasIdleDip(const Entry& entry) {
    return entry.dips.size() > 1 &&
           std::any_of(entry.dips.begin(), entry.dips.end(),
                       [](const Judged& dip) { return dip->painted < leastPainted; });
}

// Returns whether the tank cannot carry the pose out, whether its sheets must not be printed, and
// whether a dip is idle. A pose with a smaller refusal is always better.
std::array<bool, 3> refusal(const Entry& entry) {
    return {exceedsTank(entry), isForbidden(entry), hasIdleDip(entry)};
}

// Returns how often the work of the job's first dip is expected to be doubled: by the verdict if
// the dip has the job's own film and its numerical error is known, otherwise by the prediction. If
// the verdict is only expected, too, this counts as another doubling.
double expectedDoublings(const Judged& dip) {
    return dip->doublings.value_or(dip->predicted.doublings) + (dip->isRepeated() ? 1 : 0);
}

// Returns the objective, lowered by the work that certain sheets are expected to need: the mean
// over the dips.
double objectiveWithWork(const Entry& entry) {
    double doublings = 0;
    for (const Judged& dip : entry.dips) {
        doublings += expectedDoublings(dip) / double(entry.dips.size());
    }
    return entry.ranked.objective - lostPerDoubling * doublings;
}

// Compares poses that are not confirmed yet, but whose sheets are predicted.
bool isBetterToConfirm(const Entry& one, const Entry& other) {
    if (refusal(one) != refusal(other)) {
        return refusal(one) < refusal(other);
    }
    if (one.ranked.limitsMissed != other.ranked.limitsMissed) {
        return one.ranked.limitsMissed < other.ranked.limitsMissed;
    }
    const auto rating = [](const Entry& entry) {
        const Advice advice = std::max(predictedAdvice(entry), Advice::Print);
        return objectiveWithWork(entry) - lostPerAdvice * (int(advice) - int(Advice::Print));
    };
    return rating(one) > rating(other);
}

// Compares poses. Confirmed poses are compared by the verdicts on their sheets, then by what no dip
// paints, and a sheet that needs more work counts less.
bool isBetter(const Entry& one, const Entry& other) {
    if (refusal(one) != refusal(other)) {
        return refusal(one) < refusal(other);
    }
    if (one.ranked.isConfirmed && other.ranked.isConfirmed) {
        const auto advice = [](const Entry& entry) {
            return std::pair(entry.ranked.adviceOnDips(), entry.ranked.together.advice);
        };
        if (advice(one) != advice(other)) {
            return advice(one) < advice(other);
        }
    }
    if (one.ranked.limitsMissed != other.ranked.limitsMissed) {
        return one.ranked.limitsMissed < other.ranked.limitsMissed;
    }
    return one.ranked.isConfirmed && other.ranked.isConfirmed
               ? objectiveWithWork(one) > objectiveWithWork(other)
               : one.ranked.objective > other.ranked.objective;
}

// The order of the ranking: of two poses with the same refusal, a confirmed one comes first.
bool isRankedBefore(const Entry& one, const Entry& other) {
    if (refusal(one) == refusal(other) && one.ranked.isConfirmed != other.ranked.isConfirmed) {
        return one.ranked.isConfirmed;
    }
    return isBetter(one, other);
}

// Returns the verdict on a dip with a reason if too large a share of the painted area will be too
// pale, and one if it is the only dip and its film tears.
Verdict withInkAndTears(const JudgedPose& dip, double pale, bool isOnlyDip,
                        const VerdictSettings& limits) {
    Verdict verdict = dip.verdict;
    ReasonList reasons;
    for (const VerdictReason& reason : verdict.reasons) {
        reasons.add(reason);
    }
    reasons.addShare(VerdictReason::Kind::Pale, pale, limits.pale);
    if (isOnlyDip) {
        reasons.addTornBare(dip.films ? dip.films->tornBareShare : 0);
    }
    Verdict all = std::move(reasons).verdict(isOnlyDip);
    verdict.advice = all.advice;
    verdict.reasons = std::move(all.reasons);
    return verdict;
}

bool isSamePose(const Immersion& one, const Immersion& other) {
    return one.rotation == other.rotation && one.offset == other.offset && one.path == other.path;
}

bool isDistinct(const Immersion& one, const Immersion& other) {
    return one.path != other.path ||
           downOf(one).dot(downOf(other)) < std::cos(radians(Degrees(distinct)));
}

bool isDistinct(const Entry& one, const Entry& other) {
    // Pairs are similar if each dip of one is similar to a dip of the other.
    return std::any_of(one.dips.begin(), one.dips.end(), [&](const Judged& dip) {
        return std::all_of(other.dips.begin(), other.dips.end(), [&](const Judged& like) {
            return isDistinct(dip->immersion, like->immersion);
        });
    });
}

// Returns the pose tilted by an angle, in degrees, to four sides.
std::vector<Immersion> neighbours(const Immersion& immersion, double tilt) {
    std::vector<Immersion> result;
    for (const double angle : {-tilt, tilt}) {
        for (const int axis : {0, 2}) {
            Immersion& next = result.emplace_back(immersion);
            const Eigen::AngleAxisd turn(radians(Degrees(angle)), Eigen::Vector3d::Unit(axis));
            next.rotation = rotationAngles(
                turn.toRotationMatrix() * rotationMatrix(immersion.rotation), immersion.rotation);
        }
    }
    return result;
}

// Returns the pose with entries that are tilted, slanted or, if the dips have a depth, rolled: by
// several angles, towards each of eight sides. If the water flows, only along the flow and against
// it, because a path has one heading.
std::vector<Immersion> withPaths(const Immersion& immersion, const ProcessSettings& process) {
    struct Tried {
        PathKind kind;
        std::vector<double> angles, against; // the same towards the other side
    };
    std::vector<Tried> kinds{{PathKind::Tilt, {15, 30, 50}, {-15, -30, -50}},
                             {PathKind::Slanted, {60, 30}, {120, 150}}};
    if (process.depth) {
        kinds.push_back({PathKind::Roll, {90, 180}, {-90, -180}});
    }
    const bool flows = immersion.path.waterSpeed != MillimetresPerSecond(0);
    constexpr int sides = 8;
    std::vector<Immersion> result;
    const auto add = [&](PathKind kind, Degrees heading, double angle) {
        Immersion& next = result.emplace_back(immersion);
        next.path.kind = kind;
        next.path.heading = heading;
        next.path.angle = Degrees(angle);
        next.path.levelDepth.reset();
        next.path.rollRadius.reset();
        next.path.keys.clear();
    };
    for (const Tried& tried : kinds) {
        for (std::size_t i = 0; i < tried.angles.size(); ++i) {
            if (flows) {
                add(tried.kind, immersion.path.heading, tried.angles[i]);
                add(tried.kind, immersion.path.heading, tried.against[i]);
            }
            for (int side = 0; !flows && side < sides; ++side) {
                add(tried.kind, Degrees(360.0 * side / sides), tried.angles[i]);
            }
        }
    }
    return result;
}

constexpr std::size_t dippedWithPaths =
    12; // of the entries that withPaths() returns, for each pose

// Returns the paths near a slanted, tilted or rolling one.
std::vector<Immersion> nearPaths(const Immersion& immersion) {
    std::vector<Immersion> result;
    for (const double side : {-1.0, 1.0}) {
        Immersion next = immersion;
        if (immersion.path.waterSpeed == MillimetresPerSecond(0)) {
            next.path.heading = next.path.heading + Degrees(22.5 * side);
            result.push_back(next);
            next = immersion;
        }
        const bool isSlanted = immersion.path.kind == PathKind::Slanted;
        next.path.angle =
            isSlanted ? next.path.angle + Degrees(10 * side) : next.path.angle * (1 + 0.25 * side);
        next.path.angle = travellableAngle(next.path.kind, next.path.angle);
        result.push_back(next);
    }
    return result;
}

// Returns the settings that apply to every pose: the flow of the water, the slow entry and the
// limit of the acceleration.
DipPath commonPath(const SearchSubject& subject) {
    DipPath path = subject.immersions.empty() ? DipPath() : subject.immersions.front().path;
    const DipPath usual;
    path.kind = usual.kind;
    path.angle = usual.angle;
    path.levelDepth = usual.levelDepth;
    path.rollRadius = usual.rollRadius;
    path.turn = usual.turn;
    path.keys.clear();
    return path.isStraightDown() ? usual : path;
}

// Rating a direction takes time in proportion to the number of triangles, so a mesh with more than
// this is reduced. The result may be one cell of the preview's height field away.
constexpr std::size_t ratedTriangles = 6000;
constexpr double ratedTolerance = 1.0 / CoveragePreview::heightCells; // share of the longest edge

TriangleMesh meshForRating(const TriangleMesh& mesh, const CancelToken& cancelToken) {
    return reducedMesh(mesh, ratedTriangles, ratedTolerance * longestEdgeOf(mesh), cancelToken)
        .mesh;
}

// The model, reduced for rating, and its colours: made at the same time.
struct PreparedModel {
    PreparedModel(const TexturedMesh& model, const CancelToken& cancelToken) {
        Tasks aside;
        aside.run([&] { forRating = meshForRating(model.mesh, cancelToken); });
        colours.emplace(model);
        aside.wait();
    }

    TriangleMesh forRating;
    std::optional<SurfaceColours> colours;
};

// Returns the weight of each triangle of the preview, by the place of the model that is nearest to
// its centre.
std::vector<float> triangleWeights(const SearchSubject& subject, const CoveragePreview& preview,
                                   const SearchSettings& settings,
                                   const SurfaceColours& appearance) {
    const SurfaceQuery query(subject.model->mesh);
    std::vector<SurfacePoint> middles(preview.middles().size());
    parallelFor(std::size_t(0), middles.size(), [&](std::size_t triangle) {
        middles[triangle] = query.closest(preview.middles()[triangle]).point;
    });
    return placeWeights(subject, settings.aims.zoneWeights, middles, appearance.at(middles));
}

// Returns the key that all shards of a search have in common.
QByteArray searchKey(const SearchSubject& subject, const SearchSettings& settings) {
    QByteArray text;
    QDataStream out(&text, QIODevice::WriteOnly);
    out.setVersion(QDataStream::Qt_6_0);
    out << subject.identity << settings.immersions << settings.directions << settings.simulated
        << settings.seed;
    for (const double weight : settings.aims.zoneWeights) {
        out << weight;
    }
    if (const DipPath path = commonPath(subject); !path.isStraightDown()) {
        out << path.heading.value() << path.waterSpeed.value() << path.slowWay.value()
            << path.slowSpeed.value_or(MillimetresPerSecond(0)).value()
            << path.acceleration.value_or(MillimetresPerSecondSquared(0)).value();
    }
    return sha256(text).toHex();
}

// How fast the search is, in units of PoseFilms::cost(): measured over the last two stages, because
// later stages dip better poses, which take less time.
class SearchRate {
public:
    void beginStage() {
        if (marks_.size() == 2) {
            marks_.erase(marks_.begin());
        }
        marks_.push_back({Clock::now(), done_});
    }
    void add(double cost) { done_ += cost; }
    double done() const { return done_; }
    // Does not count the time in which the search waited.
    void leaveOut(std::chrono::duration<double> waited) {
        for (Mark& mark : marks_) {
            mark.at += std::chrono::duration_cast<Clock::duration>(waited);
        }
    }
    // None if no dip is done.
    std::optional<double> secondsFor(double cost) const {
        if (marks_.empty() || done_ <= marks_.front().done) {
            return std::nullopt;
        }
        const double spent =
            std::chrono::duration<double>(Clock::now() - marks_.front().at).count();
        return spent * cost / (done_ - marks_.front().done);
    }

private:
    using Clock = std::chrono::steady_clock;
    struct Mark {
        Clock::time_point at;
        double done; // cost of the dips done by then
    };
    double done_ = 0;
    std::vector<Mark> marks_; // beginnings of the last two stages, the earlier one first
};

// Returns how many of `count` entries the next round of refinement continues with.
int betterHalf(int count) {
    return (count + 1) / 2;
}

// The resolutions of a search (PoseDips.h). `Final`: the job's film with its final cells.
enum Resolution : std::uint8_t { Coarse, Finer, Own, Final };

class Search {
public:
    // `model`: that of the subject, used only here. `dipsOwn`: whether run() will be called, which
    // needs the dips of the job's own poses.
    Search(const SearchSubject& subject, const SearchSettings& settings,
           const solver::SolverModule& module, const Progress& progress, const PreparedModel& model,
           bool dipsOwn)
        : subject_(subject), settings_(settings), module_(module), progress_(progress),
          body_(subject, settings.aims.zoneWeights, *model.colours),
          coarse_(dipsOf(coarseDetail, progress.part(0, fieldShare))),
          common_(commonPath(subject)) {
        if (settings.paths || !common_.isStraightDown()) {
            requirePaths();
        }
        progress_(fieldShare, Text::tr("Rating directions by the part's shape"));
        Tasks aside; // a GPU simulates while the processor rates
        if (dipsOwn) {
            own_.resize(subject.immersions.size());
            aside.run([this] { coarse_.dip(subject_.immersions, own_, [](std::size_t) {}); });
        }
        preview_ = std::make_unique<const CoveragePreview>(model.forRating);
        weights_ = triangleWeights(subject, *preview_, settings, *model.colours);
        candidates_ =
            poseCandidates(*preview_, weights_, subject.film, subject.process, settings, progress);
        aside.wait();
        for (PoseCandidate& candidate : candidates_.all) {
            candidate.immersion.path = common_;
        }
        const int each = settings.immersions;
        const int tried = int(candidates_.chosen.size());
        const int own = int(subject.immersions.size());
        const auto differing = [&](int entries) {
            return own +
                   int(std::lround((each == 1 ? 1 : 2 * distinctDips) * std::min(entries, tried)));
        };
        int refined = 0;
        for (int round = 0, count = settings.refined; round < int(tilts.size()); ++round) {
            refined += count;
            count = betterHalf(count);
        }
        left_ = {own + tried + refined * each * int(triedNear),
                 differing(settings.finer + settings.refined) +
                     (settings.refined > 0 ? each * int(triedNear) : 0),
                 settings.confirmed > 0 ? differing(settings.confirmed) : 0, 0};
        if (settings.paths) {
            left_[Coarse] +=
                int(triedWithPaths) * each * int(dippedWithPaths + 4); // nearPaths(): 4
        }
        estimateCosts();
        result_.equator = body_.equator();
    }

    // Simulates the dips of shard `number`: every `count`-th one of the first poses.
    std::vector<Judged> part(int number, int count) {
        std::vector<Immersion> immersions;
        for (std::size_t at = std::size_t(number - 1); at < candidates_.chosen.size();
             at += std::size_t(count)) {
            immersions.push_back(candidates_.all[candidates_.chosen[at]].immersion);
        }
        left_ = {int(immersions.size()), 0, 0, 0};
        return dipped(coarse_, Coarse, immersions);
    }

    // Takes the dips of other processes in place of the first dips.
    void take(const std::vector<SearchShard>& parts, const QByteArray& key) {
        std::vector<const SearchShard*> ordered(parts.size(), nullptr);
        for (const SearchShard& part : parts) {
            if (part.key != key) {
                throw Error(Text::tr("This file holds a part of another search; create all files "
                                     "from the same project with the same options and solver"),
                            Text::tr("search part %1 of %2").arg(part.number).arg(part.count));
            }
            if (part.count != int(parts.size()) || ordered[std::size_t(part.number - 1)]) {
                throw Error(Text::tr("Give each of the %1 result files of the divided search "
                                     "exactly once; you gave %2 files")
                                .arg(part.count)
                                .arg(parts.size()),
                            Text::tr("search part %1 of %2").arg(part.number).arg(part.count));
            }
            ordered[std::size_t(part.number - 1)] = &part;
        }
        for (std::size_t at = 0; at < candidates_.chosen.size(); ++at) {
            const SearchShard& part = *ordered[at % ordered.size()];
            const std::size_t place = at / ordered.size();
            const Immersion& wanted = candidates_.all[candidates_.chosen[at]].immersion;
            if (place >= part.poses.size() ||
                part.poses[place]->immersion.rotation != wanted.rotation ||
                (!part.poses[place]->samples.empty() &&
                 part.poses[place]->samples.size() != body_.places())) {
                throw Error(Text::tr("This file does not contain all dips of its part of the "
                                     "search; create it again"),
                            Text::tr("search part %1 of %2").arg(part.number).arg(part.count));
            }
            JudgedPose pose = *part.poses[place];
            body_.complete(pose);
            pose.immersion.path = wanted.path; // the file has none
            if (subject_.tank) {
                const TriangleMesh& mesh = subject_.model->mesh;
                const TriangleMesh posed = transformed(mesh, poseTransform(mesh, wanted));
                pose.tankFaults = tankFaultsOf(subject_, posed,
                                               bodyPath(posed, wanted, subject_.process), wanted);
            }
            poses_.push_back(std::make_shared<const JudgedPose>(std::move(pose)));
        }
        done_ = int(poses_.size());
        left_[Coarse] -= done_;
    }

    SearchResult run(const SearchWatch& watch) {
        watch_ = &watch;
        try {
            simulate();
            refine();
            if (settings_.paths) {
                tryPaths();
            }
            rankWithFinerFilm();
            refineWithFinerFilm();
            confirm();
            addOwn();
        } catch (const Cancelled&) {
            if (!isRefining_) {
                rankFirstDips();
            }
            if (result_.ranking.empty()) {
                throw;
            }
            result_.isComplete = false;
        }
        return std::move(result_);
    }

private:
    void requirePaths() const {
        const FilmSettings& film = subject_.film;
        if (!solver::isProductionFilm(film.lattice, film.support) || !module_.followsPaths()) {
            throw Error(Text::tr("Paths need the production film and a solver that follows them; "
                                 "choose another solver, or search without paths"),
                        subject_.name);
        }
    }

    Entry entry(std::vector<Judged> dips, bool isConfirmed) const {
        std::vector<const JudgedPose*> judged;
        Entry entry;
        for (const Judged& dip : dips) {
            judged.push_back(dip.get());
            entry.ranked.immersions.push_back(dip->immersion);
        }
        entry.ranked.measures = body_.measures(judged);
        entry.ranked.objective = objective(entry.ranked.measures, settings_, body_.equator());
        entry.ranked.limitsMissed = limitsMissed(entry.ranked.measures, settings_);
        for (std::size_t number = 0; number < dips.size(); ++number) {
            if (const QString faults = textOf(dips[number]->tankFaults); !faults.isEmpty()) {
                entry.ranked.tankFaults
                    << (dips.size() == 1 ? faults
                                         : Text::tr("Dip %1: %2").arg(number + 1).arg(faults));
            }
        }
        entry.ranked.isConfirmed = isConfirmed;
        if (isConfirmed) {
            entry.ranked.together =
                body_.unpainted(judged, entry.ranked.measures, subject_.verdict);
            const std::vector<double> pale = body_.paleShares(judged);
            for (std::size_t number = 0; number < dips.size(); ++number) {
                entry.ranked.verdicts.push_back(withInkAndTears(
                    *dips[number], pale[number], dips.size() == 1, subject_.verdict));
                entry.ranked.films.push_back(dips[number]->films);
            }
        }
        entry.dips = std::move(dips);
        return entry;
    }

    // The films of one pose stand for the films of all.
    void estimateCosts() {
        const Immersion& pose = candidates_.chosen.empty()
                                    ? subject_.immersions.front()
                                    : candidates_.all[candidates_.chosen.front()].immersion;
        const PosedBody body = posedBody(subject_.model->mesh, pose, searchedAirCells);
        constexpr std::array details{coarseDetail, finerDetail, jobDetail};
        for (std::size_t resolution = 0; resolution < details.size(); ++resolution) {
            if (left_[resolution] > 0) {
                cost_[resolution] = PoseFilms(subject_, details[resolution]).cost(body, pose);
            }
        }
    }

    PoseDips dipsOf(const DipDetail& detail, const Progress& progress) {
        const int resolution = fieldResolution(subject_, detail);
        std::shared_ptr<const DistanceField>& field = fields_[resolution];
        if (!field) {
            field = cachedDistanceField(subject_.model->mesh, resolution, progress);
        }
        return {subject_, body_, module_, detail, field, progress.cancelToken};
    }

    std::vector<Judged> dipped(const PoseDips& dips, Resolution resolution,
                               const std::vector<Immersion>& immersions) {
        std::vector<Judged> judged(immersions.size());
        rate_.beginStage();
        std::size_t before = 0;
        dips.dip(immersions, judged, [&](std::size_t done) {
            count(resolution, int(done - before));
            before = done;
            tell();
        });
        return judged;
    }

    // Returns the coarse dips of these poses. Dips only poses that were not dipped before: many of
    // the best pairs have a dip in common.
    std::vector<Judged> dippedOnce(const std::vector<Immersion>& immersions) {
        const auto known = [this](const Immersion& immersion) {
            return std::find_if(known_.begin(), known_.end(), [&](const Judged& each) {
                return isSamePose(each->immersion, immersion);
            });
        };
        std::vector<Immersion> unknown;
        for (const Immersion& immersion : immersions) {
            if (known(immersion) == known_.end() &&
                std::none_of(unknown.begin(), unknown.end(), [&](const Immersion& other) {
                    return isSamePose(other, immersion);
                })) {
                unknown.push_back(immersion);
            }
        }
        left_[Coarse] -= int(immersions.size() - unknown.size());
        if (!unknown.empty()) {
            const std::vector<Judged> dips = dipped(coarse_, Coarse, unknown);
            known_.insert(known_.end(), dips.begin(), dips.end());
        }
        std::vector<Judged> judged;
        for (const Immersion& immersion : immersions) {
            judged.push_back(*known(immersion));
        }
        return judged;
    }

    void count(Resolution resolution, int dips) {
        done_ += dips;
        left_[resolution] -= dips;
        rate_.add(dips * cost_[resolution]);
    }

    void tell() {
        double left = 0;
        for (std::size_t resolution = 0; resolution < left_.size(); ++resolution) {
            left += cost_[resolution] * std::max(left_[resolution], 0);
        }
        const double share = rate_.done() / std::max(rate_.done() + left, 1.0);
        const bool isRefiningFilm = left_[Final] > 0;
        progress_(geometryShare + (1 - geometryShare) * share,
                  isRefiningFilm ? Text::tr("Dipping the best pose with smaller cells")
                                 : Text::tr("Trying poses"));
        if (watch_ && *watch_) {
            const int wanted = std::accumulate(left_.begin(), left_.end(), done_);
            rate_.leaveOut(
                (*watch_)({done_, wanted, rate_.secondsFor(left), isRefiningFilm, result_}));
        }
    }

    // Dips the first candidates, and ranks them together with the job's own poses.
    void simulate() {
        count(Coarse, int(own_.size()));
        if (poses_.empty()) {
            dipFirst();
        }
        rankFirstDips();
        if (result_.ranking.empty()) {
            throw Error(
                Text::tr("None of the simulated poses paints the part; choose a larger film"),
                subject_.name);
        }
        isRefining_ = true;
    }

    // Dips the first candidates; ranks them whenever their number has doubled.
    void dipFirst() {
        std::vector<Immersion> immersions;
        for (const std::size_t chosen : candidates_.chosen) {
            immersions.push_back(candidates_.all[chosen].immersion);
        }
        poses_.resize(immersions.size());
        rate_.beginStage();
        std::size_t before = 0, rankAt = 0;
        const auto batchDone = [&](std::size_t done) {
            count(Coarse, int(done - before));
            before = done;
            if (done >= rankAt && done < poses_.size()) {
                rankFirstDips();
                rankAt = 2 * done;
            }
            tell();
        };
        coarse_.dip(immersions, poses_, batchDone, firstRanked);
    }

    void rankFirstDips() {
        best_.clear();
        objectives_.assign(poses_.size(), -1);
        std::vector<Judged> pool;
        // Indices in poses_ of the poses in `pool`, without the job's own.
        std::vector<std::size_t> places;
        for (std::size_t place = 0; place < poses_.size(); ++place) {
            if (poses_[place]) {
                pool.push_back(poses_[place]);
                places.push_back(place);
            }
        }
        if (own_.size() == std::size_t(settings_.immersions)) {
            pool.insert(pool.end(), own_.begin(), own_.end());
        }
        std::vector<Entry> all =
            settings_.immersions == 1 ? singles(pool, places) : pairs(pool, places);
        std::stable_sort(all.begin(), all.end(), isBetter);
        for (Entry& each : all) {
            if (best_.size() == keptPoses) {
                break;
            }
            if (each.ranked.measures[Measure::Coverage] > 0 &&
                std::all_of(best_.begin(), best_.end(),
                            [&](const Entry& other) { return isDistinct(each, other); })) {
                best_.push_back(std::move(each));
            }
        }
        current_ = own_.empty() ? std::nullopt : std::optional(entry(own_, false));
        rank();
    }

    std::vector<Entry> singles(const std::vector<Judged>& pool,
                               const std::vector<std::size_t>& places) {
        std::vector<Entry> all(pool.size());
        parallelFor(std::size_t(0), pool.size(),
                    [&](std::size_t index) { all[index] = entry({pool[index]}, false); });
        for (std::size_t index = 0; index < places.size(); ++index) {
            objectives_[places[index]] = all[index].ranked.objective;
        }
        return all;
    }

    // Returns the best of all pairs of poses, each pair in the better order of its dips.
    std::vector<Entry> pairs(const std::vector<Judged>& pool,
                             const std::vector<std::size_t>& places) {
        struct Pair {
            std::uint32_t first, second;
            std::array<bool, 3> refusal{};
            double limitsMissed = 0, objective = 0;
        };
        std::vector<Pair> all;
        for (std::uint32_t first = 0; first < pool.size(); ++first) {
            for (std::uint32_t second = first + 1; second < pool.size(); ++second) {
                all.push_back({first, second});
            }
        }
        parallelFor(std::size_t(0), all.size(), [&](std::size_t index) {
            Pair& pair = all[index];
            const Entry both = entry({pool[pair.first], pool[pair.second]}, false);
            pair.refusal = refusal(both);
            pair.limitsMissed = both.ranked.limitsMissed;
            pair.objective = both.ranked.objective;
        });
        for (const Pair& pair : all) {
            for (const std::size_t member : {pair.first, pair.second}) {
                if (member < places.size()) {
                    double& objective = objectives_[places[member]];
                    objective = std::max(objective, pair.objective);
                }
            }
        }
        std::stable_sort(all.begin(), all.end(), [](const Pair& one, const Pair& other) {
            if (one.refusal != other.refusal) {
                return one.refusal < other.refusal;
            }
            return one.limitsMissed != other.limitsMissed ? one.limitsMissed < other.limitsMissed
                                                          : one.objective > other.objective;
        });
        std::vector<Entry> entries(std::min(all.size(), comparedPairs));
        parallelFor(std::size_t(0), entries.size(), [&](std::size_t index) {
            const Judged& first = pool[all[index].first];
            const Judged& second = pool[all[index].second];
            Entry one = entry({first, second}, false);
            Entry other = entry({second, first}, false);
            entries[index] = std::move(isBetter(other, one) ? other : one);
        });
        return entries;
    }

    // Moves each dip of the best entries in turn to the best pose near it. Each round continues
    // with the better half of the entries.
    void refine() {
        known_ = poses_;
        known_.insert(known_.end(), own_.begin(), own_.end());
        int count = std::min(int(best_.size()), settings_.refined);
        unrefined_.assign(best_.begin(), best_.begin() + count);
        for (const double tilt : tilts) {
            for (std::size_t member = 0; member < std::size_t(settings_.immersions); ++member) {
                refineMember(count, tilt, member);
            }
            std::stable_sort(best_.begin(), best_.begin() + count, isBetter);
            count = betterHalf(count);
        }
    }

    // For each of the best entries, adds the best entry with paths if it is better than straight
    // down.
    void tryPaths() {
        const std::size_t count = std::min(best_.size(), triedWithPaths);
        std::vector<Entry> moved(best_.begin(), best_.begin() + std::ptrdiff_t(count));
        for (std::size_t member = 0; member < std::size_t(settings_.immersions); ++member) {
            improve(moved, member, [this](const Immersion& immersion) {
                Immersion straight = immersion;
                straight.path = common_;
                return bestPreviewed(withPaths(straight, subject_.process));
            });
            improve(moved, member, [](const Immersion& immersion) {
                const PathKind kind = immersion.path.kind;
                return kind == PathKind::Straight || kind == PathKind::Poses
                           ? std::vector<Immersion>()
                           : nearPaths(immersion);
            });
        }
        for (std::size_t index = 0; index < count; ++index) {
            if (isBetter(moved[index], best_[index])) {
                best_.push_back(std::move(moved[index]));
            }
        }
        rank();
    }

    // Returns the dips that cover most by the body's shape, the best first. Zones count as they do
    // in the choice of directions.
    std::vector<Immersion> bestPreviewed(std::vector<Immersion> dips) const {
        std::vector<std::pair<double, std::size_t>> order(dips.size());
        parallelFor(std::size_t(0), dips.size(), [&](std::size_t index) {
            progress_.cancelToken.throwIfCancelled();
            const PreviewedCoverage coverage =
                preview_->at(dips[index], subject_.film, subject_.process);
            double covered = 0;
            for (std::size_t triangle = 0; triangle < coverage.covered.size(); ++triangle) {
                covered += coverage.covered[triangle] != 0
                               ? double(preview_->areas()[triangle]) * double(weights_[triangle])
                               : 0;
            }
            order[index] = {-covered, index};
        });
        std::sort(order.begin(), order.end());
        order.resize(std::min(order.size(), dippedWithPaths));
        std::vector<Immersion> best;
        for (const auto& [share, index] : order) {
            best.push_back(std::move(dips[index]));
        }
        return best;
    }

    // Returns the entry with another dip in place of one of its own.
    Entry replaced(const Entry& before, std::size_t member, Judged dip) const {
        std::vector<Judged> dips = before.dips;
        dips[member] = std::move(dip);
        return entry(std::move(dips), false);
    }

    // Replaces one dip of each entry by the best of trialsOf(its immersion), if that is better.
    template <typename TrialsOf>
    void improve(std::vector<Entry>& entries, std::size_t member, const TrialsOf& trialsOf) {
        std::vector<Immersion> trials;
        std::vector<std::size_t> owner;
        for (std::size_t index = 0; index < entries.size(); ++index) {
            for (const Immersion& trial : trialsOf(entries[index].dips[member]->immersion)) {
                trials.push_back(trial);
                owner.push_back(index);
            }
        }
        const std::vector<Judged> judged = dippedOnce(trials);
        const std::vector<Entry> before = entries;
        for (std::size_t trial = 0; trial < trials.size(); ++trial) {
            Entry tried = replaced(before[owner[trial]], member, judged[trial]);
            if (isBetter(tried, entries[owner[trial]])) {
                entries[owner[trial]] = std::move(tried);
            }
        }
    }

    void refineMember(int count, double tilt, std::size_t member) {
        std::vector<Entry> refined(best_.begin(), best_.begin() + count);
        improve(refined, member,
                [&](const Immersion& immersion) { return neighbours(immersion, tilt); });
        std::move(refined.begin(), refined.end(), best_.begin());
        rank();
    }

    // Dips the best entries and the job's own poses again with film of another resolution, each dip
    // once.
    std::vector<Entry> dippedAgain(const std::vector<Entry>& entries, Resolution resolution) {
        const bool isConfirmed = resolution == Own;
        const bool isOwnDone = isConfirmed && current_ && current_->ranked.isConfirmed;
        std::vector<Immersion> immersions;
        if (!isOwnDone) {
            immersions = subject_.immersions;
        }
        const auto own = std::ptrdiff_t(immersions.size());
        std::map<const JudgedPose*, std::size_t> places;
        for (const Entry& each : entries) {
            for (const Judged& dip : each.dips) {
                if (places.emplace(dip.get(), immersions.size()).second) {
                    immersions.push_back(dip->immersion);
                }
            }
        }
        left_[Coarse] = 0;
        left_[resolution] = int(immersions.size());
        const PoseDips dips = dipsOf(isConfirmed ? jobDetail : finerDetail, progress_.silent());
        std::vector<Judged> judged = dipped(dips, resolution, immersions);
        for (const auto& [before, place] : places) {
            judged[place] = withPrediction(*before, *judged[place], resolution);
        }
        if (own > 0) {
            current_ = entry({judged.begin(), judged.begin() + own}, isConfirmed);
        }
        std::vector<Entry> again;
        for (const Entry& each : entries) {
            std::vector<Judged> both;
            for (const Judged& dip : each.dips) {
                both.push_back(judged[places.at(dip.get())]);
            }
            again.push_back(entry(std::move(both), isConfirmed));
        }
        return again;
    }

    // Returns `dip` with the prediction by `before`, the dip of its pose with coarser film. The
    // job's own film keeps the prediction that `before` has.
    Judged withPrediction(const JudgedPose& before, JudgedPose dip, Resolution resolution) const {
        dip.predicted = resolution == Finer ? body_.predicted(before, dip) : before.predicted;
        return std::make_shared<const JudgedPose>(std::move(dip));
    }

    std::vector<Entry> first(int count) const {
        std::vector<Entry> ordered = ranked();
        ordered.resize(std::min(ordered.size(), std::size_t(count)));
        return ordered;
    }

    // Coarse film finds promising poses, but its numerical error is larger than their differences
    // (docs/pose-search.md). So only poses that are dipped with finer film stay in the ranking. The
    // unrefined poses are dipped again, too, and compared with the refined ones.
    void rankWithFinerFilm() {
        std::vector<Entry> entries = first(settings_.finer);
        entries.insert(entries.end(), unrefined_.begin(), unrefined_.end());
        best_ = dippedAgain(entries, Finer);
        rank();
    }

    // Tilts each dip of the entry that will be confirmed first. Coarse film cannot compare poses
    // that are so close to each other. The tilted poses keep the predicted doublings.
    void refineWithFinerFilm() {
        if (settings_.refined == 0) {
            return;
        }
        Entry best = distinctFirst(best_, isBetterToConfirm).front();
        const PoseDips finer = dipsOf(finerDetail, progress_.silent());
        for (std::size_t member = 0; member < std::size_t(settings_.immersions); ++member) {
            const Judged before = best.dips[member];
            const std::vector<Immersion> trials = neighbours(before->immersion, lastTilt);
            left_[Finer] = int(trials.size() * (std::size_t(settings_.immersions) - member));
            for (const Judged& dip : dipped(finer, Finer, trials)) {
                JudgedPose trial = *dip;
                trial.predicted = {std::max(trial.verdict.advice, Advice::Print),
                                   before->predicted.doublings};
                Entry tried =
                    replaced(best, member, std::make_shared<const JudgedPose>(std::move(trial)));
                if (isBetterToConfirm(tried, best)) {
                    best = std::move(tried);
                }
            }
        }
        best_.push_back(std::move(best));
        rank();
    }

    // Confirms further poses while the sheets of none of the confirmed ones can be printed.
    void confirm() {
        addPairsToConfirm();
        std::vector<Entry> open = distinctFirst(best_, isBetterToConfirm), confirmed;
        const auto count = std::ptrdiff_t(settings_.confirmed);
        for (int round = 0; round < confirmedRounds && count > 0 && !open.empty() &&
                            std::none_of(confirmed.begin(), confirmed.end(), canBePrinted);
             ++round) {
            const auto end = open.begin() + std::min(count, std::ptrdiff_t(open.size()));
            for (Entry& each : dippedAgain({open.begin(), end}, Own)) {
                confirmed.push_back(std::move(each));
            }
            open.erase(open.begin(), end);
            do {
                addCertainPair(confirmed);
                best_ = confirmed;
                best_.insert(best_.end(), open.begin(), open.end());
                rank();
            } while (std::any_of(confirmed.begin(), confirmed.end(), canBePrinted) &&
                     giveFinalFilms(confirmed));
        }
    }

    // The job's own poses compete with those that were found, and can be the best.
    void addOwn() {
        if (current_ && current_->dips.size() == std::size_t(settings_.immersions) &&
            current_->ranked.measures[Measure::Coverage] > 0) {
            best_.push_back(*current_);
            rank();
        }
        while (giveFinalFilms(best_)) {
            rank();
        }
    }

    // Dips the best of these poses with smaller cells, as the job would, unless it has its final
    // films. Only then is its verdict known. Returns whether this was done.
    bool giveFinalFilms(std::vector<Entry>& entries) {
        const auto best = std::min_element(entries.begin(), entries.end(), isRankedBefore);
        if (best == entries.end() || !best->ranked.isConfirmed || isForbidden(*best) ||
            exceedsTank(*best) || hasFinalFilms(*best) || final_ == mostFinal) {
            return false;
        }
        ++final_;
        const std::vector<Judged> before = best->dips;
        left_[Final] = int(std::count_if(before.begin(), before.end(), isRepeated));
        cost_[Final] = 0;
        for (const Judged& dip : before) {
            if (dip->isRepeated()) {
                cost_[Final] += cost_[Own] * std::pow(*dip->films->next, 3) / left_[Final];
            }
        }
        rate_.beginStage();
        tell();
        const PoseDips dips = dipsOf(jobDetail, progress_.silent());
        const std::vector<Judged> after = dips.withFinalFilms(before, [this] { tell(); });
        count(Final, left_[Final]);
        tell();
        for (const Judged& dip : after) {
            for (Entry& each : entries) {
                exchange(each, dip);
            }
            if (current_) {
                exchange(*current_, dip);
            }
        }
        return true;
    }

    // Replaces the dip with the job's film in the pose of `after`, if the entry has one.
    void exchange(Entry& entry, const Judged& after) const {
        std::vector<Judged> dips = entry.dips;
        for (Judged& dip : dips) {
            if (dip->films && isSamePose(dip->immersion, after->immersion)) {
                dip = after;
            }
        }
        if (dips != entry.dips) {
            entry = this->entry(std::move(dips), entry.ranked.isConfirmed);
        }
    }

    // Pairs the finer dips anew and adds the pairs that are best to confirm, as many as are
    // confirmed at once.
    void addPairsToConfirm() {
        if (settings_.immersions == 1 || settings_.confirmed == 0) {
            return;
        }
        std::vector<Judged> dips;
        for (const Entry& each : best_) {
            for (const Judged& dip : each.dips) {
                if (std::find(dips.begin(), dips.end(), dip) == dips.end()) {
                    dips.push_back(dip);
                }
            }
        }
        std::vector<Entry> pairs(dips.size() * dips.size());
        parallelFor(std::size_t(0), pairs.size(), [&](std::size_t index) {
            const Judged& first = dips[index / dips.size()];
            const Judged& second = dips[index % dips.size()];
            if (first != second) {
                pairs[index] = entry({first, second}, false);
            }
        });
        std::erase_if(pairs, [](const Entry& each) { return each.dips.empty(); });
        std::vector<Entry> best = distinctFirst(std::move(pairs), isBetterToConfirm);
        best.resize(std::min(best.size(), std::size_t(settings_.confirmed)));
        best_.insert(best_.end(), best.begin(), best.end());
    }

    // If no sheet of the confirmed pairs can be printed as a pair, adds the best pair of their dips
    // whose sheets can be, provided that its objective is not below that of all confirmed pairs.
    void addCertainPair(std::vector<Entry>& confirmed) const {
        if (settings_.immersions == 1 || confirmed.empty() ||
            std::any_of(confirmed.begin(), confirmed.end(), canBePrinted)) {
            return;
        }
        std::vector<Judged> certain;
        const Entry* worst = &confirmed.front();
        for (const Entry& each : confirmed) {
            worst = each.ranked.objective < worst->ranked.objective ? &each : worst;
            for (const Judged& dip : each.dips) {
                if (dip->verdict.advice == Advice::Print &&
                    std::find(certain.begin(), certain.end(), dip) == certain.end()) {
                    certain.push_back(dip);
                }
            }
        }
        std::optional<Entry> best;
        for (const Judged& first : certain) {
            for (const Judged& second : certain) {
                Entry pair = first == second ? Entry() : entry({first, second}, true);
                if (first != second && pair.ranked.objective >= worst->ranked.objective &&
                    (!best || isBetter(pair, *best))) {
                    best = std::move(pair);
                }
            }
        }
        if (best) {
            confirmed.push_back(std::move(*best));
        }
    }

    std::vector<Entry> ranked() const { return distinctFirst(best_, isRankedBefore); }

    // Returns the entries, the best first, without those that are similar to a better one.
    template <typename IsBetter>
    static std::vector<Entry> distinctFirst(std::vector<Entry> all, const IsBetter& isBetter) {
        std::stable_sort(all.begin(), all.end(), isBetter);
        std::vector<Entry> kept;
        for (Entry& each : all) {
            if (std::all_of(kept.begin(), kept.end(),
                            [&](const Entry& other) { return isDistinct(each, other); })) {
                kept.push_back(std::move(each));
            }
        }
        return kept;
    }

    void rank() {
        result_.ranking.clear();
        for (Entry& each : ranked()) {
            each.ranked.areOwn =
                std::equal(each.ranked.immersions.begin(), each.ranked.immersions.end(),
                           subject_.immersions.begin(), subject_.immersions.end(), isSamePose);
            nameDips(each.ranked.immersions, subject_.immersions);
            if (result_.ranking.size() >= keptFilms) { // films and their bodies are large
                each.ranked.films.clear();
            }
            result_.ranking.push_back(std::move(each.ranked));
        }
        result_.current.reset();
        if (current_ && current_->ranked.measures[Measure::Coverage] > 0) {
            result_.current = current_->ranked;
            nameDips(result_.current->immersions, subject_.immersions);
        }
        fillDirections();
    }

    void fillDirections() {
        result_.directions.clear();
        std::vector<std::optional<double>> objectives(candidates_.all.size());
        for (std::size_t at = 0; at < objectives_.size(); ++at) {
            if (objectives_[at] >= 0) {
                objectives[candidates_.chosen[at]] = objectives_[at];
            }
        }
        for (const PoseCandidate& candidate : candidates_.all) {
            result_.directions.push_back(
                {candidate.down, candidate.coverage, objectives[candidate.like]});
        }
    }

    const SearchSubject& subject_;
    const SearchSettings& settings_;
    const solver::SolverModule& module_;
    const Progress& progress_;
    const SearchWatch* watch_ = nullptr;
    JudgedBody body_;
    // The body's distance fields, by resolution; dips share them and their finer fields.
    std::map<int, std::shared_ptr<const DistanceField>> fields_;
    PoseDips coarse_;
    DipPath common_;
    std::unique_ptr<const CoveragePreview> preview_; // of meshForRating()
    std::vector<float> weights_;                     // of the preview's triangles
    PoseCandidates candidates_;
    std::vector<Judged> own_;   // the job's own poses
    std::vector<Judged> poses_; // dips of candidates_.chosen; null until dipped
    std::vector<Judged> known_; // all coarse dips, from the refinement on
    // Best objective of the entries with each pose; −1 if there are none.
    std::vector<double> objectives_;
    std::vector<Entry> best_;
    std::vector<Entry> unrefined_; // best_ before refinement
    std::optional<Entry> current_;
    SearchResult result_;
    bool isRefining_ = false;      // all first dips are ranked
    int final_ = 0;                // poses that got their final films
    int done_ = 0;                 // dips
    std::array<int, 4> left_{};    // dips at each resolution, estimated
    std::array<double, 4> cost_{}; // of one dip at each resolution
    SearchRate rate_;
};

} // namespace

SearchResult searchPoses(const SearchSubject& subject, const SearchSettings& settings,
                         const solver::SolverModule& module, const std::vector<SearchShard>& parts,
                         const SearchWatch& watch, const Progress& progress) {
    requireValid(settings);
    Search search(subject, settings, module, progress,
                  PreparedModel(*subject.model, progress.cancelToken), true);
    if (!parts.empty()) {
        search.take(parts, searchKey(subject, settings));
    }
    return search.run(watch);
}

SearchShard searchShard(const SearchSubject& subject, const SearchSettings& settings,
                        const solver::SolverModule& module, int number, int count,
                        const Progress& progress) {
    requireValid(settings);
    SearchShard part;
    part.key = searchKey(subject, settings);
    part.number = number;
    part.count = count;
    part.poses = Search(subject, settings, module, progress,
                        PreparedModel(*subject.model, progress.cancelToken), false)
                     .part(number, count);
    return part;
}

Advice RankedPoses::adviceOnDips() const {
    Advice advice = Advice::NotJudged;
    for (const Verdict& verdict : verdicts) {
        advice = std::max(advice, verdict.advice);
    }
    return advice;
}

Advice RankedPoses::advice() const {
    return std::max(adviceOnDips(), together.advice);
}

std::vector<MeasureDifference> differences(const RankedPoses& poses, const RankedPoses& others,
                                           const SearchSettings& settings, double equator) {
    std::vector<std::pair<double, MeasureDifference>> found;
    const double whole = objective(others.measures, settings, equator);
    for (const Measure measure : allMeasures()) {
        const double more = poses.measures[measure] - others.measures[measure];
        if (measureText(measure, poses.measures[measure]) !=
            measureText(measure, others.measures[measure])) {
            PoseMeasures changed = others.measures;
            changed[measure] = poses.measures[measure];
            const double counts = std::abs(objective(changed, settings, equator) - whole);
            found.push_back({counts, {measure, more, (more > 0) == isHigherBetter(measure)}});
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& one, const auto& other) { return one.first > other.first; });
    std::vector<MeasureDifference> result;
    for (const auto& [counts, difference] : found) {
        result.push_back(difference);
    }
    return result;
}

QString changeText(const MeasureDifference& difference) {
    return QStringLiteral("%1 %2%3").arg(
        measureName(difference.measure),
        difference.more < 0 ? QStringLiteral("−") : QStringLiteral("+"),
        measureText(difference.measure, std::abs(difference.more)));
}

QString reasonText(const std::vector<MeasureDifference>& differences) {
    if (differences.empty()) {
        return Text::tr("no difference");
    }
    QStringList reasons;
    for (const MeasureDifference& difference : differences) {
        const QString change = changeText(difference);
        reasons.append(difference.isBetter ? Text::tr("%1 (better)").arg(change)
                                           : Text::tr("%1 (worse)").arg(change));
    }
    return reasons.join(QStringLiteral(", "));
}

} // namespace dipwright
