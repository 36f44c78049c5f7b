#include "cradle/CradleForm.h"

#include "parallel/ParallelFor.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <functional>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Cradle)
};

constexpr double farAway = 1e3;     // mm; larger than any distance that matters
constexpr int freeCells = 2;        // number of free cells round the cradle
constexpr double leastShare = 1e-3; // in cells: least distance of the surface from a sample

// Computes the distance from a surface and from the space that it sweeps when it moves down. Query
// the places of one column from top to bottom.
class SweptDistance {
public:
    SweptDistance(const SurfaceQuery* query, const TriangleMesh* mesh, double within)
        : query_(query), mesh_(mesh), within_(within) {}

    // Returns the distance at `place`, which must be the next place down; exact up to `within`.
    // `atLeast` is a known lower bound of the distance from the surface.
    double next(const Eigen::Vector3f& place, double atLeast, bool isInside) {
        if (!query_ || atLeast >= within_ || least_ < -within_) {
            return least_;
        }
        const ClosestPoint nearest = query_->closest(place, float(within_));
        if (nearest.point.isValid()) {
            const Eigen::Vector3f there = position(*mesh_, nearest.point) - place;
            // A point of the surface that is higher up passes this place on its way down; their
            // distance is then horizontal.
            const double away = isInside         ? -double(nearest.distance)
                                : there.y() >= 0 ? double(std::hypot(there.x(), there.z()))
                                                 : double(nearest.distance);
            least_ = std::min(least_, away);
        }
        return least_;
    }

private:
    const SurfaceQuery* query_;
    const TriangleMesh* mesh_;
    double within_;
    double least_ = farAway;
};

class Form {
public:
    Form(const HeldDip& dip, const FilmSide& side, const CradleDistances& distances)
        : body_(dip.film.body()), field_(dip.field), poseToBody_(body_.bodyToPose.inverse()),
          side_(side), distances_(distances), within_(distances.outer + 2 * dip.field.spacing) {
        if (!side.film.triangles.empty()) {
            film_.emplace(side.film);
        }
        if (!side.earlierPaint.triangles.empty()) {
            paint_.emplace(side.earlierPaint);
        }
    }

    // Fills `values` with the distance from the seat along one column, from the bottom; negative in
    // the seat.
    void fillColumn(const DistanceField& grid, int i, int k, std::vector<double>& values) const {
        SweptDistance body(&body_.query, &body_.mesh, within_);
        SweptDistance film(film_ ? &*film_ : nullptr, &side_.film, distances_.film + grid.spacing);
        SweptDistance paint(paint_ ? &*paint_ : nullptr, &side_.earlierPaint,
                            distances_.earlierPaint + grid.spacing);
        for (int j = grid.size[1] - 1; j >= 0; --j) {
            const Eigen::Vector3d place = grid.origin + grid.spacing * Eigen::Vector3d(i, j, k);
            const double rough = field_.sample(poseToBody_ * place);
            // The cells of the field smooth details away, so its values may be too large.
            const double atLeast = std::max(0.0, std::abs(rough) - 2 * field_.spacing);
            const Eigen::Vector3f where = place.cast<float>();
            const double away = body.next(where, atLeast, rough < 0);
            const double fromFilm = film.next(where, atLeast, false);
            const double fromPaint = paint.next(where, atLeast, false);
            values[std::size_t(j)] =
                std::max({distances_.body - away, distances_.film - fromFilm,
                          distances_.earlierPaint - fromPaint, away - distances_.outer,
                          distances_.lowest - place.y()});
        }
        // All material continues up to the plate, so that no piece is loose.
        for (std::size_t j = 1; j < values.size(); ++j) {
            values[j] = std::min(values[j], values[j - 1]);
        }
    }

private:
    const PosedBody& body_;
    const DistanceField& field_;
    Eigen::Isometry3d poseToBody_;
    const FilmSide& side_;
    CradleDistances distances_;
    double within_;
    std::optional<SurfaceQuery> film_, paint_;
};

// One number per column of a grid, at index k·columns + i.
using OverColumns = std::vector<double>;

// Returns the lowest y at which a column is filled; `none` if the column stays empty.
double lowestFilled(const DistanceField& grid, const std::vector<double>& values, double none) {
    for (std::size_t j = 0; j < values.size(); ++j) {
        if (values[j] < 0) {
            const double share = j == 0 ? 0 : values[j] / (values[j] - values[j - 1]);
            return grid.origin.y() + grid.spacing * (double(j) - share);
        }
    }
    return none;
}

// Returns, per column, the highest of the numbers within `reach` columns of it.
OverColumns highestRound(const OverColumns& values, int columns, int rows, int reach) {
    OverColumns result(values.size());
    parallelFor(0, rows, [&](int k) {
        for (int i = 0; i < columns; ++i) {
            double highest = -farAway;
            for (int beside = -reach; beside <= reach; ++beside) {
                const int width = int(std::sqrt(reach * reach - beside * beside));
                const int row = std::clamp(k + beside, 0, rows - 1);
                for (int c = std::max(i - width, 0); c <= std::min(i + width, columns - 1); ++c) {
                    highest = std::max(highest, values[std::size_t(row * columns + c)]);
                }
            }
            result[std::size_t(k * columns + i)] = highest;
        }
    });
    return result;
}

