#include "cradle/DatumPins.h"

#include "settings/FilmSettings.h"
#include "sheet/page/SheetLayout.h"

#include <algorithm>

namespace dipwright {

DatumPins datumPins(const Sheet& sheet, const FilmSettings& film, Millimetres farthest) {
    const QPointF corner = marksOnFilm(sheet).value_or(
        QPointF(sheet.filmWidth.value() / 2, sheet.filmHeight.value() / 2));
    const double x = corner.x() * film.swellX, z = corner.y() * film.swellY;
    DatumPins result;
    result.marks = {Eigen::Vector2d(-x, -z), Eigen::Vector2d(x, -z), Eigen::Vector2d(-x, z)};
    const double apart = 2 * std::max(x, z);
    result.share = std::min(1.0, farthest.value() / apart);
    std::transform(result.marks.begin(), result.marks.end(), result.pins.begin(),
                   [&](const Eigen::Vector2d& mark) { return (result.share * mark).eval(); });
    return result;
}

} // namespace dipwright
