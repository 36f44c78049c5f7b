#include "inspection/BuiltPlaces.h"

#include "accuracy/correction/SheetCorrection.h"
#include "base/Error.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <limits>
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

// Tells where the places of a sheet lie on the model in the simulation.
class SheetOnModel {
public:
    SheetOnModel(const LaidFilm& laid, QSizeF sheet)
        : laid_(laid),
          swell_(laid.film().grid.width / sheet.width(), laid.film().grid.depth / sheet.height()),
          toModel_(laid.body().modelToPose.inverse()) {}

    std::optional<Eigen::Vector3d> at(const Eigen::Vector2d& sheet) const {
        const Eigen::Vector2d rest = sheet.array() * swell_;
        const auto place = laid_.flat(rest.cast<float>());
        const auto lies = place ? laid_.onBody(*place) : std::nullopt;
        return lies ? std::optional<Eigen::Vector3d>(toModel_ * lies->cast<double>())
                    : std::nullopt;
    }

private:
    const LaidFilm& laid_;
    Eigen::Array2d swell_;
    Eigen::Isometry3d toModel_;
};

// Tells where places of one film's sheet appear in the photos.
class SeenFilm {
public:
    SeenFilm(const LaidFilm& laid, const PartView& camera, QSize picture, QSizeF sheet)
        : onModel_(laid, sheet), camera_(camera), picture_(picture) {}

    std::optional<Eigen::Vector2d> at(const Eigen::Vector2d& sheet, int photo) const {
        const auto lies = onModel_.at(sheet);
        return lies ? std::optional(seenAt(camera_, photo, picture_, *lies)) : std::nullopt;
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
    SheetOnModel onModel_;
    const PartView& camera_;
    QSize picture_;
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

// A mistake in the coordinates of the sheet, and how to undo it: axes * sheet + shift.
struct Mistake {
    Eigen::Matrix2d axes;
    Eigen::Vector2d shift;
    QString advice;
};

std::vector<Mistake> usualMistakes(QSizeF sheet) {
    const auto axes = [](double a, double b, double c, double d) {
        Eigen::Matrix2d matrix;
        matrix << a, b, c, d;
        return matrix;
    };
    const Eigen::Vector2d none(0, 0), half(sheet.width() / 2, sheet.height() / 2);
    return {
        {axes(1, 0, 0, -1), none,
         Text::tr("they fit if sheet_y_mm has the other sign: it increases downwards on the "
                  "floating sheet, ink side up")},
        {axes(-1, 0, 0, 1), none,
         Text::tr("they fit if sheet_x_mm has the other sign: it increases rightwards on the "
                  "floating sheet, ink side up")},
        {axes(-1, 0, 0, -1), none,
         Text::tr("they fit if sheet_x_mm and sheet_y_mm have the other sign")},
        {axes(0, 1, 1, 0), none, Text::tr("they fit if sheet_x_mm and sheet_y_mm are swapped")},
        {axes(1, 0, 0, 1), -half,
         Text::tr("they fit if they are counted from the sheet's top left corner; count them from "
                  "its middle")},
        {axes(1, 0, 0, -1),
         {-half.x(), half.y()},
         Text::tr("they fit if they are counted from the sheet's bottom left corner; count them "
                  "from its middle, downwards")}};
}

// Returns the median distance of the simulated places from their targets, in mm; infinite if half
// of the places do not lie on the part.
double medianOffTarget(const std::vector<PrintedPlace>& places,
                       const std::vector<SheetOnModel>& films, const Eigen::Matrix2d& axes,
                       const Eigen::Vector2d& shift) {
    std::vector<double> off;
    for (const PrintedPlace& place : places) {
        const auto lies = films[std::size_t(place.dip)].at(axes * place.sheet + shift);
        off.push_back(lies ? (*lies - place.model.cast<double>()).norm()
                           : std::numeric_limits<double>::infinity());
    }
    const auto middle = off.begin() + std::ptrdiff_t(off.size() / 2);
    std::nth_element(off.begin(), middle, off.end());
    return *middle;
}

// Returns what to do about places that are off their targets.
QString adviceOnPlaces(const std::vector<PrintedPlace>& places,
                       const std::vector<SheetOnModel>& films, QSizeF sheet) {
    double least = mostOffTarget;
    QString advice = Text::tr("check that they belong to this job and its present settings");
    for (const Mistake& mistake : usualMistakes(sheet)) {
        const double off = medianOffTarget(places, films, mistake.axes, mistake.shift);
        if (off < least) {
            least = off;
            advice = mistake.advice;
        }
    }
    return advice;
}

template <typename Place>
void requireAllOnBody(const std::vector<Place>& places, const SurfaceQuery& surface,
                      const QString& where) {
    const auto off = std::count_if(places.begin(), places.end(), [&](const Place& place) {
        return !surface.isNear(place.model.template cast<float>(), float(farOffBody));
    });
    if (double(off) > mostOffBody * double(places.size())) {
        throw Error(Text::tr("%1 of %2 places x_mm, y_mm, z_mm lie more than %3 mm from the "
                             "surface of the job's model; check that the table belongs to this "
                             "part, and is in millimetres and in the model's coordinates")
                        .arg(off)
                        .arg(places.size())
                        .arg(farOffBody),
                    where);
    }
}

} // namespace

void requireOnTargets(const std::vector<PrintedPlace>& places,
                      const std::vector<std::shared_ptr<const LaidFilm>>& films, QSizeF sheet,
                      const QString& where) {
    std::vector<SheetOnModel> onModel;
    for (const auto& film : films) {
        onModel.emplace_back(*film, sheet);
    }
    if (!places.empty() &&
        medianOffTarget(places, onModel, Eigen::Matrix2d::Identity(), {0, 0}) > mostOffTarget) {
        throw Error(Text::tr("The simulation carries half of the printed places more than %1 mm "
                             "away from their targets x_mm, y_mm, z_mm; %2")
                        .arg(mostOffTarget)
                        .arg(adviceOnPlaces(places, onModel, sheet)),
                    where);
    }
}

void requireOnBody(const std::vector<PrintedPlace>& places, const SurfaceQuery& surface,
                   const QString& where) {
    requireAllOnBody(places, surface, where);
}

void requireOnBody(const std::vector<PlacePair>& pairs, const SurfaceQuery& surface,
                   const QString& where) {
    requireAllOnBody(pairs, surface, where);
}

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
        const auto key = [&](int axis) { return std::lround(place.model[axis] / sameBuiltPlace); };
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
                      QSizeF sheet, const QString& where) {
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
    const QStringList photos = part.photos.split(u' ');
    if (std::any_of(built.parts.begin(), built.parts.end(), [&](const BuiltPart& other) {
            return std::ranges::any_of(other.photos.split(u' ', Qt::SkipEmptyParts),
                                       [&](const QString& one) { return photos.contains(one); });
        })) {
        throw Error(
            Text::tr(
                "The job already contains the part in these photos; a part may be added only once"),
            where);
    }
    const Millimetres width(sheet.width()), height(sheet.height());
    AsBuilt alone; // many correct parts would hide the errors of a wrong one
    alone.places = places;
    requirePossibleErrors(alone, width, height, where);
    part.residual = residualOf(places);
    built.parts.push_back(std::move(part));
    built.places.insert(built.places.end(), places.begin(), places.end());
    requirePossibleErrors(dippedAlike(built, built.parts.back().dips.split(u' ')), width, height,
                          where);
    return built;
}

} // namespace dipwright