// Returns where columns must begin so that nothing is thinner than 2·reach. This is a morphological
// opening by upright cylinders (Serra, Image Analysis and Mathematical Morphology, 1982). It only
// removes material.
OverColumns openedFrom(const OverColumns& lowest, int columns, int rows, int reach) {
    OverColumns narrowed = highestRound(lowest, columns, rows, reach);
    std::transform(narrowed.begin(), narrowed.end(), narrowed.begin(), std::negate<>());
    OverColumns result = highestRound(narrowed, columns, rows, reach);
    std::transform(result.begin(), result.end(), result.begin(), std::negate<>());
    return result;
}

DistanceField gridOf(const CradlePlate& plate, double lowest, double cell) {
    DistanceField grid;
    grid.spacing = cell;
    const Eigen::Vector3d low(plate.outline.min().x(), lowest, plate.outline.min().y());
    const Eigen::Vector3d high(plate.outline.max().x(), plate.top, plate.outline.max().y());
    grid.origin = low - Eigen::Vector3d::Constant(freeCells * cell);
    for (int axis = 0; axis < 3; ++axis) {
        grid.size[std::size_t(axis)] =
            int(std::ceil((high[axis] - low[axis]) / cell)) + 1 + 2 * freeCells;
    }
    return grid;
}

// Adds the plate, the holes and the engraving to the seat, column by column.
class Plate {
public:
    Plate(const CradlePlate& plate, double engravingDepth)
        : plate_(plate), engraved_(plate.engraving), floor_(plate.top - engravingDepth) {}

    // `lowest` is the y below which the column is empty.
    void finishColumn(const DistanceField& grid, int i, int k, double lowest,
                      std::vector<double>& values) const {
        const Eigen::Vector2d place(grid.origin.x() + grid.spacing * i,
                                    grid.origin.z() + grid.spacing * k);
        const double outside = plate_.outside(place);
        const double letters = engraved_.inside(place);
        double hole = -farAway;
        for (const PlateHole& pin : plate_.pinHoles) {
            hole = std::max(hole, pin.radius - (place - pin.centre).norm());
        }
        const double bore =
            plate_.bore ? plate_.bore->radius - (place - plate_.bore->centre).norm() : -farAway;
        for (std::size_t j = 0; j < values.size(); ++j) {
            const double y = grid.origin.y() + grid.spacing * double(j);
            const double seat =
                std::max({values[j], lowest - y, y - (plate_.bottom + plate_.top) / 2});
            const double plate = std::max({outside, plate_.bottom - y, y - plate_.top, hole});
            const double whole = std::min(seat, plate);
            const double value = std::max({whole, hole, bore, std::min(letters, y - floor_)});
            const double least = leastShare * grid.spacing;
            values[j] = std::abs(value) < least ? std::copysign(least, value) : value;
        }
    }

private:
    const CradlePlate& plate_;
    EngravedArea engraved_;
    double floor_;
};

// Calls change(i, k, values) with the samples of each column from bottom to top, and stores the
// result.
template <typename Change>
void forEachColumn(DistanceField& grid, const Progress& progress, const Change& change) {
    const auto columns = std::size_t(grid.size[0]), rows = std::size_t(grid.size[1]);
    parallelFor(0, grid.size[2], [&](int k) {
        progress.cancelToken.throwIfCancelled();
        std::vector<double> values(rows);
        for (int i = 0; i < grid.size[0]; ++i) {
            float* const column =
                grid.distance.data() + std::size_t(k) * rows * columns + std::size_t(i);
            for (std::size_t j = 0; j < rows; ++j) {
                values[j] = double(column[j * columns]);
            }
            change(i, k, values);
            for (std::size_t j = 0; j < rows; ++j) {
                column[j * columns] = float(values[j]);
            }
        }
    });
}

} // namespace

double formSamples(const CradlePlate& plate, double lowest, double cell) {
    const Eigen::Vector2d sizes = plate.outline.sizes();
    return sizes.x() * sizes.y() * (plate.top - lowest) / (cell * cell * cell);
}

DistanceField cradleForm(const HeldDip& dip, const CradleSettings& settings, const FilmSide& side,
                         const CradlePlate& plate, const CradleDistances& distances, double cell,
                         const Progress& progress) {
    progress(0, Text::tr("Forming the cradle"));
    DistanceField grid = gridOf(plate, distances.lowest, cell);
    grid.distance.resize(std::size_t(grid.size[0]) * std::size_t(grid.size[1]) *
                         std::size_t(grid.size[2]));
    const Form form(dip, side, distances);
    OverColumns lowest(std::size_t(grid.size[0]) * std::size_t(grid.size[2]));
    forEachColumn(grid, progress, [&](int i, int k, std::vector<double>& values) {
        form.fillColumn(grid, i, k, values);
        lowest[std::size_t(k * grid.size[0] + i)] = lowestFilled(grid, values, plate.top);
    });
    const int reach = int(settings.wall.value() / 2 / cell);
    const OverColumns opened = openedFrom(lowest, grid.size[0], grid.size[2], reach);
    const Plate finish(plate, settings.engravingDepth.value());
    forEachColumn(grid, progress, [&](int i, int k, std::vector<double>& values) {
        const auto column = std::size_t(k * grid.size[0] + i);
        const bool isCut = opened[column] > lowest[column] + cell / 2;
        finish.finishColumn(grid, i, k, isCut ? opened[column] : -farAway, values);
    });
    return grid;
}

} // namespace dipwright
