#include "accuracy/correction/RepeatingError.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

namespace dipwright {
namespace {

constexpr double leastScatter = 0.005; // mm: photos do not resolve less
constexpr std::size_t fewPlaces = 150; // number of places from which reach and size are chosen
// Candidates for the reach, relative to the extent of the places.
constexpr std::array<double, 5> reaches{0.2, 0.33, 0.55, 0.9, 1.5};
// Candidates for the size of the repeating error, as multiples of the measured errors.
constexpr std::array<double, 6> sizes{0.25, 0.5, 1, 2, 4, 8};
// Candidates for the scatter if only one part was measured, as multiples of the measured errors.
constexpr std::array<double, 5> guessedScatters{0.03, 0.06, 0.12, 0.25, 0.5};

struct PartError {
    int part = 0;
    Eigen::Vector2d sheet, off;
};

Eigen::Vector2d vectorOf(const std::array<Millimetres, 2>& place) {
    return {place[0].value(), place[1].value()};
}

// Returns the correlation between the errors at two places: the squared exponential kernel of a
// Gaussian process (C. E. Rasmussen and C. K. I. Williams, "Gaussian Processes for Machine
// Learning", 2.2).
double alike(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double reach) {
    return std::exp(-(a - b).squaredNorm() / (2 * reach * reach));
}

struct Chosen {
    double reach = 1, variance = 0, scatter = 0;
    double likelihood = -std::numeric_limits<double>::infinity();
};

// Returns the covariance of the places' mean errors for the chosen parameters.
Eigen::MatrixXd covarianceOf(const std::vector<RepeatedPlace>& places, const Chosen& chosen) {
    const auto count = Eigen::Index(places.size());
    Eigen::MatrixXd covariance(count, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const RepeatedPlace& place = places[std::size_t(i)];
        for (Eigen::Index j = 0; j <= i; ++j) {
            covariance(i, j) = covariance(j, i) =
                chosen.variance * alike(place.sheet, places[std::size_t(j)].sheet, chosen.reach);
        }
        covariance(i, i) += chosen.scatter * chosen.scatter / place.parts;
    }
    return covariance;
}

Eigen::MatrixX2d offsOf(const std::vector<RepeatedPlace>& places, const Eigen::Vector2d& mean) {
    Eigen::MatrixX2d offs(Eigen::Index(places.size()), 2);
    for (std::size_t i = 0; i < places.size(); ++i) {
        offs.row(Eigen::Index(i)) = (places[i].mean - mean).transpose();
    }
    return offs;
}

// Returns the log-likelihood of the mean errors, up to a constant. Both axes have the same
// parameters.
double likelihood(const std::vector<RepeatedPlace>& places, const Eigen::MatrixX2d& offs,
                  const Chosen& chosen) {
    const Eigen::LLT<Eigen::MatrixXd> factors(covarianceOf(places, chosen));
    if (factors.info() != Eigen::Success) {
        return -std::numeric_limits<double>::infinity();
    }
    const Eigen::MatrixXd lower = factors.matrixL();
    return -0.5 * offs.cwiseProduct(factors.solve(offs)).sum() -
           2 * lower.diagonal().array().log().sum();
}

double extent(const std::vector<RepeatedPlace>& places) {
    double most = 0;
    for (const RepeatedPlace& place : places) {
        most = std::max(most, (place.sheet - places.front().sheet).norm());
    }
    return std::max(most, 1.0);
}

} // namespace

RepeatingError::RepeatingError(const AsBuilt& built, int dip) {
    gather(built, dip);
    if (!places_.empty()) {
        fit();
    }
}

void RepeatingError::gather(const AsBuilt& built, int dip) {
    std::map<std::tuple<long, long, long>, std::vector<PartError>> byPlace;
    std::set<int> parts;
    for (const BuiltPlace& place : built.places) {
        if (place.dip == dip) {
            const auto key = [&](int axis) {
                return std::lround(place.model[std::size_t(axis)].value() / sameBuiltPlace);
            };
            byPlace[{key(0), key(1), key(2)}].push_back(
                {place.part, vectorOf(place.sheet), vectorOf(place.off)});
            parts.insert(place.part);
        }
    }
    parts_ = int(parts.size());
    double squares = 0, freedom = 0;
    std::map<int, std::pair<Eigen::Vector2d, int>>
        ofParts; // per part: sum and number of deviations
    for (const auto& [key, errors] : byPlace) {
        RepeatedPlace& place = places_.emplace_back();
        place.parts = int(errors.size());
        for (const PartError& error : errors) {
            place.sheet += error.sheet / place.parts;
            place.mean += error.off / place.parts;
        }
        double own = 0;
        for (const PartError& error : errors) {
            const Eigen::Vector2d off = error.off - place.mean;
            own += off.squaredNorm();
            auto& [sum, count] =
                ofParts.try_emplace(error.part, Eigen::Vector2d(0, 0), 0).first->second;
            sum += off;
            ++count;
        }
        if (place.parts > 1) {
            place.scatter = std::sqrt(own / (2.0 * (place.parts - 1)));
            squares += own;
            freedom += 2.0 * (place.parts - 1);
        }
    }
    if (freedom == 0) {
        return;
    }
    // The shift of a whole part is subtracted, because it is not scatter of single places.
    double whole = 0, seen = 0;
    for (const auto& [part, off] : ofParts) {
        whole += off.first.squaredNorm() / off.second;
        seen += (off.first / off.second).squaredNorm();
    }
    const double wholes = 2.0 * (parts_ - 1);
    scatter_ = std::sqrt(std::max(squares - whole, 0.0) / std::max(freedom - wholes, 1.0));
    const double expected = scatter_ * scatter_ * parts_ / std::max(1.0, double(places_.size()));
    partScatter_ = std::sqrt(std::max(seen - 2 * expected, 0.0) / wholes);
}

void RepeatingError::fit() {
    for (const RepeatedPlace& place : places_) {
        mean_ += place.mean / double(places_.size());
    }
    // The mean is shrunk towards 0; if it is not larger than the scatter of whole parts, it counts
    // as 0 (W. James and C. Stein, 1961).
    const double ofMean = partScatter_ * partScatter_ / parts_ +
                          scatter_ * scatter_ / (parts_ * double(places_.size()));
    const double square = mean_.squaredNorm() / 2;
    mean_ *= square > ofMean ? 1 - ofMean / square : 0.0;
    std::vector<RepeatedPlace> some;
    const std::size_t step = (places_.size() + fewPlaces - 1) / fewPlaces;
    for (std::size_t i = 0; i < places_.size(); i += step) {
        some.push_back(places_[i]);
    }
    const Eigen::MatrixX2d offs = offsOf(some, mean_);
    const double seen = std::sqrt(offs.squaredNorm() / double(offs.size()));
    std::vector<double> scatters;
    if (scatter_ > 0) {
        scatters.push_back(std::max(scatter_, leastScatter));
    } else {
        for (const double share : guessedScatters) {
            scatters.push_back(std::max(share * seen, leastScatter));
        }
    }
    Chosen best;
    for (const double scatter : scatters) {
        // Size 0 means that there is only scatter, without a repeating error.
        for (const double size :
             {0.0, sizes[0], sizes[1], sizes[2], sizes[3], sizes[4], sizes[5]}) {
            for (const double reach : reaches) {
                Chosen chosen{reach * extent(places_), std::pow(size * seen, 2), scatter};
                chosen.likelihood = likelihood(some, offs, chosen);
                if (chosen.likelihood > best.likelihood) {
                    best = chosen;
                }
            }
        }
    }
    reach_ = best.reach;
    repeating_ = std::sqrt(best.variance);
    weights_ =
        best.variance * covarianceOf(places_, best).llt().solve(offsOf(places_, mean_)).eval();
}

Eigen::Vector2d RepeatingError::at(const Eigen::Vector2d& sheet) const {
    Eigen::Vector2d sum = mean_;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        sum += alike(sheet, places_[i].sheet, reach_) * weights_.row(Eigen::Index(i)).transpose();
    }
    return sum;
}

} // namespace dipwright
