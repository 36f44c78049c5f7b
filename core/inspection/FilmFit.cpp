#include "inspection/FilmFit.h"

#include "base/Error.h"
#include "base/NumberText.h"
#include "inspection/FitAdvice.h"
#include "inspection/JointFit.h"
#include "inspection/SimulatedPlaces.h"
#include "project/Project.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::FilmFit)
};

constexpr int mostRounds = 16;
constexpr double settledShare =
    0.05;                      // share of its interval that an unknown may move in the last round
constexpr double worse = 1.02; // factor of residual growth above which a step is halved
// Before the end, an unknown is left out if its interval exceeds this multiple of its
// widestKnownInterval.
constexpr double clearlyUnknown = 6;

// A fit whose places stay farther than this from the simulation (root mean square, mm) is refused.
// Measured places are some tenths of a millimetre off, wrong ones several millimetres.
constexpr double mostResidual = 2;
// A fit is also refused if its places stay farther than smallResidual (mm) and less than leastFall
// of their distance was explained.
constexpr double smallResidual = 0.5, leastFall = 0.1;

std::vector<FitUnknown> unknownsOf(const Project& project, const FittedDips& dips,
                                   const std::vector<PrintedPlace>& printed, const FitRequest& wish,
                                   const QString& where) {
    std::vector<FitQuantity> quantities = wish.quantities;
    std::sort(quantities.begin(), quantities.end());
    quantities.erase(std::unique(quantities.begin(), quantities.end()), quantities.end());
    const bool isNamed = !quantities.empty();
    if (!isNamed) {
        quantities = usualQuantities();
    }
    std::vector<FitUnknown> unknowns;
    for (const FitQuantity quantity : quantities) {
        if (!dips.matters(quantity)) {
            if (isNamed) {
                throw Error(hasNoEffectSentence(quantity), where);
            }
            continue;
        }
        for (int dip = 0; dip < (isOfDip(quantity) ? int(project.immersions.size()) : 1); ++dip) {
            const bool hasPlaces =
                !isOfDip(quantity) ||
                std::any_of(printed.begin(), printed.end(),
                            [dip](const PrintedPlace& place) { return place.dip == dip; });
            if (hasPlaces) {
                unknowns.push_back({quantity, dip});
            }
        }
    }
    return unknowns;
}

PartView firstCamera(const FitPairs& pairs, const std::optional<Lens>& lens) {
    if (!pairs.body.empty()) {
        return fitPartCamera(pairs.body, pairs.photos, pairs.picture, pairs.where, lens);
    }
    std::vector<PlacePair> meant;
    for (const PrintedPlace& place : pairs.printed) {
        meant.push_back({place.photo, place.pixel, place.model});
    }
    return fitPartCamera(meant, pairs.photos, pairs.picture, pairs.where, lens);
}

// Returns the free unknown whose 95 % interval is the largest multiple of its widestKnownInterval.
// Also returns that multiple.
std::pair<std::size_t, double> leastKnown(const JointSolution& solution,
                                          const std::vector<FitUnknown>& unknowns,
                                          const std::vector<bool>& isFree) {
    std::pair<std::size_t, double> worst{0, 0};
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        const double off =
            solution.off[Eigen::Index(i)] / fitScale(unknowns[i].quantity).widestKnownInterval;
        if (isFree[i] && off > worst.second) {
            worst = {i, off};
        }
    }
    return worst;
}

// Alternates between simulated dips and a fit. The fit assumes that the places move linearly with
// the unknowns.
class Search {
public:
    Search(const Project& project, const DistanceField& field, const FitPairs& pairs,
           const FitRequest& wish, const solver::SolverModule& module, const Progress& progress)
        : pairs_(pairs), wish_(wish), seen_{pairs.printed, pairs.body, pairs.picture},
          camera_(firstCamera(pairs, wish.lens)),
          places_(project, field, pairs.printed, module, pairs.where, progress),
          unknowns_(unknownsOf(project, places_.dips(), pairs.printed, wish, pairs.where)),
          isFree_(unknowns_.size(), true),
          centre_(Eigen::VectorXd::Zero(Eigen::Index(unknowns_.size()))) {
        for (std::size_t i = 0; i < unknowns_.size(); ++i) {
            centre_[Eigen::Index(i)] = places_.dips().within(unknowns_[i].quantity, 0);
        }
    }

    void run(const Progress& progress) {
        while (!isDone()) {
            if (rounds_ == mostRounds) {
                throw Error(Text::tr("The fit did not converge in %1 rounds; check for places that "
                                     "were mistaken for others, or fit fewer quantities")
                                .arg(mostRounds),
                            pairs_.where);
            }
            step(progress.part(double(rounds_) / mostRounds, double(rounds_ + 1) / mostRounds));
            ++rounds_;
        }
        progress(1, Text::tr("Fitted"));
    }

