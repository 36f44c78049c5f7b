#include "workbench/accuracy/ZoneAppearance.h"

#include "results/Results.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(ZoneAppearance)
};

// Distinguishable with any colour vision (Okabe & Ito).
const std::array<QColor, zoneCount> hues{QColor(0x00, 0x72, 0xb2), QColor(0x00, 0x9e, 0x73),
                                         QColor(80, 70, 90)};
const QColor past(0xd5, 0x5e, 0x00);

constexpr double even = 0.8; // strength of a zone's colour without tolerances
constexpr double steps = 4;  // shades that the eye can distinguish

QColor mixed(const QColor& colour, double share) {
    const auto part = [share](int value) { return int(std::lround(255 + share * (value - 255))); };
    return {part(colour.red()), part(colour.green()), part(colour.blue())};
}

// Returns the largest displacement of the image at a piece of the surface over all dips, mm.
// Returns unpaintedPlace if no dip paints the piece.
float spreadAt(const JobTolerances& tolerances, std::size_t piece) {
    float worst = unpaintedPlace;
    for (const DipTolerances& dip : tolerances.dips) {
        worst = std::max(worst, dip.pieces[piece]);
    }
    return worst;
}

QColor colourOf(std::size_t zone, double spread, double limit) {
    const double used = std::ceil(steps * spread / limit) / steps;
    return spread < 0 ? painterColour(Painter::None)
           : used > 1 ? past
                      : mixed(hues[zone], 0.15 + 0.85 * used);
}

} // namespace

QColor zoneColour(Zone zone) {
    return mixed(hues[std::size_t(zone)], even);
}

BodyAppearance zoneAppearance(std::shared_ptr<const TexturedMesh> body, const ZonedBody& zones,
                              const JobTolerances* tolerances, const ToleranceSettings& settings) {
    BodyAppearance appearance{std::move(body), {}};
    std::array<bool, zoneCount> isThere{};
    for (std::size_t piece = 0; piece < zones.zones().size(); ++piece) {
        const auto zone = std::size_t(zones.zones()[piece]);
        isThere[zone] = true;
        const QColor colour = tolerances ? colourOf(zone, double(spreadAt(*tolerances, piece)),
                                                    settings.limits[zone].value())
                                         : mixed(hues[zone], even);
        appearance.colours.push_back(colour.rgb());
    }
    for (std::size_t zone = 0; zone < zoneCount; ++zone) {
        if (isThere[zone]) {
            appearance.legend.push_back(
                {tolerances ? hues[zone] : mixed(hues[zone], even),
                 Text::tr("Zone %1, ±%2 mm")
                     .arg(zoneName(Zone(zone)),
                          QLocale().toString(settings.limits[zone].value()))});
        }
    }
    if (tolerances) {
        appearance.legend.push_back(
            {mixed(hues[0], 0.15), Text::tr("Pale: well within the limit")});
        appearance.legend.push_back({past, Text::tr("Above the limit")});
        appearance.legend.push_back({painterColour(Painter::None), Text::tr("Not painted")});
    }
    return appearance;
}

} // namespace dipwright
