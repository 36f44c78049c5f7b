#include "inspection/FlatFilm.h"

#include "base/Error.h"
#include "base/NumberText.h"
#include "base/Units.h"
#include "inspection/LeastSquares.h"
#include "inspection/LinearProjection.h"
#include "sheet/page/WatchPage.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <map>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::FilmWatch)
};

// Largest residual of a flat card, as a share of half the picture's diagonal. The error with which
// corners are found is about a tenth of this.
constexpr double mostCardOff = 0.001;
constexpr double mm = 100; // mm per unit of the fit, so that the fit's numbers are near 1

using Places = std::vector<Eigen::Vector2d>;

// Returns the corners' places on the printed page, from the board's upper left corner, in units of
// the fit.
Places printedPlaces(const SeenBoard& board, const std::array<double, 2>& scale) {
    Places places;
    for (const SeenCorner& corner : board.corners) {
        places.emplace_back(corner.column * boardSquare(board.kind) * scale[0] / mm,
                            corner.row * boardSquare(board.kind) * scale[1] / mm);
    }
    return places;
}

Places seenPlaces(const SeenBoard& board, const LensPlane& plane) {
    Places places;
    for (const SeenCorner& corner : board.corners) {
        places.push_back(plane.inUnits(corner.place));
    }
    return places;
}

Eigen::Map<const Eigen::Matrix2Xd> columnsOf(const Places& places) {
    return {places.front().data(), 2, Eigen::Index(places.size())};
}

// Parameters: the homography of the water (8 numbers), the film on the water (a 2 × 2 matrix by
// columns, then its shift), and k1 and k2 if no lens is known.
class FlatFit {
public:
    FlatFit(const SeenBoard& film, const SeenBoard& card, QSize picture,
            const FlatSettings& settings)
        : settings_(settings), plane_(picture), film_(printedPlaces(film, settings.filmScale)),
          card_(printedPlaces(card, settings.cardScale)), filmSeen_(seenPlaces(film, plane_)),
          cardSeen_(seenPlaces(card, plane_)) {}

    int count() const { return int(2 * (film_.size() + card_.size())); }

    Eigen::VectorXd start() const {
        const Lens lens = settings_.lens.value_or(Lens());
        Places seen;
        for (const Eigen::Vector2d& place : cardSeen_) {
            seen.push_back(undistorted(place, lens));
        }
        Eigen::Matrix3d water = linearProjection(columnsOf(card_), columnsOf(seen));
        water /= water(2, 2);
        const Eigen::Matrix3d back = water.inverse();
        Eigen::MatrixXd rows(Eigen::Index(film_.size()), 3), lies(Eigen::Index(film_.size()), 2);
        for (std::size_t i = 0; i < film_.size(); ++i) {
            rows.row(Eigen::Index(i)) << film_[i].x(), film_[i].y(), 1;
            lies.row(Eigen::Index(i)) =
                projected(back, undistorted(filmSeen_[i], lens)).transpose();
        }
        const Eigen::MatrixXd affine = rows.colPivHouseholderQr().solve(lies);
        Eigen::VectorXd start(settings_.lens ? 14 : 16);
        start << water(0, 0), water(0, 1), water(0, 2), water(1, 0), water(1, 1), water(1, 2),
            water(2, 0), water(2, 1), affine(0, 0), affine(0, 1), affine(1, 0), affine(1, 1),
            affine(2, 0), affine(2, 1), Eigen::VectorXd::Zero(settings_.lens ? 0 : 2);
        return start;
    }

    void residuals(const Eigen::VectorXd& p, Eigen::VectorXd& values) const {
        const Eigen::Matrix3d water = waterOf(p);
        const Eigen::Matrix3d card = raised(water);
        const Lens lens = lensOf(p);
        Eigen::Index at = 0;
        for (std::size_t i = 0; i < film_.size(); ++i, at += 2) {
            values.segment<2>(at) =
                distorted(projected(water, onWater(p, film_[i])), lens) - filmSeen_[i];
        }
        for (std::size_t i = 0; i < card_.size(); ++i, at += 2) {
            values.segment<2>(at) = distorted(projected(card, card_[i]), lens) - cardSeen_[i];
        }
    }

