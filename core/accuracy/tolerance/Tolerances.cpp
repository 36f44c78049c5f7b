#include "accuracy/tolerance/Tolerances.h"

#include "accuracy/tolerance/ChangedDips.h"
#include "accuracy/tolerance/ChangedPath.h"
#include "accuracy/tolerance/ColourShift.h"
#include "accuracy/tolerance/Draws.h"
#include "base/Error.h"
#include "dip/Dip.h"
#include "geometry/SurfaceSamples.h"
#include "parallel/ParallelFor.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Tolerance)
};

constexpr double wantedPlaces = 40'000; // places on the body, and triangles of toleranceMesh()
constexpr double deviations = 2;        // a tolerance is this many standard deviations
constexpr double leastEffect = 1e-12;   // mm, degrees or fractions: smaller effects count as 0
constexpr std::size_t mostWorst = 5;
constexpr float worstApart = 10; // least distance between worst places, mm

bool isFinite(const Eigen::Vector2f& film) {
    return std::isfinite(film.x());
}

// The deviations that the contributors' tolerances cause: one column per contributor, one row per
// Freedom. Rows that have no effect on the dip are 0.
using Effects = Eigen::Matrix<double, int(freedomCount), Eigen::Dynamic>;

// Finds which film the places touch in other dips.
class OtherDips {
public:
    OtherDips(const TolerancedDip& dip, const ColourPlaces& places, const Progress& progress)
        : dip_(dip), places_(places),
          field_(dip.own->body(), fieldForFilm(dip.field, dip.own->film().grid, progress.silent())),
          setup_(dipSetup(dip.own->body(), field_, dip.immersion, dip.film, dip.process)) {}

    const solver::Settings& settings() const { return setup_.settings; }

    // Returns how many times the way between a deviation to one side and to the other by `step`
    // is as large as the way that the path's limits allow.
    double widening(Freedom freedom, double step) const {
        if (freedom != Freedom::PathAngle) {
            return 1;
        }
        const DipPath& path = dip_.immersion.path;
        return 2 * step / (changedAngle(path, step) - changedAngle(path, -step)).value();
    }

    // Simulates the changes and calls done(number, touched film) for each, in their order.
    template <typename Done>
    void run(const std::vector<DipChange>& changes, const Progress& progress,
             const Done& done) const {
        std::vector<ChangedDip> others;
        for (const DipChange& change : changes) {
            others.push_back(changed({dip_.model, dip_.immersion, setup_, dip_.process}, change));
        }
        const DippedBody body{dip_.model, dip_.immersion, dip_.process,
                              std::shared_ptr<const PosedBody>(dip_.own, &dip_.own->body())};
        layDips(body, others, dip_.module, progress,
                [&](std::size_t number, std::shared_ptr<const LaidFilm> laid) {
                    done(number, places_.touched(*laid, others[number].filmLength));
                });
    }

private:
    const TolerancedDip& dip_;
    const ColourPlaces& places_;
    FilledField field_;
    solver::DipSetup setup_;
};

// How colours move for one kind of deviation.
struct Sensitivity {
    std::vector<Eigen::Vector3f> shifts; // per place: movement for the tried deviation, mm
    std::size_t lost = 0, gained = 0;    // number of places: the larger number of both directions
};

Sensitivity sensitivity(const ColourPlaces& places, std::size_t compared,
                        const std::vector<Eigen::Vector2f>& more,
                        const std::vector<Eigen::Vector2f>& less, double widening) {
    Sensitivity found;
    found.shifts.assign(places.count(), Eigen::Vector3f::Zero());
    parallelFor(std::size_t(0), places.count(), [&](std::size_t place) {
        if (!places.isPainted(place)) {
            return;
        }
        const bool hasMore = isFinite(more[place]), hasLess = isFinite(less[place]);
        Eigen::Vector3f& shift = found.shifts[place];
        if (hasMore) {
            shift += places.linearShift(place, more[place]);
        }
        if (hasLess) {
            shift -= places.linearShift(place, less[place]);
        }
        shift *= hasMore && hasLess ? float(widening) / 2 : 1.0f;
    });
    std::array<std::size_t, 2> lost{}, gained{};
    for (std::size_t place = 0; place < compared; ++place) {
        const std::array<bool, 2> isThere{isFinite(more[place]), isFinite(less[place])};
        for (std::size_t way = 0; way < 2; ++way) {
            lost[way] += places.isPainted(place) && !isThere[way] ? 1 : 0;
            gained[way] += places.isBare(place) && isThere[way] ? 1 : 0;
        }
    }
    found.lost = std::max(lost[0], lost[1]);
    found.gained = std::max(gained[0], gained[1]);
    return found;
}

