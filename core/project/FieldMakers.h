// Makes the fields of a schema from a path, a rule and an access function. Private to this folder.
#pragma once

#include "base/Error.h"
#include "base/OneLine.h"
#include "base/Units.h"
#include "project/Field.h"
#include "settings/InkTones.h"

#include <QColor>
#include <QJsonArray>
#include <cmath>
#include <limits>
#include <type_traits>

namespace dipwright {

struct Project;

// The highest growth rate and growth limit that may be entered or measured.
inline constexpr double mostGrowthRate = 1; // 1/s
inline constexpr double mostGrowth = 1;     // share of the length

// The file's words for false and true in FilmEdges.
inline QStringList edgeWords() {
    return {QStringLiteral("free"), QStringLiteral("pinned")};
}

inline double plainNumber(double number) {
    return number;
}
template <typename Unit>
double plainNumber(Quantity<Unit> quantity) {
    return quantity.value();
}

// The unit in which the file holds a value of this type; empty for plain numbers.
template <typename Value>
QString storedUnit() {
    const bool isSpeed = std::is_same_v<Value, MillimetresPerSecond>;
    const bool isAcceleration = std::is_same_v<Value, MillimetresPerSecondSquared>;
    return std::is_same_v<Value, Millimetres>        ? QStringLiteral("mm")
           : std::is_same_v<Value, Seconds>          ? QStringLiteral("s")
           : isSpeed                                 ? QStringLiteral("mm/s")
           : isAcceleration                          ? QStringLiteral("mm/s²")
           : std::is_same_v<Value, Degrees>          ? QStringLiteral("°")
           : std::is_same_v<Value, DegreesPerSecond> ? QStringLiteral("°/s")
           : std::is_same_v<Value, DotsPerInch>      ? QStringLiteral("dpi")
                                                     : QString();
}

// `access` is a generic lambda that takes an owner, const or not, and returns a reference to the
// value.
template <typename Owner, typename Access>
using ValueOf = std::remove_cvref_t<decltype(std::declval<Access>()(std::declval<Owner&>()))>;

template <typename Owner = Project, typename Access>
Field<Owner> number(const char* path, double minimum, double maximum, Access access) {
    using Value = ValueOf<Owner, Access>;
    const FieldKind kind = std::is_integral_v<Value> ? FieldKind::WholeNumber : FieldKind::Number;
    return {QString::fromLatin1(path),
            {kind, 1, false, minimum, maximum, {}, 0, storedUnit<Value>()},
            [access](const Owner& owner) { return QJsonValue(plainNumber(access(owner))); },
            [access](Owner& owner, const QJsonValue& value) {
                access(owner) = Value(value.toDouble());
            }};
}

// A number that may be infinite; the file then holds null.
template <typename Owner = Project, typename Access>
Field<Owner> numberOrInfinity(const char* path, double minimum, double maximum, Access access) {
    using Value = ValueOf<Owner, Access>;
    return {QString::fromLatin1(path),
            {FieldKind::Number, 1, true, minimum, maximum, {}, 0, storedUnit<Value>()},
            [access](const Owner& owner) {
                const double number = plainNumber(access(owner));
                return std::isinf(number) ? QJsonValue() : QJsonValue(number);
            },
            [access](Owner& owner, const QJsonValue& value) {
                access(owner) = Value(value.isNull() ? std::numeric_limits<double>::infinity()
                                                     : value.toDouble());
            }};
}

// An optional number; the file holds null if there is none.
template <typename Owner = Project, typename Access>
Field<Owner> numberOrNone(const char* path, double minimum, double maximum, Access access) {
    using Value = typename ValueOf<Owner, Access>::value_type;
    return {QString::fromLatin1(path),
            {FieldKind::Number, 1, true, minimum, maximum, {}, 0, storedUnit<Value>()},
            [access](const Owner& owner) {
                const auto& number = access(owner);
                return number ? QJsonValue(plainNumber(*number)) : QJsonValue();
            },
            [access](Owner& owner, const QJsonValue& value) {
                access(owner).reset();
                if (!value.isNull()) {
                    access(owner) = Value(value.toDouble());
                }
            }};
}

// A field whose values have a unit that their type does not state.
template <typename Owner>
Field<Owner> inUnit(const char* unit, Field<Owner> field) {
    field.rule.unit = QString::fromUtf8(unit);
    return field;
}

template <typename Owner>
Field<Owner> omittedIfDefault(Field<Owner> field) {
    field.omittedIfDefault = true;
    return field;
}

template <typename Owner>
Field<Owner> notHashedIfDefault(Field<Owner> field) {
    field.notHashedIfDefault = true;
    return field;
}

// Turns a field of a part into a field of its owner. `access` returns the part.
template <typename Owner = Project, typename Part, typename Access>
Field<Owner> fieldOf(const QString& prefix, const Field<Part>& field, Access access) {
    return {prefix + field.path,
            field.rule,
            [get = field.get, access](const Owner& owner) { return get(access(owner)); },
            [field, prefix, access](Owner& owner, const QJsonValue& value) {
                try {
                    field.set(access(owner), value);
                } catch (const Error& error) {
                    if (error.where() != field.path) {
                        throw;
                    }
                    throw Error(error.message(), prefix + field.path);
                }
            },
            field.omittedIfDefault,
            field.notHashedIfDefault};
}

// Turns a field of a part into a field of an owner whose value is optional. `access` returns the
// optional value; `member` is the part's member.
template <typename Owner, typename Part, typename Value, typename Access>
Field<Owner> optionalFieldOf(const Field<Part>& field, Value Part::*member, Access access) {
    FieldRule rule = field.rule;
    rule.nullable = true;
    return {field.path,
            rule,
            [get = field.get, member, access](const Owner& owner) {
                Part part;
                part.*member = access(owner).value_or(part.*member);
                return access(owner) ? get(part) : QJsonValue();
            },
            [set = field.set, member, access](Owner& owner, const QJsonValue& value) {
                access(owner).reset();
                if (!value.isNull()) {
                    Part part;
                    set(part, value);
                    access(owner) = part.*member;
                }
            },
            field.omittedIfDefault,
            field.notHashedIfDefault};
}

// Several numbers of one unit. `access` takes the owner and the index of a number.
template <typename Owner = Project, typename Access>
Field<Owner> numbers(const char* path, int parts, double minimum, double maximum, Access access) {
    using Value = std::remove_cvref_t<decltype(access(std::declval<Owner&>(), 0))>;
    return {QString::fromLatin1(path),
            {FieldKind::Number, parts, false, minimum, maximum, {}, 0, storedUnit<Value>()},
            [access, parts](const Owner& owner) {
                QJsonArray array;
                for (int part = 0; part < parts; ++part) {
                    array.append(plainNumber(access(owner, part)));
                }
                return QJsonValue(array);
            },
            [access, parts](Owner& owner, const QJsonValue& value) {
                for (int part = 0; part < parts; ++part) {
                    access(owner, part) = Value(value.toArray().at(part).toDouble());
                }
            }};
}

// A text of one line: characters that would break or rewrite the displayed line become spaces.
template <typename Owner = Project, typename Access>
Field<Owner> text(const char* path, int maximumLength, Access access) {
    return {QString::fromLatin1(path),
            {FieldKind::Text, 1, false, 0, double(maximumLength)},
            [access](const Owner& owner) { return QJsonValue(access(owner)); },
            [access](Owner& owner, const QJsonValue& value) {
                access(owner) = oneLine(value.toString());
            }};
}

// An ISO date or an empty text.
template <typename Owner = Project, typename Access>
Field<Owner> dateField(const char* path, Access access) {
    constexpr int length = 10;
    Field<Owner> field = text<Owner>(path, length, access);
    field.set = [access, path](Owner& owner, const QJsonValue& value) {
        requireDate(value.toString(), QString::fromLatin1(path));
        access(owner) = value.toString();
    };
    return field;
}

// A text of any characters, line breaks included. Not for texts that are shown within a line.
template <typename Owner = Project, typename Access>
Field<Owner> textOfLines(const char* path, int maximumLength, Access access) {
    Field<Owner> field = text<Owner>(path, maximumLength, access);
    field.set = [access](Owner& owner, const QJsonValue& value) {
        access(owner) = value.toString();
    };
    return field;
}

// A file's path; it may hold any characters.
template <typename Owner = Project, typename Access>
Field<Owner> filePath(const char* path, int maximumLength, Access access) {
    return textOfLines<Owner>(path, maximumLength, access);
}

// The measured tones of inks (settings/InkTones.h).
template <typename Owner = Project, typename Access>
Field<Owner> inkTonesField(const char* path, Access access) {
    constexpr int longestTones = 20'000;
    return {QString::fromLatin1(path),
            {FieldKind::Text, 1, false, 0, longestTones},
            [access](const Owner& owner) { return QJsonValue(inkTonesText(access(owner))); },
            [access, path](Owner& owner, const QJsonValue& value) {
                access(owner) = inkTones(value.toString(), QString::fromLatin1(path));
            }};
}

template <typename Owner = Project, typename Access>
Field<Owner> flag(const char* path, Access access) {
    return {QString::fromLatin1(path),
            {FieldKind::Flag},
            [access](const Owner& owner) { return QJsonValue(access(owner)); },
            [access](Owner& owner, const QJsonValue& value) { access(owner) = value.toBool(); }};
}

// A value from a list of words, in the order of the values 0, 1, 2 …
template <typename Owner = Project, typename Access>
Field<Owner> choice(const char* path, const QStringList& words, Access access) {
    using Value = ValueOf<Owner, Access>;
    return {
        QString::fromLatin1(path),
        {FieldKind::Choice, 1, false, 0, 0, words},
        [access, words](const Owner& owner) { return QJsonValue(words.at(int(access(owner)))); },
        [access, words](Owner& owner, const QJsonValue& value) {
            access(owner) = Value(words.indexOf(value.toString()));
        }};
}

template <typename Owner = Project, typename Access>
Field<Owner> colour(const char* path, Access access) {
    return {QString::fromLatin1(path),
            {FieldKind::Colour},
            [access](const Owner& owner) { return QJsonValue(access(owner).name()); },
            [access](Owner& owner, const QJsonValue& value) {
                access(owner) = QColor(value.toString());
            }};
}

// An optional colour; the file holds null if there is none.
template <typename Owner = Project, typename Access>
Field<Owner> colourOrNone(const char* path, Access access) {
    return {QString::fromLatin1(path),
            {FieldKind::Colour, 1, true},
            [access](const Owner& owner) {
                const auto& colour = access(owner);
                return colour ? QJsonValue(colour->name()) : QJsonValue();
            },
            [access](Owner& owner, const QJsonValue& value) {
                access(owner).reset();
                if (!value.isNull()) {
                    access(owner) = QColor(value.toString());
                }
            }};
}

} // namespace dipwright
