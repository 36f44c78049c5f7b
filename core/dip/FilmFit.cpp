#include "dip/FilmFit.h"

#include "base/Error.h"
#include "film/FilmGrid.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Dip)
};

// Returns the length of a printed film that extends past both `low` and `high` after swelling, mm.
double lengthFor(double low, double high, double swell) {
    constexpr double step = 10, rim = 10; // mm
    return step * std::ceil(2 * (std::max(std::abs(low), std::abs(high)) + rim) / (swell * step));
}

} // namespace

std::optional<FilmSize> smallestFilm(const Eigen::AlignedBox2d& outline, const FilmSettings& film) {
    const FilmSize least{lengthFor(outline.min().x(), outline.max().x(), film.swellX),
                         lengthFor(outline.min().y(), outline.max().y(), film.swellY)};
    return std::max(least.width, least.height) <= largestFilm ? std::optional(least) : std::nullopt;
}

QString adviceOnFilm(const Eigen::AlignedBox2d& outline, const FilmSettings& film) {
    const std::optional<FilmSize> least = smallestFilm(outline, film);
    if (least && least->width <= film.height.value() && least->height <= film.width.value()) {
        return Text::tr("turn the film by 90° (%1 × %2 mm)")
            .arg(film.height.value())
            .arg(film.width.value());
    }
    return least ? Text::tr("choose a film that is clearly larger than %1 × %2 mm, because film "
                            "also covers the part's sides")
                       .arg(std::max(least->width, film.width.value()))
                       .arg(std::max(least->height, film.height.value()))
                 : Text::tr("check the model's size and unit, because no film is larger than %1 mm")
                       .arg(largestFilm);
}

void requireFilmBeyondBody(const Eigen::AlignedBox2d& outline, const FilmSettings& film,
                           const Immersion& immersion) {
    const solver::FilmGrid grid = filmGrid(film);
    const Eigen::Vector2d half(grid.width / 2, grid.depth / 2);
    if (outline.isEmpty() || (outline.min().array() >= -half.array()).any() ||
        (outline.max().array() <= half.array()).any()) {
        return;
    }
    throw Error(Text::tr("The part, %1 × %2 mm on the water, reaches past the film on all sides, "
                         "so no film is left to wrap round it; %3")
                    .arg(std::round(outline.sizes().x()))
                    .arg(std::round(outline.sizes().y()))
                    .arg(adviceOnFilm(outline, film)),
                immersion.name);
}

} // namespace dipwright
