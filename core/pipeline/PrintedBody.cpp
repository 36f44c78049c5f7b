#include "pipeline/PrintedBody.h"

namespace dipwright {

std::vector<FilmAppearance> filmAppearances(const std::vector<ImmersionResult>& immersions,
                                            bool white) {
    std::vector<FilmAppearance> films;
    for (const ImmersionResult& immersion : immersions) {
        films.push_back({immersion.laid, immersion.texture->image});
        films.back().white = white ? immersion.texture->white : QImage();
        const std::vector<ArtworkLayer> spots = immersion.inputs.texture.paint.artwork.spots();
        for (std::size_t spot = 0; spot < immersion.texture->spots.size(); ++spot) {
            films.back().spots.push_back({immersion.texture->spots[spot], spots[spot].spotColour});
        }
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
