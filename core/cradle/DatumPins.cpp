#include "cradle/DatumPins.h"

#include "settings/FilmSettings.h"
#include "sheet/page/SheetLayout.h"

#include <algorithm>

namespace dipwright {

DatumPins datumPins(const Sheet& sheet, const FilmSettings& film, Millimetres farthest) {
    Sheet bare = sheet;
    bare.image = {};
    bare.settings.marks = true;
    bare.settings.ruler = false;
    bare.settings.jobLine = false;
    const SheetLayout layout = sheetLayout(bare);
    std::array<QPointF, 3> corners{layout.film.topLeft(), layout.film.topRight(),
                                   layout.film.bottomLeft()};
    if (!layout.marks.empty()) {
        corners = {layout.marks[0].centre, layout.marks[1].centre, layout.marks[2].centre};
    }
    DatumPins result;
    double apart = 0;
    for (std::size_t pin = 0; pin < corners.size(); ++pin) {
        const QPointF printed = corners[pin] - layout.film.center();
        result.marks[pin] = {printed.x() * film.swellX, printed.y() * film.swellY};
        apart = std::max(apart, 2 * result.marks[pin].cwiseAbs().maxCoeff());
    }
    result.share = std::min(1.0, farthest.value() / apart);
    std::transform(result.marks.begin(), result.marks.end(), result.pins.begin(),
                   [&](const Eigen::Vector2d& mark) { return (result.share * mark).eval(); });
    return result;
}

} // namespace dipwright