    Lens lensOf(const Eigen::VectorXd& p) const {
        return settings_.lens.value_or(p.size() > 14 ? Lens{p[14], p[15]} : Lens{});
    }

    // The film's corners, in units of the fit. Each corner has three places: on the printed page,
    // on an evenly swollen film, and as seen in the photo.
    const Places& printed() const { return film_; }
    static Eigen::Vector2d onWater(const Eigen::VectorXd& p, const Eigen::Vector2d& printed) {
        return {p[8] * printed.x() + p[10] * printed.y() + p[12],
                p[9] * printed.x() + p[11] * printed.y() + p[13]};
    }
    Eigen::Vector2d seenOnWater(const Eigen::VectorXd& p, std::size_t corner) const {
        return projected(waterOf(p).inverse(), undistorted(filmSeen_[corner], lensOf(p)));
    }
    double pixels() const { return plane_.unit(); } // pixels per unit of the residuals
    // Returns the root mean square residual of the card's corners, in units of the fit.
    double cardOff(const Eigen::VectorXd& residuals) const {
        const double count = double(card_.size());
        return residuals.tail(2 * Eigen::Index(card_.size())).norm() / std::sqrt(count);
    }

private:
    static Eigen::Matrix3d waterOf(const Eigen::VectorXd& p) {
        Eigen::Matrix3d water;
        water << p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], 1;
        return water;
    }

    // Returns the homography of the plane that lies `cardAbove` over the water. Only its third
    // column differs, by the camera's matrix times a step along the normal. The inverse of the
    // camera's matrix turns the first two columns into directions in the plane; the normal is
    // perpendicular to both.
    Eigen::Matrix3d raised(const Eigen::Matrix3d& water) const {
        if (settings_.cardAbove == 0 || !settings_.focalLength) {
            return water;
        }
        const double f = *settings_.focalLength;
        const Eigen::Vector3d camera(1 / f, 1 / f, 1);
        const Eigen::Vector3d x = camera.cwiseProduct(water.col(0));
        const Eigen::Vector3d y = camera.cwiseProduct(water.col(1));
        // x × y points away from the camera if the plane is seen from above.
        const Eigen::Vector3d up = -x.cross(y) / std::sqrt(x.norm() * y.norm());
        Eigen::Matrix3d card = water;
        card.col(2) += settings_.cardAbove / mm * Eigen::Vector3d(f, f, 1).cwiseProduct(up);
        return card;
    }

    const FlatSettings& settings_;
    LensPlane plane_;
    Places film_, card_, filmSeen_, cardSeen_;
};

// Returns the swell along one axis, with its uncertainty. It is the length of the vector
// (p[first], p[first + 1]).
Measured swellOf(const LeastSquaresFit& fit, Eigen::Index first, double sigma) {
    const Eigen::Vector2d step = fit.parameters.segment<2>(first);
    const Eigen::Vector2d slope = step.normalized();
    const double variance = slope.dot(fit.covariance.block<2, 2>(first, first) * slope);
    return {step.norm(), deviationsFor95 * sigma * std::sqrt(std::max(0.0, variance))};
}

// Fills in each corner's swell: the mean over its neighbours in both directions, if they were
// found.
void fillSwell(std::vector<FilmCorner>& corners) {
    std::map<std::pair<int, int>, const FilmCorner*> at;
    for (const FilmCorner& corner : corners) {
        at[{corner.column, corner.row}] = &corner;
    }
    const auto between = [&](int c1, int r1, int c2, int r2) -> std::optional<double> {
        const auto first = at.find({c1, r1}), second = at.find({c2, r2});
        if (first == at.end() || second == at.end()) {
            return std::nullopt;
        }
        return (second->second->lies - first->second->lies).norm() /
               (second->second->printed - first->second->printed).norm();
    };
    for (FilmCorner& corner : corners) {
        const int c = corner.column, r = corner.row;
        const auto across = between(c - 1, r, c + 1, r), down = between(c, r - 1, c, r + 1);
        if (across && down) {
            corner.swell = std::sqrt(*across * *down);
        }
    }
}