    const JointSolution& before() const { return *before_; }
    const JointSolution& after() const { return solution_; }
    const PlacesNear& near() const { return near_; }
    const SimulatedPlaces& places() const { return places_; }
    const std::vector<FitUnknown>& unknowns() const { return unknowns_; }
    const std::vector<bool>& isFree() const { return isFree_; }
    int rounds() const { return rounds_; }

private:
    JointSolution solve(const std::vector<bool>& isFree) const {
        const CameraFit camera = wish_.keepsBodyCamera ? CameraFit::Held
                                 : wish_.lens          ? CameraFit::KnownLens
                                                       : CameraFit::Whole;
        return fitJointly(near_, seen_, camera_, isFree, camera, pairs_.where);
    }

    void step(const Progress& progress) {
        near_ = places_.near(unknowns_, centre_, isFree_, progress);
        excludePlacesOffBody();
        const JointSolution held = solve(std::vector<bool>(unknowns_.size(), false));
        if (!before_) {
            before_ = held;
        } else if (held.pixels > worse * pixels_ && settled_.size() == centre_.size()) {
            centre_ = (centre_ + settled_) / 2; // the step was too large
            return;
        }
        pixels_ = held.pixels;
        settled_ = centre_;
        solution_ = solve(isFree_);
        while (
            dropLeastKnown(std::min(1.0, 2 / std::max(solution_.pixels, 1e-9)), clearlyUnknown)) {
            solution_ = solve(isFree_);
        }
        if (moves()) {
            return;
        }
        isDone_ = !dropLeastKnown(1, 1);
        if (std::none_of(isFree_.begin(), isFree_.end(), [](bool is) { return is; })) {
            throw Error(Text::tr("The pairs do not determine any quantity of the film; give more "
                                 "pairs, all round the part"),
                        pairs_.where);
        }
        if (!isDone_) { // continue from the result, without the unknowns that were left out
            solution_ = solve(isFree_);
            moves();
        }
    }

    bool isDone() const { return isDone_; }

    // A place that was off the body in one round stays left out in all later rounds. Otherwise the
    // residuals of the rounds would come from different places.
    void excludePlacesOffBody() {
        isOut_.resize(near_.places.size(), false);
        for (std::size_t i = 0; i < isOut_.size(); ++i) {
            if (isOut_[i]) {
                near_.places[i].reset();
            } else if (!near_.places[i]) {
                isOut_[i] = true;
                settled_.resize(0);
            }
        }
        if (std::none_of(near_.places.begin(), near_.places.end(),
                         [](const auto& place) { return place.has_value(); })) {
            throw Error(Text::tr("None of the printed places lies on the part in the simulation; "
                                 "check that they belong to this job's sheet"),
                        pairs_.where);
        }
    }

    // Leaves out the least known unknown if its interval, multiplied by `share`, exceeds `limit`
    // times its widestKnownInterval. Returns whether it left out an unknown. Throws Error if the
    // user named the quantity.
    bool dropLeastKnown(double share, double limit) {
        const auto [worst, off] = leastKnown(solution_, unknowns_, isFree_);
        if (!(off * share > limit)) {
            return false;
        }
        if (!wish_.quantities.empty()) {
            throw Error(
                whyNotDetermined(solution_, unknowns_, isFree_, worst, near_, !pairs_.body.empty()),
                pairs_.where);
        }
        isFree_[worst] = false;
        centre_[Eigen::Index(worst)] = near_.centre[Eigen::Index(worst)] =
            places_.dips().within(unknowns_[worst].quantity, 0);
        settled_.resize(0);
        return true;
    }

    // Moves each unknown towards the solution, by at most its largest step. Returns whether an
    // unknown moved noticeably.
    bool moves() {
        bool isMoved = settled_.size() == 0;
        for (std::size_t i = 0; i < unknowns_.size(); ++i) {
            const auto at = Eigen::Index(i);
            const FitScale scale = fitScale(unknowns_[i].quantity);
            const double way =
                std::clamp(solution_.unknowns[at] - near_.centre[at], -scale.most, scale.most);
            const double to = places_.dips().within(unknowns_[i].quantity, near_.centre[at] + way);
            isMoved = isMoved || std::abs(to - centre_[at]) >
                                     std::max(scale.least, settledShare * solution_.off[at]);
            centre_[at] = to;
        }
        return isMoved;
    }

    const FitPairs& pairs_;
    const FitRequest& wish_;
    SeenPlaces seen_;
    PartView camera_;
    SimulatedPlaces places_;
    std::vector<FitUnknown> unknowns_;
    std::vector<bool> isFree_;
    Eigen::VectorXd centre_;  // values for the next dips
    Eigen::VectorXd settled_; // values of the last dips that were not worse; empty: none
    PlacesNear near_;
    std::vector<bool> isOut_; // one per printed place
    std::optional<JointSolution> before_;
    JointSolution solution_;
    double pixels_ = 0;
    int rounds_ = 0;
    bool isDone_ = false;
};

double rootMeanSquare(const std::vector<double>& values) {
    const double sum = std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
    return std::sqrt(sum / double(std::max<std::size_t>(values.size(), 1)));
}

