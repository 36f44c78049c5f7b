#include "settings/SearchSettings.h"

#include "base/Error.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(PoseSearch)
};

void require(double value, double least, double most, const QString& where) {
    if (!(value >= least && value <= most)) {
        throw Error(Text::tr("Choose a number from %1 to %2").arg(least).arg(most, 0, 'g', 10),
                    where);
    }
}

// `others` are names that can be chosen, too, in a message.
Measure measureOf(const QString& key, const QStringList& others = {}) {
    QStringList keys;
    for (const Measure measure : allMeasures()) {
        if (measureKey(measure) == key) {
            return measure;
        }
        keys.append(measureKey(measure));
    }
    throw Error(Text::tr("There is no measure with this name; choose one of %1")
                    .arg((keys + others).join(QStringLiteral(", "))),
                key);
}

} // namespace

const std::array<Measure, measureCount>& allMeasures() {
    static constexpr std::array<Measure, measureCount> all{
        Measure::Quality,  Measure::Coverage, Measure::Stretch,    Measure::Certain,
        Measure::Wrinkled, Measure::Torn,     Measure::TrappedAir, Measure::Join,
        Measure::Narrow,   Measure::FilmUsed};
    return all;
}

QString measureKey(Measure measure) {
    static const std::array<const char*, measureCount> keys{
        "quality", "coverage",    "stretch", "certain",        "wrinkled",
        "torn",    "trapped_air", "join",    "narrow_overlap", "film_used"};
    return QString::fromLatin1(keys[std::size_t(measure)]);
}

QString measureName(Measure measure) {
    switch (measure) {
    case Measure::Quality:
        return Text::tr("Quality");
    case Measure::Coverage:
        return Text::tr("Coverage");
    case Measure::Stretch:
        return Text::tr("Largest stretch");
    case Measure::Certain:
        return Text::tr("Film without faults");
    case Measure::Wrinkled:
        return Text::tr("Wrinkled film");
    case Measure::Torn:
        return Text::tr("Torn film");
    case Measure::TrappedAir:
        return Text::tr("Trapped air");
    case Measure::Join:
        return Text::tr("Seam length");
    case Measure::Narrow:
        return Text::tr("Narrow overlap");
    case Measure::FilmUsed:
        return Text::tr("Film used");
    }
    return {};
}

QString measureText(Measure measure, double value) {
    const QLocale locale;
    switch (measure) {
    case Measure::Stretch:
        return value < largestStretch
                   ? locale.toString(value, 'f', 2)
                   : QStringLiteral("≥ %1").arg(locale.toString(largestStretch, 'f', 0));
    case Measure::Join:
        return QStringLiteral("%1 mm").arg(locale.toString(value, 'f', 0));
    default:
        return QStringLiteral("%1 %").arg(locale.toString(100 * value, 'f', 1));
    }
}

bool isHigherBetter(Measure measure) {
    return measure == Measure::Quality || measure == Measure::Coverage ||
           measure == Measure::Certain;
}

bool appliesToTwoDips(Measure measure) {
    return measure == Measure::Join || measure == Measure::Narrow;
}

double mostLimit(Measure measure) {
    switch (measure) {
    case Measure::Stretch:
        return 100;
    case Measure::Join:
        return 1e6;
    default:
        return 1;
    }
}

QString zoneKey(std::size_t zone) {
    return QStringLiteral("zone_") + QChar(u'a' + char16_t(zone));
}

void requireValid(const SearchSettings& settings) {
    require(settings.immersions, 1, 2, QStringLiteral("immersions"));
    require(settings.directions, directionsRange.least, directionsRange.most,
            QStringLiteral("directions"));
    require(settings.simulated, simulatedRange.least, simulatedRange.most,
            QStringLiteral("candidates"));
    require(settings.refined, refinedRange.least, refinedRange.most, QStringLiteral("refined"));
    require(settings.finer, finerRange.least, finerRange.most, QStringLiteral("finer"));
    require(settings.confirmed, confirmedRange.least, confirmedRange.most,
            QStringLiteral("confirmed"));
    require(settings.seed, seedRange.least, seedRange.most, QStringLiteral("seed"));
    double sum = 0;
    for (const Measure measure : allMeasures()) {
        require(settings.aims.weights[measure], 0, mostWeight, measureKey(measure));
        const bool counts = settings.immersions == 2 || !appliesToTwoDips(measure);
        sum += counts ? settings.aims.weights[measure] : 0;
        if (const std::optional<double>& limit = settings.aims.limits[measure]) {
            require(*limit, 0, mostLimit(measure), measureKey(measure));
        }
    }
    double zones = 0;
    for (const double weight : settings.aims.zoneWeights) {
        require(weight, 0, mostZoneWeight, Text::tr("weight of a zone"));
        zones += weight;
    }
    if (!(sum > 0) || !(zones > 0)) {
        throw Error(Text::tr("All weights are 0; set at least one weight above 0"),
                    QStringLiteral("weights"));
    }
}

void setWeight(PoseAims& aims, const QString& key, double value) {
    QStringList zones;
    for (std::size_t zone = 0; zone < zoneCount; ++zone) {
        zones << zoneKey(zone);
        if (key == zoneKey(zone)) {
            require(value, 0, mostZoneWeight, key);
            aims.zoneWeights[zone] = value;
            return;
        }
    }
    const Measure measure = measureOf(key, zones);
    require(value, 0, mostWeight, key);
    aims.weights[measure] = value;
}

void setLimit(PoseAims& aims, const QString& key, std::optional<double> value) {
    const Measure measure = measureOf(key);
    if (value) {
        require(*value, 0, mostLimit(measure), key);
    }
    aims.limits[measure] = value;
}

} // namespace dipwright