std::vector<Contribution> contributionsOf(const ToleranceSettings& settings, const DipPath& path,
                                          const solver::Settings& film) {
    std::vector<Contribution> contributions;
    for (std::size_t number = 0; number < contributorCount; ++number) {
        Contribution contribution;
        contribution.contributor = contributorAt(number);
        contribution.tolerance = toleranceOf(settings, contribution.contributor);
        if (contribution.tolerance > 0 && isListed(contribution.contributor, film, path)) {
            contributions.push_back(contribution);
        }
    }
    return contributions;
}

Effects effectsOf(const std::vector<Contribution>& contributions, const Immersion& immersion,
                  const solver::Settings& settings) {
    Effects effects(int(freedomCount), Eigen::Index(contributions.size()));
    for (std::size_t column = 0; column < contributions.size(); ++column) {
        effects.col(Eigen::Index(column)) = contributions[column].tolerance *
                                            changeBy(contributions[column].contributor, immersion);
    }
    for (std::size_t row = 0; row < freedomCount; ++row) {
        if (!matters(Freedom(row), settings, immersion.path)) {
            effects.row(Eigen::Index(row)).setZero();
        }
    }
    return (effects.array().abs() < leastEffect).select(0, effects);
}

// Tries each Freedom in both directions, by its step in `steps`, the deviation of all contributors
// together. Skips a step of 0.
std::vector<Sensitivity> sensitivities(const OtherDips& dips, const ColourPlaces& places,
                                       std::size_t compared, const DipChange& steps,
                                       const Progress& progress) {
    std::vector<DipChange> changes;
    std::vector<std::size_t> freedoms;
    for (std::size_t freedom = 0; freedom < freedomCount; ++freedom) {
        const double step = steps[Eigen::Index(freedom)];
        if (step > 0) {
            freedoms.push_back(freedom);
            for (const double way : {step, -step}) {
                changes.emplace_back(DipChange::Zero());
                changes.back()[Eigen::Index(freedom)] = way;
            }
        }
    }
    std::vector<Sensitivity> found(freedomCount);
    std::vector<Eigen::Vector2f> more;
    dips.run(changes, progress, [&](std::size_t number, std::vector<Eigen::Vector2f> touched) {
        if (number % 2 == 0) {
            more = std::move(touched);
        } else {
            const std::size_t freedom = freedoms[number / 2];
            const double widening = dips.widening(Freedom(freedom), steps[Eigen::Index(freedom)]);
            found[freedom] = sensitivity(places, compared, more, touched, widening);
        }
    });
    return found;
}

// The linear effect of each contributor when it deviates by its tolerance.
class Linear {
public:
    Linear(const std::vector<Sensitivity>& sensitivities, const Effects& effects,
           const DipChange& steps)
        : sensitivities_(sensitivities), effects_(effects), steps_(steps) {}

    float square(std::size_t contribution, std::size_t place) const {
        Eigen::Vector3f shift = Eigen::Vector3f::Zero();
        each(contribution, [&](const Sensitivity& sensitivity, double part) {
            shift += float(part) * sensitivity.shifts[place];
        });
        return shift.squaredNorm();
    }
    float square(std::size_t place) const {
        float sum = 0;
        for (Eigen::Index column = 0; column < effects_.cols(); ++column) {
            sum += square(std::size_t(column), place);
        }
        return sum;
    }
    // Adds the numbers of places lost and gained at the border.
    void border(std::size_t contribution, double& lost, double& gained) const {
        each(contribution, [&](const Sensitivity& sensitivity, double part) {
            lost += std::abs(part) * double(sensitivity.lost);
            gained += std::abs(part) * double(sensitivity.gained);
        });
    }

private:
    template <typename Take>
    void each(std::size_t contribution, const Take& take) const {
        for (std::size_t freedom = 0; freedom < freedomCount; ++freedom) {
            const double effect = effects_(Eigen::Index(freedom), Eigen::Index(contribution));
            if (effect != 0) {
                take(sensitivities_[freedom], effect / steps_[Eigen::Index(freedom)]);
            }
        }
    }

