// Reads and writes the fields that a schema declares. Private to this folder.
#pragma once

#include "project/Field.h"

#include <QJsonObject>
#include <vector>

namespace dipwright {

// Returns the value at a dotted path; undefined if there is none. Throws Error if a value on the
// path is not an object.
QJsonValue valueAt(const QJsonObject& json, const QString& path, const QString& file);
void insertAt(QJsonObject& json, const QString& path, const QJsonValue& value);
// Removes the value, and every object on the path that becomes empty.
void removeAt(QJsonObject& json, const QString& path);

// Checks and sets the values that are in `json`; other values of the owner stay. `prefix` is the
// owner's path, for error messages.
template <typename Owner>
void readFields(Owner& owner, const std::vector<Field<Owner>>& fields, const QJsonObject& json,
                const QString& prefix, const QString& file) {
    for (const Field<Owner>& field : fields) {
        const QJsonValue value = valueAt(json, field.path, file);
        if (!value.isUndefined()) {
            checkValue(field.rule, value, prefix + field.path, file);
            field.set(owner, value);
        }
    }
}

template <typename Owner>
void writeFields(const Owner& owner, const std::vector<Field<Owner>>& fields, QJsonObject& json) {
    const Owner usual{};
    for (const Field<Owner>& field : fields) {
        const QJsonValue value = field.get(owner);
        if (!field.omittedIfDefault || value != field.get(usual)) {
            insertAt(json, field.path, value);
        }
    }
}

// Removes default values that do not count for a job number (Field::notHashedIfDefault).
template <typename Owner>
void removeUncounted(QJsonObject& json, const std::vector<Field<Owner>>& fields) {
    const Owner usual{};
    for (const Field<Owner>& field : fields) {
        if (field.notHashedIfDefault && valueAt(json, field.path, {}) == field.get(usual)) {
            removeAt(json, field.path);
        }
    }
}

template <typename Owner>
QJsonObject withoutFields(QJsonObject json, const std::vector<Field<Owner>>& fields) {
    for (const Field<Owner>& field : fields) {
        removeAt(json, field.path);
    }
    return json;
}

} // namespace dipwright
