#include "inspection/BuiltPlaces.h"

#include "accuracy/correction/SheetCorrection.h"
#include "base/Error.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::BuiltPlaces)
};

constexpr double step = 0.25;   // mm on the sheet to either side, for derivatives
constexpr int rounds = 8;       // iterations of Newton's method
constexpr double close = 1e-3;  // pixels: a smaller residual counts as converged
constexpr double farthest = 20; // mm on the sheet: largest offset that is searched
// A small circle of the sheet appears in the photo as an ellipse. Places where the ratio of its
// axes is smaller than this are not used.
constexpr double leastFromFront = 0.2;
constexpr double samePlace = 0.01; // mm on the model: nearer places count as one place

// Tells where places of one film's sheet appear in the photos.
class SeenFilm {
public:
    SeenFilm(const LaidFilm& laid, const PartView& camera, QSize picture, QSizeF sheet)
        : laid_(laid), camera_(camera), picture_(picture),
          swell_(laid.film().grid.width / sheet.width(), laid.film().grid.depth / sheet.height()),
          toModel_(laid.body().modelToPose.inverse()) {}

    std::optional<Eigen::Vector2d> at(const Eigen::Vector2d& sheet, int photo) const {
        const Eigen::Vector2d rest = sheet.array() * swell_;
        const auto place = laid_.flat(rest.cast<float>());
        const auto lies = place ? laid_.onBody(*place) : std::nullopt;
        if (!lies) {
            return std::nullopt;
        }
        return seenAt(camera_, photo, picture_, toModel_ * lies->cast<double>());
    }

    // Returns pixels per mm of the sheet, one column per axis.
    std::optional<Eigen::Matrix2d> slope(const Eigen::Vector2d& sheet, int photo) const {
        Eigen::Matrix2d slope;
        for (int axis = 0; axis < 2; ++axis) {
            const Eigen::Vector2d by = step * Eigen::Vector2d::Unit(axis);
            const auto after = at(sheet + by, photo), before = at(sheet - by, photo);
            if (!after || !before) {
                return std::nullopt;
            }
            slope.col(axis) = (*after - *before) / (2 * step);
        }
        return slope;
    }

private:
    const LaidFilm& laid_;
    const PartView& camera_;
    QSize picture_;
    Eigen::Array2d swell_;
    Eigen::Isometry3d toModel_;
};

struct Found {
    Eigen::Vector2d off;
    double pixels = 0; // pixels per mm of the sheet, in the direction in which they are fewest
};

std::optional<Found> sheetOffset(const PrintedPlace& place, const SeenFilm& film) {
    Found found{{0, 0}, 0};
    for (int round = 0; round < rounds; ++round) {
        const Eigen::Vector2d at = place.sheet + found.off;
        const auto seen = film.at(at, place.photo);
        const auto slope = film.slope(at, place.photo);
        if (!seen || !slope) {
            return std::nullopt;
        }
        const Eigen::Vector2d sizes = Eigen::JacobiSVD<Eigen::Matrix2d>(*slope).singularValues();
        if (sizes[1] < leastFromFront * sizes[0]) {
            return std::nullopt;
        }
        found.pixels = sizes[1];
        const Eigen::Vector2d left = place.pixel - *seen;
        if (left.norm() < close) {
            return found;
        }
        found.off += slope->inverse() * left;
        if (!(found.off.norm() < farthest)) {
            return std::nullopt;
        }
    }
    return std::nullopt;
}

} // namespace

std::vector<BuiltPlace> builtPlaces(const std::vector<PrintedPlace>& seen, const PartView& camera,
                                    QSize picture,
                                    const std::vector<std::shared_ptr<const LaidFilm>>& films,
                                    QSizeF sheet, int part) {
    using Key = std::tuple<int, long, long, long>;
    std::map<Key, std::pair<double, BuiltPlace>> best;
    for (const PrintedPlace& place : seen) {
        const auto found =
            sheetOffset(place, {*films[std::size_t(place.dip)], camera, picture, sheet});
        if (!found) {
            continue;
        }
        const auto key = [&](int axis) { return std::lround(place.model[axis] / samePlace); };
        auto& [pixels, built] = best[{place.dip, key(0), key(1), key(2)}];
        if (found->pixels > pixels) {
            pixels = found->pixels;
            built = {part,
                     place.dip + 1,
                     {Millimetres(place.sheet.x()), Millimetres(place.sheet.y())},
                     {Millimetres(place.model.x()), Millimetres(place.model.y()),
                      Millimetres(place.model.z())},
                     {Millimetres(found->off.x()), Millimetres(found->off.y())}};
        }
    }
    std::vector<BuiltPlace> places;
    for (const auto& [key, value] : best) {
        places.push_back(value.second);
    }
    return places;
}

std::vector<PrintedPlace> onPrintedSheet(std::vector<PrintedPlace> places, const AsBuilt& built) {
    for (const int dip : {1, 2}) {
        if (!isCorrected(built, dip)) {
            continue;
        }
        const RepeatingError error(built, dip);
        for (PrintedPlace& place : places) {
            if (place.dip == dip - 1) {
                place.sheet = printedAt(place.sheet, error, built.strength);
            }
        }
    }
    return places;
}

double residualOf(const std::vector<BuiltPlace>& places) {
    double sum = 0;
    for (const BuiltPlace& place : places) {
        sum += std::pow(place.off[0].value(), 2) + std::pow(place.off[1].value(), 2);
    }
    return places.empty() ? 0 : std::sqrt(sum / double(places.size()));
}

AsBuilt withBuiltPart(AsBuilt built, const std::vector<BuiltPlace>& places, BuiltPart part,
                      const QString& where) {
    if (places.empty()) {
        throw Error(Text::tr("None of the measured places lies on film that adheres to the part; "
                             "check that the photos show a part of this job"),
                    where);
    }
    if (built.parts.size() >= mostBuiltParts ||
        built.places.size() + places.size() > mostBuiltPlaces) {
        throw Error(
            Text::tr(
                "The job can keep at most %1 parts and %2 places; this part would exceed the limit")
                .arg(mostBuiltParts)
                .arg(mostBuiltPlaces),
            where);
    }
    if (std::any_of(built.parts.begin(), built.parts.end(),
                    [&](const BuiltPart& other) { return other.photos == part.photos; })) {
        throw Error(
            Text::tr(
                "The job already contains the part in these photos; a part may be added only once"),
            where);
    }
    part.residual = residualOf(places);
    built.parts.push_back(std::move(part));
    built.places.insert(built.places.end(), places.begin(), places.end());
    return built;
}

} // namespace dipwright
