#include "project/Field.h"

#include "base/Error.h"
#include "base/TypedNumber.h"

#include <QCoreApplication>
#include <QDate>
#include <QJsonArray>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Project)
};

QString place(const QString& path, const QString& file) {
    return file.isEmpty() ? path : QStringLiteral("%1: %2").arg(file, path);
}

QString plain(double number) {
    return QString::number(number, 'g', 10);
}

QString expectation(const FieldRule& rule) {
    switch (rule.kind) {
    case FieldKind::Text:
        return Text::tr("a text of at most %1 characters").arg(plain(rule.maximum));
    case FieldKind::Choice:
        return Text::tr("one of %1").arg(rule.choices.join(QStringLiteral(", ")));
    case FieldKind::Flag:
        return Text::tr("true or false");
    case FieldKind::Colour:
        return Text::tr("a colour such as #1a2b3c");
    case FieldKind::Number:
        return Text::tr("a number from %1 to %2").arg(plain(rule.minimum), plain(rule.maximum)) +
               (rule.unit.isEmpty() ? QString() : u' ' + rule.unit);
    case FieldKind::WholeNumber:
        return Text::tr("a whole number from %1 to %2")
            .arg(plain(rule.minimum), plain(rule.maximum));
    }
    return {};
}

bool isColour(const QString& text) {
    static const QRegularExpression digits(QStringLiteral("^#[0-9a-fA-F]{6}\\z"));
    return digits.match(text).hasMatch();
}

bool keepsRule(const FieldRule& rule, const QJsonValue& value) {
    const double number = value.toDouble(std::nan(""));
    switch (rule.kind) {
    case FieldKind::Text:
        return value.isString() && value.toString().size() <= rule.maximum;
    case FieldKind::Choice:
        return value.isString() && rule.choices.contains(value.toString());
    case FieldKind::Flag:
        return value.isBool();
    case FieldKind::Colour:
        return value.isString() && isColour(value.toString());
    case FieldKind::Number:
        return number >= rule.minimum && number <= rule.maximum;
    case FieldKind::WholeNumber:
        return number >= rule.minimum && number <= rule.maximum && number == std::floor(number);
    }
    return false;
}

QString shown(const QJsonValue& value) {
    switch (value.type()) {
    case QJsonValue::Null:
        return QStringLiteral("null");
    case QJsonValue::Bool:
        return value.toBool() ? QStringLiteral("true") : QStringLiteral("false");
    case QJsonValue::Double:
        return plain(value.toDouble());
    case QJsonValue::String:
        return value.toString().isEmpty() ? Text::tr("An empty value")
                                          : QStringLiteral("“%1”").arg(value.toString().left(60));
    case QJsonValue::Array:
        return Text::tr("an array");
    case QJsonValue::Object:
        return Text::tr("an object");
    case QJsonValue::Undefined: // checkPart() reports it
        break;
    }
    return {};
}

// Shows the parts of a short array.
QString shownParts(const QJsonValue& value) {
    constexpr int most = 4;
    const QJsonArray array = value.toArray();
    QStringList parts;
    for (int i = 0; array.size() <= most && i < array.size(); ++i) {
        parts.append(shown(array.at(i)));
    }
    return parts.isEmpty() ? shown(value) : parts.join(QStringLiteral(", "));
}

void checkPart(const FieldRule& rule, const QJsonValue& value, const QString& path,
               const QString& file) {
    if (rule.mostItems > 0 && rule.nullable && value.isNull()) {
        return;
    }
    if (value.isUndefined()) {
        throw Error(Text::tr("A value is missing; expected %1").arg(expectation(rule)),
                    place(path, file));
    }
    if (!keepsRule(rule, value)) {
        throw Error(
            Text::tr("%1 is not allowed here; expected %2").arg(shown(value), expectation(rule)),
            place(path, file));
    }
}