double percentile95(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0 : values[std::size_t(0.95 * double(values.size() - 1))];
}

void requireCorners(const SeenBoard& board, const QString& sentence, const QString& where) {
    if (int(board.corners.size()) < leastWatchCorners) {
        throw Error(sentence.arg(board.corners.size()).arg(leastWatchCorners), where);
    }
}

Residuals residualsOf(const FlatFit& problem) {
    return [&problem](const Eigen::VectorXd& p, Eigen::VectorXd& values) {
        problem.residuals(p, values);
    };
}

void requireDetermined(const LeastSquaresFit& fit, const QString& where) {
    if (!fit.converged || !fit.determined) {
        throw Error(Text::tr("The position of the film cannot be determined from the visible "
                             "corners; photograph the whole film and the whole card from above"),
                    where);
    }
}

// Wrong values for camera or card may not scatter the film's corners, but they always move the
// card's corners from their places on a flat card.
void requireFlatCard(const FlatFit& problem, const LeastSquaresFit& fit, const QString& where) {
    const double off = problem.cardOff(fit.residuals);
    if (!(off < mostCardOff)) {
        throw Error(
            Text::tr(
                "The card's corners lie %1 px from their places on a flat card; lay the card flat, "
                "and correct or clear the values for lens distortion, focal length and card height")
                .arg(numberText(off * problem.pixels(), 1)),
            where);
    }
}

void requireBoth(const SeenBoard& film, const SeenBoard& card, const QString& where) {
    requireCorners(film,
                   Text::tr("Only %1 corners of the film's chessboard are visible, but %2 are "
                            "needed; photograph all of it, without glare"),
                   where);
    requireCorners(card,
                   Text::tr("Only %1 corners of the card are visible, but %2 are needed; "
                            "photograph all of it, without glare"),
                   where);
}

} // namespace

FlatFilm fitFlatFilm(const SeenBoard& film, const SeenBoard& card, QSize picture,
                     const FlatSettings& settings, const QString& where) {
    // Median distance from the centre if points scatter with standard deviation 1 in both
    // directions.
    constexpr double medianOfDistances = 1.17741;
    requireBoth(film, card, where);
    const FlatFit problem(film, card, picture, settings);
    const LeastSquaresFit fit =
        robustLeastSquares(residualsOf(problem), problem.count(), problem.start());
    requireDetermined(fit, where);
    requireFlatCard(problem, fit, where);
    // Uses the median, because a few points mistaken for corners do not move it.
    const double freedom = double(problem.count() - fit.parameters.size()) / problem.count();
    const double sigma =
        medianLength(fit.residuals, problem.count() / 2) / medianOfDistances / std::sqrt(freedom);
    FlatFilm result;
    result.swellX = swellOf(fit, 8, sigma);
    result.swellY = swellOf(fit, 10, sigma);
    result.lens = problem.lensOf(fit.parameters);
    for (const SeenCorner& corner : card.corners) {
        result.cardCorners.push_back(corner.place);
    }
    result.residualPixels =
        problem.pixels() * std::sqrt(2 * fit.residuals.squaredNorm() / problem.count());
    const Eigen::Vector2d x = fit.parameters.segment<2>(8), y = fit.parameters.segment<2>(10);
    result.shearDegrees = std::asin(x.normalized().dot(y.normalized())) * 180 / pi;
    std::vector<double> uneven;
    for (std::size_t i = 0; i < film.corners.size(); ++i) {
        const Eigen::Vector2d& printed = problem.printed()[i];
        const Eigen::Vector2d lies = problem.seenOnWater(fit.parameters, i);
        const Eigen::Vector2d off = lies - FlatFit::onWater(fit.parameters, printed);
        const SeenCorner& corner = film.corners[i];
        result.corners.push_back({corner.column, corner.row, corner.place, printed * mm, lies * mm,
                                  off * mm, std::nullopt});
        uneven.push_back(off.norm() * mm);
    }
    fillSwell(result.corners);
    result.unevennessMillimetres = percentile95(std::move(uneven));
    return result;
}

} // namespace dipwright
