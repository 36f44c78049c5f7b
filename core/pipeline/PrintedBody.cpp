#include "pipeline/PrintedBody.h"

namespace dipwright {

std::vector<WornFilm> wornFilms(const std::vector<ImmersionResult>& immersions, bool white) {
    std::vector<WornFilm> films;
    for (const ImmersionResult& immersion : immersions) {
        films.push_back({immersion.laid, immersion.texture->image});
        films.back().white = white ? immersion.texture->white : QImage();
    }
    return films;
}

Ground groundOf(const SheetSettings& sheet, const QString& baseColour) {
    Ground ground;
    if (!baseColour.isEmpty()) {
        ground.base = QColor(baseColour);
    }
    ground.whiteOutside = sheet.white == WhiteLayer::First;
    return ground;
}

} // namespace dipwright
