// One value of a file's schema, of a project's or a profile's, declared once: where it stands, what
// it may be, and how it is got from and set in its owner. Reading, writing, `--set` and the
// dialogs' limits all use it.
#pragma once

#include <QJsonValue>
#include <QString>
#include <QStringList>
#include <functional>
#include <utility>

namespace dipwright {

// A colour is a text such as #1a2b3c.
enum class FieldKind { Text, Choice, Flag, Number, WholeNumber, Colour };

// What a value must be. With `parts` > 1 it is an array of that many such values.
struct FieldRule {
    FieldKind kind = FieldKind::Number;
    int parts = 1;
    bool nullable = false;
    double minimum = 0; // of numbers, both ends allowed; of texts: nothing
    double maximum = 0; // of numbers; of texts: the greatest length
    QStringList choices = {};
};

// `set` is only called with values that keep the rule, and may throw Error for what depends on
// more than one value.
template <typename Owner>
struct Field {
    QString path; // "film.size_mm", from the owner's own object
    FieldRule rule;
    std::function<QJsonValue(const Owner&)> get;
    std::function<void(Owner&, const QJsonValue&)> set;
    // Files have it only where it is not what a new owner has: files that know nothing of it stay
    // as they are, and so do the jobs that are hashed of them.
    bool leftOutWhenUsual = false;
    // The job's number is made of it only where it is not what a new owner has: sheets that were
    // made before there was the field keep their number.
    bool uncountedWhenUsual = false;
};

// Sets a value that keeps the field's rule. What `set` throws passes through; the owner is then as
// it was.
template <typename Owner>
void setField(Owner& owner, const Field<Owner>& field, const QJsonValue& value) {
    Owner changed = owner;
    field.set(changed, value);
    owner = std::move(changed);
}

// Throws Error naming `path` (with the index of the offending part) and `file`, which may be empty.
void checkValue(const FieldRule& rule, const QJsonValue& value, const QString& path,
                const QString& file);

// The value written as text on a command line: parts joined by x or ;, "null", "true" and "false".
// Throws Error naming `path`; the result keeps the rule.
QJsonValue parseValue(const FieldRule& rule, const QString& text, const QString& path);

} // namespace dipwright
