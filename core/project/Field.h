// Declares one value of a project's or profile's file schema: its path, its rule, and how to get
// and set it. Reading, writing, `--set` and the dialogs' limits all use this declaration.
#pragma once

#include <QJsonValue>
#include <QString>
#include <QStringList>
#include <functional>
#include <utility>

namespace dipwright {

// A colour is a text such as #1a2b3c.
enum class FieldKind { Text, Choice, Flag, Number, WholeNumber, Colour };

// The rule that a value must satisfy. With `parts` > 1, the value is an array of `parts` values.
struct FieldRule {
    FieldKind kind = FieldKind::Number;
    int parts = 1;
    bool nullable = false;
    double minimum = 0; // for numbers; the limits themselves are allowed
    double maximum = 0; // for numbers; for texts: the greatest length
    QStringList choices = {};
    // > 0: the value is a list of at most this many values of the rule. Parts of the list's values
    // may be null if the rule is nullable.
    int mostItems = 0;
    QString unit = {}; // of the stored number, such as "mm"; empty: none
};

// `set` is called only with values that satisfy the rule. It may throw Error for conditions that
// depend on several values.
template <typename Owner>
struct Field {
    QString path; // within the owner's JSON object, such as "film.size_mm"
    FieldRule rule;
    std::function<QJsonValue(const Owner&)> get;
    std::function<void(Owner&, const QJsonValue&)> set;
    // The file omits the default value. So files from before the field existed stay the same, and
    // so do their job numbers.
    bool omittedIfDefault = false;
    // The hash that makes the job number omits the default value. So sheets from before the field
    // existed keep their job number.
    bool notHashedIfDefault = false;
};

// Sets a value that satisfies the field's rule. If `set` throws, the owner does not change.
template <typename Owner>
void setField(Owner& owner, const Field<Owner>& field, const QJsonValue& value) {
    Owner changed = owner;
    field.set(changed, value);
    owner = std::move(changed);
}

// Throws Error naming `path` (with the index of the offending part) and `file`, which may be empty.
void checkValue(const FieldRule& rule, const QJsonValue& value, const QString& path,
                const QString& file);

// Throws Error naming `path` if the text is neither empty nor an ISO date.
void requireDate(const QString& text, const QString& path);

// Parses a value from the command line: parts separated by x or ;, items of a list by /, "null",
// "true" or "false". A number may be a calculation with units (base/TypedNumber.h), with a point as
// decimal sign; in a list it has no quotients. The result satisfies the rule. Throws Error naming
// `path`.
QJsonValue parseValue(const FieldRule& rule, const QString& text, const QString& path);

} // namespace dipwright
