#include "settings/InkTones.h"

#include "base/Error.h"
#include "base/NumberText.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::InkLaw)
};

const QStringList inkNames{QStringLiteral("cyan"), QStringLiteral("magenta"),
                           QStringLiteral("yellow"), QStringLiteral("black"),
                           QStringLiteral("white")};

QString shortest(double number) {
    return QString::number(number, 'g', QLocale::FloatingPointShortest);
}

} // namespace

QString inkName(FilmInk ink) {
    return inkNames.at(int(ink));
}

std::optional<FilmInk> inkOf(const QString& name) {
    const auto index = inkNames.indexOf(name);
    return index < 0 ? std::nullopt : std::optional(FilmInk(index));
}

QString inkTonesText(const std::vector<InkTone>& tones) {
    QStringList parts;
    for (const InkTone& tone : tones) {
        parts.append(QStringList{inkName(tone.ink), shortest(tone.density), shortest(tone.exponent),
                                 shortest(tone.bend), shortest(tone.mostStretch)}
                         .join(u' '));
    }
    return parts.join(QStringLiteral("; "));
}

std::vector<InkTone> inkTones(const QString& text, const QString& where) {
    std::vector<InkTone> tones;
    if (text.trimmed().isEmpty()) {
        return tones;
    }
    const QStringList parts = text.split(u';');
    for (const QString& part : parts) {
        const QStringList words = part.simplified().split(u' ');
        const std::optional<FilmInk> ink = inkOf(words.front());
        const auto values = finiteNumbers(words.mid(1));
        const auto isWithin = [&](std::size_t index, double least, double most) {
            return (*values)[index] >= least && (*values)[index] <= most;
        };
        if (words.size() != 5 || !ink || !values || parts.size() > mostInkTones ||
            !isWithin(0, leastToneDensity, mostToneDensity) ||
            !isWithin(1, -mostInkExponent, mostInkExponent) ||
            !isWithin(2, -mostInkBend, mostInkBend) || !isWithin(3, 1, mostWedgeStretch)) {
            throw Error(Text::tr("“%1” is not an ink tone; write ink, density, exponent, bend and "
                                 "greatest stretch, such as cyan 0.3 0.48 0.1 2.9")
                            .arg(part.trimmed().left(60)),
                        where);
        }
        const std::vector<double>& v = *values;
        tones.push_back({*ink, v[0], v[1], v[2], v[3]});
    }
    checkInkLaw({{}, tones}, where);
    return tones;
}

void checkInkLaw(const InkLaw& law, const QString& where) {
    for (std::size_t next = 1; next < law.tones.size(); ++next) {
        const InkTone& low = law.tones[next - 1];
        const InkTone& high = law.tones[next];
        if (low.ink > high.ink) {
            throw Error(Text::tr("Sort the tones by ink: cyan, magenta, yellow, black, white"),
                        where);
        }
        if (low.ink < high.ink) {
            continue;
        }
        if (!(low.density < high.density)) {
            throw Error(Text::tr("Sort the tones of an ink by increasing density"), where);
        }
        for (const double share : {0.25, 0.5, 0.75, 1.0}) {
            const double stretch = std::pow(std::max(low.mostStretch, high.mostStretch), share);
            if (!(low.density * thinned(low, stretch) < high.density * thinned(high, stretch))) {
                throw Error(
                    Text::tr("On film with an area stretch of %3, the patch of density %2 would "
                             "look lighter than the patch of density %1; measure both again")
                        .arg(roundedText(low.density, 6))
                        .arg(roundedText(high.density, 6))
                        .arg(numberText(stretch, 2)),
                    where);
            }
        }
    }
}

double thinned(const InkTone& tone, double stretch) {
    const double grown = std::log(std::min(stretch, tone.mostStretch));
    return std::exp(-(tone.exponent + tone.bend * grown) * std::log(stretch));
}

std::optional<std::vector<double>> finiteNumbers(const QStringList& words) {
    std::vector<double> values;
    for (const QString& word : words) {
        bool isNumber = false;
        values.push_back(word.trimmed().toDouble(&isNumber));
        if (!isNumber || !std::isfinite(values.back())) {
            return std::nullopt;
        }
    }
    return values;
}

} // namespace dipwright
