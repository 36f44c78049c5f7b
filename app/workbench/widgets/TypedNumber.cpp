#include "workbench/widgets/TypedNumber.h"

#include "base/Units.h"

#include <QMap>
#include <QRegularExpression>
#include <algorithm>
#include <optional>

namespace dipwright {
namespace {

// A unit's dimension and its size in the base unit.
struct Measure {
    int metres = 0, seconds = 0; // exponents of length and time
    double size = 1;             // in mm, s or mm/s
};

const QMap<QString, double>& lengths() {
    constexpr double millimetresPerFoot = 12 * millimetresPerInch;
    static const QMap<QString, double> table{{QStringLiteral("mm"), 1},
                                             {QStringLiteral("cm"), 10},
                                             {QStringLiteral("m"), 1000},
                                             {QStringLiteral("um"), 1e-3},
                                             {QStringLiteral("µm"), 1e-3},
                                             {QStringLiteral("μm"), 1e-3},
                                             {QStringLiteral("in"), millimetresPerInch},
                                             {QStringLiteral("inch"), millimetresPerInch},
                                             {QStringLiteral("inches"), millimetresPerInch},
                                             {QStringLiteral("\""), millimetresPerInch},
                                             {QStringLiteral("″"), millimetresPerInch},
                                             {QStringLiteral("''"), millimetresPerInch},
                                             {QStringLiteral("zoll"), millimetresPerInch},
                                             {QStringLiteral("pol"), millimetresPerInch},
                                             {QStringLiteral("ft"), millimetresPerFoot},
                                             {QStringLiteral("'"), millimetresPerFoot},
                                             {QStringLiteral("′"), millimetresPerFoot}};
    return table;
}

const QMap<QString, double>& times() {
    static const QMap<QString, double> table{{QStringLiteral("ms"), 1e-3},
                                             {QStringLiteral("s"), 1},
                                             {QStringLiteral("min"), 60},
                                             {QStringLiteral("h"), 3600}};
    return table;
}

std::optional<Measure> measureOf(const QString& unit) {
    const QString word = unit.toLower();
    const auto slash = word.indexOf(u'/');
    const auto length = lengths().constFind(word.left(slash).trimmed());
    if (slash >= 0) {
        const auto time = times().constFind(word.mid(slash + 1).trimmed());
        if (length == lengths().cend() || time == times().cend()) {
            return std::nullopt;
        }
        return Measure{1, -1, *length / *time};
    }
    if (length != lengths().cend()) {
        return Measure{1, 0, *length};
    }
    const auto time = times().constFind(word);
    return time == times().cend() ? std::nullopt : std::optional(Measure{0, 1, *time});
}

// Returns the factor that converts a number in the unit `typed` to the unit `own`; nullopt if their
// dimensions differ.
std::optional<double> factor(const QString& typed, const QString& own) {
    if (typed.isEmpty() || typed == own) {
        return 1;
    }
    const std::optional<Measure> from = measureOf(typed);
    const std::optional<Measure> to = measureOf(own);
    if (!from || !to || from->metres != to->metres || from->seconds != to->seconds) {
        return std::nullopt;
    }
    return from->size / to->size;
}

// Returns whether the digits are in groups of three, all separated by the same sign.
bool isGrouped(const QString& whole) {
    static const QRegularExpression groups(
        QStringLiteral("^\\d{1,3}(?<sign>[.,'’ \\x{00a0}\\x{202f}])\\d{3}(?:\\k<sign>\\d{3})*$"));
    return groups.match(whole).hasMatch();
}

QString digitsOf(QString number) {
    static const QRegularExpression others(QStringLiteral("[^0-9]"));
    return number.remove(others);
}

// Returns the possible values of digits with separators, without a leading sign. Empty if the text
// is not a number.
std::vector<double> readings(const QString& number, const QLocale& locale) {
    static const QRegularExpression whole(QStringLiteral("^\\d+$"));
    const auto sign =
        std::max(number.lastIndexOf(u'.'), number.lastIndexOf(u',')); // decimal, if there is one
    std::vector<double> values;
    if (sign >= 0) {
        const QString before = number.left(sign);
        const QString after = number.mid(sign + 1);
        const bool isPlain = before.isEmpty() || whole.match(before).hasMatch();
        const bool areGroups = isGrouped(before) && !before.contains(number[sign]);
        if ((isPlain || areGroups) &&
            (after.isEmpty() ? isPlain && !before.isEmpty() : whole.match(after).hasMatch())) {
            values.push_back((digitsOf(before) + u'.' + after).toDouble());
        }
    } else if (whole.match(number).hasMatch()) {
        values.push_back(number.toDouble());
    }
    const bool isDecimal = !values.empty() && (sign < 0 || locale.decimalPoint() == number[sign]);
    if (!isDecimal && isGrouped(number) && !number.startsWith(u'0')) {
        values.push_back(digitsOf(number).toDouble());
    }
    return values;
}

} // namespace

TypedNumber typedNumber(const QString& text, const QString& unit, const QLocale& locale) {
    static const QRegularExpression parts(QStringLiteral(
        "^\\s*(?<minus>[+\\-−]?)\\s*(?<number>(?:\\d(?:[\\d.,]|['’ \\x{00a0}\\x{202f}](?=\\d))*|"
        "[.,]\\d+))\\s*(?<unit>.*?)\\s*$"));
    const QRegularExpressionMatch match = parts.match(text);
    if (!match.hasMatch()) {
        return {};
    }
    const QString typedUnit = match.captured(QStringLiteral("unit"));
    const std::optional<double> scale = factor(typedUnit, unit);
    if (!scale) {
        return {{}, typedUnit};
    }
    const QString minus = match.captured(QStringLiteral("minus"));
    const bool isNegative = minus == QLatin1String("-") || minus == QStringLiteral("−");
    TypedNumber typed;
    for (const double value : readings(match.captured(QStringLiteral("number")), locale)) {
        typed.values.push_back((isNegative ? -value : value) * *scale);
    }
    return typed;
}

} // namespace dipwright
