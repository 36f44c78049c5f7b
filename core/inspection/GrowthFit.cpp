#include "inspection/GrowthFit.h"

#include "base/Error.h"
#include "base/NumberText.h"
#include "inspection/LeastSquares.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::FilmWatch)
};

constexpr double leastOff = 1e-6; // least interval of a swell; keeps all weights finite
constexpr double surelyGrows = 3; // standard deviations by which growth must exceed 0
// Growth counts as none if its 95 % interval lies within this share of the length.
constexpr double mostOfNoGrowth = 0.005;
// The limit counts as known if its 95 % interval is at most this share of the limit.
constexpr double mostLimitOff = 0.5;

double deviation(const Measured& measured) {
    return std::max(measured.off, leastOff) / deviationsFor95;
}

Measured meanOf(const std::vector<Measured>& values) {
    double sum = 0, weight = 0;
    for (const Measured& value : values) {
        const double share = 1 / std::pow(deviation(value), 2);
        sum += share * value.value;
        weight += share;
    }
    return {sum / weight, deviationsFor95 / std::sqrt(weight)};
}

GrowthFit nearest(const std::vector<SwellAt>& moments, double begin) {
    double least = std::numeric_limits<double>::infinity();
    for (const SwellAt& moment : moments) {
        least = std::min(least, std::abs(moment.seconds - begin));
    }
    std::vector<Measured> x, y;
    for (const SwellAt& moment : moments) {
        if (std::abs(moment.seconds - begin) == least) {
            x.push_back(moment.x);
            y.push_back(moment.y);
        }
    }
    return {meanOf(x), meanOf(y), GrowthKnowledge::No, {}, {}};
}

// Parameters: swell along X and Y when the dip begins, then the parameters of the growth law
// `grown`. Seconds count from the start of the dip.
class Growing {
public:
    using Grown = double (*)(double seconds, double span, const Eigen::VectorXd& parameters);

    Growing(const std::vector<SwellAt>& moments, double begin, Grown grown)
        : moments_(moments), begin_(begin), grown_(grown) {
        for (const SwellAt& moment : moments) {
            span_ = std::max(span_, std::abs(moment.seconds - begin));
        }
    }

    double span() const { return span_; }

    LeastSquaresFit fit(const Eigen::VectorXd& start) const {
        return leastSquares(
            [this](const Eigen::VectorXd& p, Eigen::VectorXd& values) {
                for (std::size_t i = 0; i < moments_.size(); ++i) {
                    const SwellAt& moment = moments_[i];
                    const double times = grown_(moment.seconds - begin_, span_, p);
                    const auto at = Eigen::Index(2 * i);
                    values[at] = (p[0] * times - moment.x.value) / deviation(moment.x);
                    values[at + 1] = (p[1] * times - moment.y.value) / deviation(moment.y);
                }
            },
            int(2 * moments_.size()), start);
    }

private:
    const std::vector<SwellAt>& moments_;
    double begin_;
    Grown grown_;
    double span_ = 1e-9;
};

// p[2] is the growth over the whole span at the initial rate.
double grownSteadily(double seconds, double span, const Eigen::VectorXd& p) {
    return 1 + p[2] * seconds / span;
}

// p[2] is rate times span; p[3] is the logarithm of the span divided by the time constant of the
// growth.
double grownToLimit(double seconds, double span, const Eigen::VectorXd& p) {
    const double times = std::exp(std::clamp(p[3], -20.0, 20.0));
    return 1 - p[2] / times * std::expm1(-times * seconds / span);
}

// Returns a parameter's standard deviation. It follows from the photos' own uncertainty and is
// enlarged if the photos scatter more than that about the law.
double deviationOf(const LeastSquaresFit& fit, Eigen::Index parameter) {
    const auto freedom = fit.residuals.size() - fit.parameters.size();
    const double excess =
        freedom > 0 ? std::max(1.0, fit.residuals.squaredNorm() / double(freedom)) : 1;
    return std::sqrt(std::max(0.0, fit.covariance(parameter, parameter) * excess));
}

Measured measuredOf(const LeastSquaresFit& fit, Eigen::Index parameter, double unit = 1) {
    return {fit.parameters[parameter] / unit, deviationsFor95 * deviationOf(fit, parameter) / unit};
}

