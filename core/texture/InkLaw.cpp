#include "texture/InkLaw.h"

#include "base/Error.h"
#include "settings/InkTones.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <map>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::InkLaw)
};

constexpr double leastWedgeStretch = 1.02; // smaller stretches are below the reading's error
// Least ratio between the stretches of a patch from which `bend` is fitted.
constexpr double apartForBend = 1.15;
// Density by which errors of reading may make stretched film look denser than unstretched film.
constexpr double readingError = 0.02;

void checkReading(const WedgeReading& reading, const QString& where) {
    const double most = reading.ink == FilmInk::White ? 1 : mostToneDensity;
    const auto isDensity = [most](double density) {
        return density >= leastToneDensity && density <= most;
    };
    if (!isDensity(reading.nominal) || !isDensity(reading.flat) || !isDensity(reading.shown)) {
        throw Error(Text::tr("A density must be from %1 to %2; zero the densitometer on film "
                             "without ink, or leave the patch out")
                        .arg(leastToneDensity)
                        .arg(most),
                    where);
    }
    if (!(reading.stretch >= leastWedgeStretch && reading.stretch <= mostWedgeStretch)) {
        throw Error(Text::tr("The stretched area must be %1 to %2 times the unstretched area; "
                             "leave this reading out")
                        .arg(leastWedgeStretch)
                        .arg(mostWedgeStretch),
                    where);
    }
}

// Fits −ln(shown/flat) = exponent·ln J + bend·(ln J)² by least squares. Fits the bend only if the
// stretches differ enough; otherwise it is 0.
InkTone fittedTone(const std::vector<WedgeReading>& patch, const QString& where) {
    double s2 = 0, s3 = 0, s4 = 0, t1 = 0, t2 = 0;
    double least = mostWedgeStretch, most = 1;
    for (const WedgeReading& reading : patch) {
        const double grown = std::log(reading.stretch);
        const double thinner = -std::log(reading.shown / reading.flat);
        s2 += grown * grown;
        s3 += grown * grown * grown;
        s4 += grown * grown * grown * grown;
        t1 += thinner * grown;
        t2 += thinner * grown * grown;
        least = std::min(least, reading.stretch);
        most = std::max(most, reading.stretch);
    }
    InkTone tone{patch.front().ink, patch.front().nominal, t1 / s2, 0, most};
    if (most > apartForBend * least) {
        const double determinant = s2 * s4 - s3 * s3;
        tone.exponent = (t1 * s4 - t2 * s3) / determinant;
        tone.bend = (s2 * t2 - s3 * t1) / determinant;
    }
    const double denser = patch.front().flat * (thinned(tone, most) - 1);
    if (denser > readingError || std::abs(tone.exponent) > mostInkExponent ||
        std::abs(tone.bend) > mostInkBend) {
        throw Error(
            Text::tr(
                "The readings of the patch of density %1 are impossible for ink; check that its "
                "densities and stretches are in the right rows")
                .arg(tone.density),
            where);
    }
    return tone;
}

} // namespace

FittedInk fitInk(std::span<const WedgeReading> readings, const QString& where) {
    std::map<std::pair<FilmInk, double>, std::vector<WedgeReading>> patches;
    for (const WedgeReading& reading : readings) {
        checkReading(reading, reading.line > 0
                                  ? Text::tr("%1, line %2").arg(where).arg(reading.line)
                                  : where);
        patches[{reading.ink, reading.nominal}].push_back(reading);
    }
    if (patches.empty() || int(patches.size()) > mostInkTones) {
        throw Error(Text::tr("A wedge needs 1 to %1 patches with readings on stretched film")
                        .arg(mostInkTones),
                    where);
    }
    FittedInk fitted;
    for (const auto& [key, patch] : patches) {
        const InkTone tone = fittedTone(patch, where);
        fitted.law.tones.push_back(tone);
        ++fitted.patches;
        for (const WedgeReading& reading : patch) {
            const double law = reading.flat * thinned(tone, reading.stretch);
            fitted.worst = std::max(fitted.worst, std::abs(law - reading.shown));
        }
    }
    checkInkLaw(fitted.law, where);
    return fitted;
}

} // namespace dipwright