// Returns the text itself if it is not a calculation, and so keeps no rule for numbers. A comma is
// none either: it could be a decimal sign or separate digit groups.
QJsonValue parseCalculation(const FieldRule& rule, const QString& text) {
    constexpr double rounding = 1e-9; // of units
    const TypedNumber typed = typedNumber(text, rule.unit, QLocale::c());
    if (typed.values.size() != 1 || text.contains(u',')) {
        return text;
    }
    const double number = typed.values.front();
    const double limited = std::clamp(number, rule.minimum, rule.maximum);
    return std::abs(number - limited) <= rounding * std::abs(limited) ? limited : number;
}

QJsonValue parsePart(const FieldRule& rule, const QString& text) {
    if (rule.kind == FieldKind::Flag) {
        if (text == QLatin1String("true") || text == QLatin1String("false")) {
            return text == QLatin1String("true");
        }
        return text;
    }
    if (rule.mostItems > 0 && rule.nullable && text == QLatin1String("null")) {
        return {};
    }
    if (rule.kind == FieldKind::Number || rule.kind == FieldKind::WholeNumber) {
        bool isPlain = false;
        const double plain = text.toDouble(&isPlain);
        return isPlain ? QJsonValue(plain) : parseCalculation(rule, text);
    }
    return text;
}

void checkItem(const FieldRule& rule, const QJsonValue& value, const QString& path,
               const QString& file) {
    if (rule.parts == 1) {
        checkPart(rule, value, path, file);
        return;
    }
    if (!value.isArray() || value.toArray().size() != rule.parts) {
        throw Error(Text::tr("%1 is not allowed here; expected %2 values, each of them %3")
                        .arg(shownParts(value), QString::number(rule.parts), expectation(rule)),
                    place(path, file));
    }
    for (int part = 0; part < rule.parts; ++part) {
        checkPart(rule, value.toArray().at(part), QStringLiteral("%1[%2]").arg(path).arg(part),
                  file);
    }
}

QJsonValue parseItem(const FieldRule& rule, const QString& text) {
    if (rule.parts == 1) {
        return parsePart(rule, text);
    }
    static const QRegularExpression separator(QStringLiteral("[x;]"));
    QJsonArray parts;
    for (const QString& part : text.split(separator)) {
        parts.append(parsePart(rule, part.trimmed()));
    }
    // A message shows other texts as they were written.
    return parts.size() == rule.parts && !parts.contains(QString()) ? QJsonValue(parts) : text;
}

QJsonValue parseList(const FieldRule& rule, const QString& text) {
    QJsonArray items;
    for (const QString& item : text.split(QLatin1Char('/'), Qt::SkipEmptyParts)) {
        items.append(parseItem(rule, item.trimmed()));
    }
    return items;
}

} // namespace

void checkValue(const FieldRule& rule, const QJsonValue& value, const QString& path,
                const QString& file) {
    if (rule.mostItems == 0) {
        if (!rule.nullable || !value.isNull()) {
            checkItem(rule, value, path, file);
        }
        return;
    }
    const QJsonArray items = value.toArray();
    if (!value.isArray() || items.size() > rule.mostItems) {
        throw Error(Text::tr("%1 is not allowed here; expected a list of at most %2 entries")
                        .arg(shown(value), QString::number(rule.mostItems)),
                    place(path, file));
    }
    for (int item = 0; item < items.size(); ++item) {
        checkItem(rule, items.at(item), QStringLiteral("%1[%2]").arg(path).arg(item), file);
    }
}

void requireDate(const QString& text, const QString& path) {
    if (!text.isEmpty() && !QDate::fromString(text, Qt::ISODate).isValid()) {
        throw Error(Text::tr("%1 is not a date; write year, month and day, for example 2027-03-31")
                        .arg(text),
                    path);
    }
}

QJsonValue parseValue(const FieldRule& rule, const QString& text, const QString& path) {
    if (rule.mostItems == 0 && rule.nullable && text == QLatin1String("null")) {
        return {};
    }
    const QJsonValue value = rule.mostItems > 0 ? parseList(rule, text) : parseItem(rule, text);
    checkValue(rule, value, path, {});
    return value;
}

} // namespace dipwright