// Returns the size of a pixel at a place, in mm across the line of sight.
double perPixel(const PartView& view, const FitPairs& pairs, const PrintedPlace& place,
                const Eigen::Vector3d& lies) {
    const PartPose& pose = view.photos[std::size_t(place.photo)];
    const double half = std::hypot(pairs.picture.width(), pairs.picture.height()) / 2;
    return (pose.turn * lies + pose.shift).z() / view.focalLength.value / half;
}

void fillDistances(FilmFit& fit, const Search& search, const FitPairs& pairs) {
    std::vector<double> before, after, beforeMm, afterMm;
    for (std::size_t i = 0; i < pairs.printed.size(); ++i) {
        FitDistance& off = fit.off.emplace_back();
        const std::optional<Eigen::Vector3d>& lies = search.near().places[i];
        off.isOnBody = lies.has_value();
        if (!off.isOnBody) {
            continue;
        }
        const double scale = perPixel(fit.view, pairs, pairs.printed[i], *lies);
        off.before = search.before().seenDistances[i];
        off.after = search.after().seenDistances[i];
        off.millimetres = off.after.norm() * scale;
        before.push_back(off.before.norm());
        after.push_back(off.after.norm());
        beforeMm.push_back(off.before.norm() * scale);
        afterMm.push_back(off.millimetres);
    }
    fit.beforePixels = rootMeanSquare(before);
    fit.afterPixels = rootMeanSquare(after);
    fit.beforeMillimetres = rootMeanSquare(beforeMm);
    fit.afterMillimetres = rootMeanSquare(afterMm);
}

void requireExplained(const FilmFit& fit, const QString& where) {
    const double before = fit.beforeMillimetres, after = fit.afterMillimetres;
    if (after > mostResidual || (after > smallResidual && after > (1 - leastFall) * before)) {
        throw Error(Text::tr("The fit does not explain the places: their root mean square distance "
                             "is %1 mm before the fit and %2 mm after it; check the coordinates "
                             "of the sheet, and for places that were mistaken for others")
                        .arg(numberText(before, 2))
                        .arg(numberText(after, 2)),
                    where);
    }
}

void apply(FilmFit& fit, const FittedQuantity& found, const FittedDips& dips,
           const std::vector<FitUnknown>& unknowns, const std::vector<double>& values) {
    const auto dip = std::size_t(found.unknown.dip);
    switch (found.unknown.quantity) {
    case FitQuantity::ShiftX:
    case FitQuantity::ShiftZ:
    case FitQuantity::Turn:
        fit.immersions[dip] = dips.dip(found.unknown.dip, unknowns, values).immersion;
        break;
    case FitQuantity::SwellX:
        fit.film.swellX = found.after;
        break;
    case FitQuantity::SwellY:
        fit.film.swellY = found.after;
        break;
    case FitQuantity::Relaxation:
        fit.film.relaxationTime = Seconds(found.after);
        break;
    case FitQuantity::Growth:
        fit.film.growthRate = found.after;
        break;
    case FitQuantity::ContactDistance:
        fit.film.contactDistance = Millimetres(found.after);
        break;
    case FitQuantity::Depth:
        fit.depth = Millimetres(found.after);
        break;
    }
}

} // namespace

FilmFit fitFilm(const Project& project, const DistanceField& field, const FitPairs& pairs,
                const FitRequest& wish, const solver::SolverModule& module,
                const Progress& progress) {
    Search search(project, field, pairs, wish, module, progress.part(0, 0));
    search.run(progress);
    const JointSolution& solution = search.after();
    FilmFit fit;
    fit.correlation = solution.correlation;
    fit.view = solution.view;
    fit.dips = search.places().dipsDone();
    fit.rounds = search.rounds();
    fit.film = project.film;
    fit.immersions = project.immersions;
    fit.depth = project.process.depth;
    fillDistances(fit, search, pairs);
    requireExplained(fit, pairs.where);
    const FittedDips& dips = search.places().dips();
    std::vector<FitUnknown> unknowns; // the fitted unknowns
    std::vector<double> values;
    for (std::size_t i = 0; i < search.unknowns().size(); ++i) {
        const FitUnknown& unknown = search.unknowns()[i];
        const double value = solution.unknowns[Eigen::Index(i)];
        const double off = solution.off[Eigen::Index(i)];
        if (!search.isFree()[i]) {
            fit.left.push_back(unknown);
            continue;
        }
        unknowns.push_back(unknown);
        values.push_back(value);
        fit.doubt += whyRelaxationIsUncertain(solution, i, search.near());
        fit.quantities.push_back({unknown, dips.before(unknown), dips.told(unknown, value),
                                  dips.told(unknown, value - off),
                                  dips.told(unknown, value + off)});
    }
    for (const FittedQuantity& found : fit.quantities) {
        apply(fit, found, dips, unknowns, values);
    }
    return fit;
}

} // namespace dipwright