    const std::vector<Sensitivity>& sensitivities_;
    const Effects& effects_;
    const DipChange& steps_;
};

// Fills in everything except the worst places and the samples. `area` is the area that each place
// stands for, in mm².
DipTolerances combined(const ColourPlaces& places, std::size_t compared, std::size_t filmPoints,
                       const Linear& linear, std::vector<Contribution> contributions, double area) {
    DipTolerances result;
    result.contributions = std::move(contributions);
    std::vector<float> spread(places.count(), unpaintedPlace);
    parallelFor(std::size_t(0), places.count(), [&](std::size_t place) {
        if (places.isPainted(place)) {
            spread[place] = std::sqrt(linear.square(place));
        }
    });
    result.places.assign(spread.begin(), spread.begin() + std::ptrdiff_t(compared));
    const auto film = spread.end() - std::ptrdiff_t(filmPoints);
    result.pieces.assign(spread.begin() + std::ptrdiff_t(compared), film);
    result.filmPoints.assign(film, spread.end());
    for (float& point : result.filmPoints) {
        point = std::max(point, 0.0f);
    }
    std::vector<float> painted = result.places;
    std::erase(painted, unpaintedPlace);
    for (std::size_t number = 0; number < result.contributions.size(); ++number) {
        Contribution& contribution = result.contributions[number];
        std::vector<float>& squares = result.squares.emplace_back(compared, 0.0f);
        std::vector<float> alone;
        double shares = 0;
        for (std::size_t place = 0; place < compared; ++place) {
            if (!places.isPainted(place)) {
                continue;
            }
            squares[place] = linear.square(number, place);
            alone.push_back(std::sqrt(squares[place]));
            shares += spread[place] > 0 ? squares[place] / (spread[place] * spread[place]) : 0;
        }
        contribution.spread = spreadOf(std::move(alone));
        contribution.share = shares;
        linear.border(number, contribution.lost, contribution.gained);
        contribution.lost *= area;
        contribution.gained *= area;
    }
    const double all = std::accumulate(
        result.contributions.begin(), result.contributions.end(), 0.0,
        [](double sum, const Contribution& contribution) { return sum + contribution.share; });
    for (Contribution& contribution : result.contributions) {
        contribution.share /= all > 0 ? all : 1;
    }
    result.spread = spreadOf(std::move(painted));
    return result;
}

std::vector<WorstPlace> worstPlaces(const TriangleMesh& model,
                                    const std::vector<SurfacePoint>& places,
                                    const DipTolerances& tolerances) {
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return tolerances.places[a] > tolerances.places[b];
    });
    std::vector<WorstPlace> worst;
    for (const std::size_t place : order) {
        if (worst.size() == mostWorst || tolerances.places[place] <= 0) {
            break;
        }
        const Eigen::Vector3f at = position(model, places[place]);
        const bool isApart = std::all_of(worst.begin(), worst.end(), [&](const WorstPlace& other) {
            return (other.place - at).norm() >= worstApart;
        });
        if (isApart) {
            worst.push_back(worstAt(tolerances, place, at));
        }
    }
    return worst;
}

SampledSpread sampled(const OtherDips& dips, const ColourPlaces& places,
                      const std::vector<float>& linear, const Effects& effects,
                      const ToleranceSettings& settings, const Progress& progress) {
    const Eigen::MatrixXd draws =
        evenDraws(settings.samples, int(effects.cols()), settings.seed) / deviations;
    std::vector<DipChange> changes;
    for (Eigen::Index row = 0; row < draws.rows(); ++row) {
        changes.emplace_back(effects * draws.row(row).transpose());
    }
    std::vector<float> sums(linear.size(), 0.0f); // below 0: a dip does not paint the place
    dips.run(changes, progress, [&](std::size_t, const std::vector<Eigen::Vector2f>& touched) {
        parallelFor(std::size_t(0), sums.size(), [&](std::size_t place) {
            if (linear[place] < 0 || sums[place] < 0) {
                return;
            }
            const auto shift =
                isFinite(touched[place]) ? places.shift(place, touched[place]) : std::nullopt;
            sums[place] = shift ? sums[place] + shift->squaredNorm() : unpaintedPlace;
        });
    });
    std::vector<float> spread, wanted;
    for (std::size_t place = 0; place < sums.size(); ++place) {
        if (linear[place] >= 0 && sums[place] >= 0) {
            spread.push_back(float(deviations) * std::sqrt(sums[place] / float(changes.size())));
            wanted.push_back(linear[place]);
        }
    }
    return {int(changes.size()), spreadOf(std::move(spread)).percentile95,
            spreadOf(std::move(wanted)).percentile95};
}

} // namespace

