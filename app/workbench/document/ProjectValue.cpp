#include "workbench/document/ProjectValue.h"

#include "base/Error.h"
#include "project/Schema.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace dipwright {

namespace {

struct ImmersionPath {
    std::size_t number = 0;
    QString field;
};

std::optional<ImmersionPath> immersionPath(const QString& path) {
    static const QRegularExpression pattern(QStringLiteral("^immersions\\[(\\d)\\]\\.(.+)$"));
    const auto match = pattern.match(path);
    if (!match.hasMatch()) {
        return std::nullopt;
    }
    return ImmersionPath{match.captured(1).toULong(), match.captured(2)};
}

template <typename Owner>
const Field<Owner>& fieldAt(const std::vector<Field<Owner>>& fields, const QString& path) {
    for (const Field<Owner>& field : fields) {
        if (field.path == path) {
            return field;
        }
    }
    throw Error(QCoreApplication::translate("ProjectValue", "There is no such setting"), path);
}

} // namespace

FieldRule valueRule(const QString& path) {
    if (const auto immersion = immersionPath(path)) {
        return fieldAt(immersionFields(), immersion->field).rule;
    }
    return fieldAt(projectFields(), path).rule;
}

QJsonValue valueAt(const Project& project, const QString& path) {
    if (const auto immersion = immersionPath(path)) {
        if (immersion->number >= project.immersions.size()) {
            return QJsonValue::Undefined;
        }
        return fieldAt(immersionFields(), immersion->field)
            .get(project.immersions[immersion->number]);
    }
    return fieldAt(projectFields(), path).get(project);
}

void setValueAt(Project& project, const QString& path, const QJsonValue& value) {
    checkValue(valueRule(path), value, path, {});
    Project changed = project;
    if (const auto immersion = immersionPath(path)) {
        fieldAt(immersionFields(), immersion->field)
            .set(changed.immersions.at(immersion->number), value);
    } else {
        fieldAt(projectFields(), path).set(changed, value);
    }
    project = std::move(changed);
}

} // namespace dipwright