// Returns the best fit from several start values, from an almost straight to a sharply bent curve.
// `steady` gives the start values of the swell.
std::optional<LeastSquaresFit> bestToLimit(const Growing& growing, const LeastSquaresFit& steady,
                                           double range) {
    std::optional<LeastSquaresFit> best;
    for (const double bend : {-1.0, 0.0, 1.0, 2.0, 3.0}) {
        Eigen::VectorXd start(4);
        start << steady.parameters.head<2>(), range * std::exp(bend), bend;
        LeastSquaresFit fit = growing.fit(start);
        if (fit.converged && fit.determined &&
            (!best || fit.residuals.squaredNorm() < best->residuals.squaredNorm())) {
            best = std::move(fit);
        }
    }
    return best;
}

// Returns how much the film grew from the first time to the last, as a share of its length.
double rangeOf(const std::vector<SwellAt>& moments) {
    const auto [first, last] =
        std::minmax_element(moments.begin(), moments.end(), [](const SwellAt& a, const SwellAt& b) {
            return a.seconds < b.seconds;
        });
    return std::max(1e-3, last->x.value / first->x.value - 1);
}

// Returns limit = p[2] / exp(p[3]) with the uncertainty of both.
Measured limitOf(const LeastSquaresFit& fit) {
    const double limit = fit.parameters[2] / std::exp(fit.parameters[3]);
    const Eigen::Vector2d slope(limit / fit.parameters[2], -limit);
    const double variance = slope.dot(fit.covariance.block<2, 2>(2, 2) * slope);
    const double scale =
        fit.covariance(2, 2) > 0 ? deviationOf(fit, 2) / std::sqrt(fit.covariance(2, 2)) : 1;
    return {limit, deviationsFor95 * scale * std::sqrt(std::max(0.0, variance))};
}

// Throws Error unless the film grew by more than the uncertainty.
void refuseUnlessGrowing(double grown, double unsure, double span, const QString& where) {
    if (grown < -surelyGrows * unsure) {
        throw Error(Text::tr("In these photos the film shrinks by %1 % per second, but film grows "
                             "on the water; check that the times are in the order of the photos")
                        .arg(numberText(-100 * grown / span, 4)),
                    where);
    }
    if (grown < surelyGrows * unsure) {
        throw Error(
            Text::tr("The sizes of the film in these photos do not determine its growth; check "
                     "that the times are in the order of the photos, and take photos from before "
                     "the dip begins until the film stops growing"),
            where);
    }
}

} // namespace

GrowthFit fitGrowth(const std::vector<SwellAt>& moments, double begin, const QString& where) {
    std::set<double> times;
    for (const SwellAt& moment : moments) {
        times.insert(moment.seconds);
    }
    GrowthFit result = nearest(moments, begin);
    if (times.size() < 3) {
        return result;
    }
    const Growing steadily(moments, begin, grownSteadily);
    Eigen::VectorXd start(3);
    start << result.swellX.value, result.swellY.value, 0.01;
    const LeastSquaresFit steady = steadily.fit(start);
    if (!steady.determined) {
        return result;
    }
    const Growing growing(moments, begin, grownToLimit);
    const auto bent = bestToLimit(growing, steady, rangeOf(moments));
    const Measured limit = bent ? limitOf(*bent) : Measured{};
    if (bent && bent->parameters[2] > 0 && limit.off < mostLimitOff * limit.value) {
        return {measuredOf(*bent, 0), measuredOf(*bent, 1), GrowthKnowledge::Both,
                measuredOf(*bent, 2, growing.span()), limit};
    }
    result.swellX = measuredOf(steady, 0);
    result.swellY = measuredOf(steady, 1);
    const double grown = steady.parameters[2];
    const double unsure = deviationOf(steady, 2);
    if (grown < surelyGrows * unsure &&
        std::abs(grown) + deviationsFor95 * unsure <= mostOfNoGrowth) {
        result.known = GrowthKnowledge::None;
        return result;
    }
    refuseUnlessGrowing(grown, unsure, steadily.span(), where);
    result.known = GrowthKnowledge::RateOnly;
    result.rate = measuredOf(steady, 2, steadily.span());
    return result;
}

} // namespace dipwright
