#include "texture/WedgeTable.h"

#include "base/Error.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <optional>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::WedgeTable)
};

const QByteArray columns = "ink,nominal,flat,across,down,shown";
const QStringList inkNames{QStringLiteral("cyan"), QStringLiteral("magenta"),
                           QStringLiteral("yellow"), QStringLiteral("black"),
                           QStringLiteral("white")};
constexpr double ruler = 100; // mm, of the page's rulers before the film is stretched
constexpr int mostReadings = 10'000;

// None where one of them is no finite number.
std::optional<std::vector<double>> numbers(const QStringList& words) {
    std::vector<double> values;
    for (const QString& word : words) {
        bool isNumber = false;
        values.push_back(QLocale::c().toDouble(word.trimmed(), &isNumber));
        if (!isNumber || !std::isfinite(values.back())) {
            return std::nullopt;
        }
    }
    return values;
}

std::vector<FilmInk> inksOf(const QString& word) {
    if (word == QLatin1String("grey")) {
        return {FilmInk::Cyan, FilmInk::Magenta, FilmInk::Yellow};
    }
    const auto index = inkNames.indexOf(word);
    return index < 0 ? std::vector<FilmInk>() : std::vector{FilmInk(index)};
}

QString shortest(double number) {
    return QString::number(number, 'g', QLocale::FloatingPointShortest);
}

} // namespace

QString inkName(FilmInk ink) {
    return inkNames.at(int(ink));
}

std::vector<WedgeReading> readWedge(const QByteArray& table, const QString& where) {
    const QStringList lines = QString::fromUtf8(table).split(u'\n');
    if (lines.size() > mostReadings || lines.front().trimmed() != QLatin1String(columns)) {
        throw Error(
            Text::tr("The table of a wedge begins with the line %1 and has at most %2 lines")
                .arg(QLatin1String(columns))
                .arg(mostReadings),
            where);
    }
    std::vector<WedgeReading> readings;
    for (int line = 1; line < lines.size(); ++line) {
        const QStringList words = lines[line].trimmed().split(u',');
        // A reading that was not made is left out.
        if (words.size() == 1 || words.back().trimmed().isEmpty()) {
            continue;
        }
        const std::vector<FilmInk> inks = inksOf(words.front().trimmed());
        const auto values = numbers(words.mid(1));
        if (words.size() != 6 || inks.empty() || !values) {
            throw Error(Text::tr("Line %1 of the wedge is not an ink (cyan, magenta, yellow, "
                                 "black, white or grey) and five numbers, joined by commas")
                            .arg(line + 1),
                        where);
        }
        const std::vector<double>& v = *values;
        for (const FilmInk ink : inks) {
            readings.push_back({ink, v[0], v[1], v[2] * v[3] / (ruler * ruler), v[4]});
        }
    }
    return readings;
}

QByteArray blankWedge(int stretches, bool black) {
    QByteArray table = columns + '\n';
    for (const QString& ink : inkNames.first(black ? lightInks + 1 : lightInks)) {
        for (const double tone : wedgeTones) {
            for (int stretch = 0; stretch < stretches; ++stretch) {
                table += ink.toUtf8() + ',' + QByteArray::number(tone) + ",,,,\n";
            }
        }
    }
    return table;
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
        const std::vector<FilmInk> inks = inksOf(words.front());
        const auto values = numbers(words.mid(1));
        const auto isWithin = [&](std::size_t index, double least, double most) {
            return (*values)[index] >= least && (*values)[index] <= most;
        };
        if (words.size() != 5 || inks.size() != 1 || !values || parts.size() > mostInkTones ||
            !isWithin(0, leastToneDensity, mostToneDensity) ||
            !isWithin(1, -mostInkExponent, mostInkExponent) ||
            !isWithin(2, -mostInkBend, mostInkBend) || !isWithin(3, 1, mostWedgeStretch)) {
            throw Error(Text::tr("“%1” is no tone of an ink, which is its name, density, exponent, "
                                 "bend and greatest stretch, such as cyan 0.3 0.48 0.1 2.9")
                            .arg(part.trimmed().left(60)),
                        where);
        }
        const std::vector<double>& v = *values;
        tones.push_back({inks.front(), v[0], v[1], v[2], v[3]});
    }
    checkInkLaw({{}, tones}, where);
    return tones;
}

} // namespace dipwright
