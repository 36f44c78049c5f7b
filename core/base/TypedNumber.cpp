#include "base/TypedNumber.h"

#include "base/Units.h"

#include <QHash>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <optional>

namespace dipwright {
namespace {

// The exponents of the base quantities.
struct Dimension {
    int length = 0, time = 0, angle = 0, share = 0;
    int own = 0; // of a field's unit that is not in the table

    bool operator==(const Dimension&) const = default;
};

// A number in mm, s, °, % and the field's own unit.
struct Amount {
    double number = 1;
    Dimension dimension = {};
};

// Returns left · right, or left / right if the exponent is −1.
Amount product(const Amount& left, const Amount& right, int exponent = 1) {
    const auto sum = [exponent](int a, int b) { return a + exponent * b; };
    const Dimension &a = left.dimension, &b = right.dimension;
    return {exponent > 0 ? left.number * right.number : left.number / right.number,
            {sum(a.length, b.length), sum(a.time, b.time), sum(a.angle, b.angle),
             sum(a.share, b.share), sum(a.own, b.own)}};
}

const QHash<QString, Amount>& knownUnits() {
    constexpr Dimension length{1}, perLength{-1}, time{0, 1}, angle{0, 0, 1}, share{0, 0, 0, 1};
    constexpr Dimension angularSpeed{0, -1, 1};
    constexpr double inch = millimetresPerInch, foot = 12 * inch;
    const auto u = [](const char* word) { return QString::fromUtf8(word); };
    static const QHash<QString, Amount> table{{u("mm"), {1, length}},
                                              {u("cm"), {10, length}},
                                              {u("m"), {1000, length}},
                                              {u("um"), {1e-3, length}},
                                              {u("µm"), {1e-3, length}},
                                              {u("μm"), {1e-3, length}},
                                              {u("in"), {inch, length}},
                                              {u("inch"), {inch, length}},
                                              {u("inches"), {inch, length}},
                                              {u("\""), {inch, length}},
                                              {u("″"), {inch, length}},
                                              {u("''"), {inch, length}},
                                              {u("zoll"), {inch, length}},
                                              {u("pol"), {inch, length}},
                                              {u("ft"), {foot, length}},
                                              {u("'"), {foot, length}},
                                              {u("′"), {foot, length}},
                                              {u("ms"), {1e-3, time}},
                                              {u("s"), {1, time}},
                                              {u("sec"), {1, time}},
                                              {u("min"), {60, time}},
                                              {u("h"), {3600, time}},
                                              {u("°"), {1, angle}},
                                              {u("º"), {1, angle}},
                                              {u("deg"), {1, angle}},
                                              {u("rad"), {180 / pi, angle}},
                                              {u("turn"), {360, angle}},
                                              {u("turns"), {360, angle}},
                                              {u("%"), {1, share}},
                                              {u("‰"), {0.1, share}},
                                              {u("dpi"), {1 / inch, perLength}},
                                              {u("rpm"), {6, angularSpeed}}};
    return table;
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

// Returns the possible values of digits with separators and an exponent such as "e3", the decimal
// one first. Empty if the text is not a number.
std::vector<double> readings(const QString& number, const QString& exponent,
                             const QLocale& locale) {
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
            values.push_back((digitsOf(before) + u'.' + after + exponent).toDouble());
        }
    } else if (whole.match(number).hasMatch()) {
        values.push_back((number + exponent).toDouble());
    }
    const bool isDecimal = !values.empty() && (sign < 0 || locale.decimalPoint() == number[sign]);
    if (!isDecimal && isGrouped(number) && !number.startsWith(u'0')) {
        values.push_back((digitsOf(number) + exponent).toDouble());
    }
    return values;
}

using Fault = TypedNumber::Fault;

struct Unreadable {
    Fault fault;
    QString unit = {};
};

// What a number without a unit means, and how numbers are written.
struct Rules {
    QString ownWord; // the field's unit
    Amount own;
    QLocale locale;
    bool takesGroups = false; // the later of two readings of a number
};

// Reads a calculation from left to right. Throws Unreadable.
class Calculation {
public:
    Calculation(const QString& text, const Rules& rules) : rest_(text), rules_(rules) {}