WorstPlace worstAt(const DipTolerances& tolerances, std::size_t place,
                   const Eigen::Vector3f& position) {
    WorstPlace worst{position, double(tolerances.places[place])};
    float most = 0;
    for (std::size_t number = 0; number < tolerances.contributions.size(); ++number) {
        if (tolerances.squares[number][place] > most) {
            most = tolerances.squares[number][place];
            worst.contributor = tolerances.contributions[number].contributor;
        }
    }
    return worst;
}

Spread spreadOf(std::vector<float> values) {
    if (values.empty()) {
        return {};
    }
    std::sort(values.begin(), values.end());
    const auto ranked = [&](double share) { // nearest rank
        const double rank = std::ceil(share * double(values.size()));
        return double(values[std::size_t(std::max(rank, 1.0)) - 1]);
    };
    return {ranked(0.5), ranked(0.95), double(values.back())};
}

bool SampledSpread::agrees() const {
    return std::abs(percentile95 - linear) <= sampledTolerance * linear;
}

std::vector<SurfacePoint> tolerancePlaces(const TexturedMesh& model) {
    return evenSamples(model.mesh, surfaceArea(model.mesh) / wantedPlaces);
}

RefinedMesh toleranceMesh(const TexturedMesh& model) {
    return {model.mesh, edgeForTriangles(model.mesh, wantedPlaces)};
}

DipTolerances dipTolerances(const TolerancedDip& dip, const ToleranceSettings& settings,
                            const Progress& progress) {
    const std::vector<SurfacePoint> compared = tolerancePlaces(dip.model);
    std::vector<SurfacePoint> all = compared;
    const RefinedMesh fine = toleranceMesh(dip.model);
    for (std::size_t piece = 0; piece < fine.mesh().triangles.size(); ++piece) {
        all.push_back(fine.middle(piece));
    }
    const std::vector<SurfacePoint>& filmPoints = dip.own->contact().surface;
    all.insert(all.end(), filmPoints.begin(), filmPoints.end());
    const ColourPlaces places(*dip.own, all, dip.isPainted);
    const OtherDips dips(dip, places, progress);

    const std::vector<Contribution> contributions =
        contributionsOf(settings, dip.immersion.path, dips.settings());
    const Effects effects = effectsOf(contributions, dip.immersion, dips.settings());
    const DipChange steps = effects.rowwise().norm();
    const double ways = 2 * double((steps.array() > 0).count());
    const double linearDone = ways > 0 ? ways / (ways + settings.samples) : 1;
    const std::vector<Sensitivity> found =
        sensitivities(dips, places, compared.size(), steps, progress.part(0, linearDone));
    const Linear linear(found, effects, steps);
    DipTolerances result =
        combined(places, compared.size(), filmPoints.size(), linear, contributions,
                 surfaceArea(dip.model.mesh) / double(std::max<std::size_t>(compared.size(), 1)));
    result.worst = worstPlaces(dip.model.mesh, compared, result);
    if (settings.samples > 0 && ways > 0) {
        result.sampled =
            sampled(dips, places, result.places, effects, settings, progress.part(linearDone, 1));
    }
    return result;
}

QString sampledText(const SampledSpread& sampled, const std::function<QString(double)>& length) {
    const QString text =
        sampled.agrees()
            ? Text::tr("Check: with all deviations at once, %1 simulated dips give a displacement "
                       "of ±%2 (95 % of the painted area). The sum of the contributors gives ±%3. "
                       "Both agree.")
            : Text::tr(
                  "Check: with all deviations at once, %1 simulated dips give a displacement of "
                  "±%2 (95 % of the painted area). The sum of the contributors gives ±%3. The two "
                  "differ, because the effects of the contributors do not simply add up here.");
    return text.arg(sampled.dips).arg(length(sampled.percentile95), length(sampled.linear));
}

} // namespace dipwright