    Amount whole() { return ended(sum()); }
    // Reads a unit such as mm/s².
    Amount unitOnly() {
        Amount result = unit();
        while (take(u"/")) {
            result = product(result, unit(), -1);
        }
        return ended(result);
    }

private:
    Amount ended(const Amount& result) {
        if (!skipSpace().isEmpty()) {
            throw Unreadable{Fault::NotANumber};
        }
        return result;
    }
    Amount sum() {
        Amount total = term();
        while (const int sign = takeSign()) {
            total = added(total, term(), sign);
        }
        return total;
    }
    Amount term() {
        Amount result = number();
        while (true) {
            if (take(u"*×·")) {
                result = product(result, number());
            } else if (take(u"/÷")) {
                result = product(result, isUnitNext() ? unit() : number(false), -1);
            } else {
                return result;
            }
        }
    }
    // A number or a sum in brackets, with its sign and its unit.
    Amount number(bool mayBeFraction = true) {
        if (const int sign = takeSign()) {
            return product({double(sign)}, number(mayBeFraction));
        }
        Amount result;
        if (take(u"(")) {
            result = sum();
            if (!take(u")")) {
                throw Unreadable{Fault::NotANumber};
            }
        } else {
            result.number = digits();
            static const QRegularExpression over(QStringLiteral("^\\s*/(?=\\s*[\\d.,])"));
            if (mayBeFraction && takeMatch(over)) {
                result.number /= digits();
            }
        }
        return isUnitNext() ? product(result, unit()) : result;
    }
    double digits() {
        static const QRegularExpression number(
            QStringLiteral("^\\s*(?:\\d(?:[\\d.,]|['’ \\x{00a0}\\x{202f}](?=\\d))*|[.,]\\d+)"));
        static const QRegularExpression power(QStringLiteral("^[eE][+-]?\\d+"));
        const QString mantissa = takeMatch(number).value_or(QString()).trimmed();
        const std::vector<double> values =
            readings(mantissa, takeMatch(power).value_or(QString()), rules_.locale);
        if (values.empty()) {
            throw Unreadable{Fault::NotANumber};
        }
        if (std::isinf(values.front())) {
            throw Unreadable{Fault::TooLarge};
        }
        return rules_.takesGroups ? values.back() : values.front();
    }
    Amount unit() {
        if (const QString& own = rules_.ownWord;
            !own.isEmpty() && skipSpace().startsWith(own) &&
            (rest_.size() == own.size() || !rest_[own.size()].isLetter())) {
            rest_.remove(0, own.size());
            return rules_.own;
        }
        static const QRegularExpression unit(
            QStringLiteral("^\\s*(?:\\p{L}+|''|[^\\p{L}\\d\\s()+*/])"));
        const QString word = takeMatch(unit).value_or(QString()).trimmed();
        const auto known = knownUnits().constFind(word.toLower());
        if (known == knownUnits().cend()) {
            throw Unreadable{Fault::UnknownUnit, word};
        }
        return take(u"²") ? product(*known, *known) : *known;
    }
    bool isUnitNext() {
        static const QRegularExpression others(QStringLiteral("^[\\d.,()+\\-−*/÷·]"));
        // A × at the end is the unit of a ratio.
        const bool isSign = skipSpace().startsWith(u'×') && rest_.size() > 1;
        return !rest_.isEmpty() && !isSign && !others.match(rest_).hasMatch();
    }
    // A term without a unit is in the field's unit if the other term has a unit.
    Amount added(const Amount& left, const Amount& right, int sign) const {
        const auto fitting = [this](const Amount& one, const Amount& other) {
            const bool isPlain = one.dimension == Dimension{} && one.dimension != other.dimension;
            return isPlain ? product(one, rules_.own) : one;
        };
        const Amount a = fitting(left, right), b = fitting(right, left);
        if (a.dimension != b.dimension) {
            throw Unreadable{Fault::OtherQuantity};
        }
        return {a.number + sign * b.number, a.dimension};
    }
    int takeSign() { return take(u"+") ? 1 : take(u"-−") ? -1 : 0; }
    bool take(QStringView signs) {
        const bool found = !skipSpace().isEmpty() && signs.contains(rest_.front());
        rest_.remove(0, found ? 1 : 0);
        return found;
    }
    std::optional<QString> takeMatch(const QRegularExpression& pattern) {
        const QRegularExpressionMatch match = pattern.match(rest_);
        rest_.remove(0, match.capturedLength());
        return match.hasMatch() ? std::optional(match.captured()) : std::nullopt;
    }
    const QString& skipSpace() { return rest_ = rest_.trimmed(); }

    QString rest_;
    const Rules& rules_;
};

// Returns the amount that the field's unit stands for, such as mm or 1/s.
Amount ownAmount(const QString& unit) {
    const Rules plain{{}, {}, QLocale::c()};
    try {
        return unit.isEmpty()           ? Amount{}
               : unit.startsWith(u"1/") ? Calculation(unit, plain).whole()
                                        : Calculation(unit, plain).unitOnly();
    } catch (const Unreadable&) {
        return {1, {0, 0, 0, 0, 1}};
    }
}

double inOwnUnit(const Amount& amount, const Amount& own) {
    const bool isPlain = amount.dimension == Dimension{};
    if (!isPlain && amount.dimension != own.dimension) {
        throw Unreadable{Fault::OtherQuantity};
    }
    const double value = isPlain ? amount.number : amount.number / own.number;
    if (!std::isfinite(value)) {
        throw Unreadable{Fault::NotANumber};
    }
    return value;
}

} // namespace

TypedNumber typedNumber(const QString& text, const QString& unit, const QLocale& locale) {
    constexpr int longest = 200; // brackets within brackets use the stack
    if (text.size() > longest) {
        return {{}, Fault::NotANumber};
    }
    TypedNumber typed;
    Rules rules{unit, ownAmount(unit), locale};
    try {
        for (const bool takesGroups : {false, true}) {
            rules.takesGroups = takesGroups;
            typed.values.push_back(inOwnUnit(Calculation(text, rules).whole(), rules.own));
        }
    } catch (const Unreadable& reason) {
        return {{}, reason.fault, reason.unit};
    }
    if (typed.values[0] == typed.values[1]) {
        typed.values.pop_back();
    }
    return typed;
}

} // namespace dipwright
