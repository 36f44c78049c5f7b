#include "project/ProjectValues.h"

#include "base/Error.h"
#include "project/FieldJson.h"
#include "project/Schema.h"

#include <QCoreApplication>
#include <QJsonArray>

#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Project)
};

template <typename Owner>
void addValues(std::vector<ProjectValue>& values, const QString& prefix, const Owner& owner,
               const std::vector<Field<Owner>>& fields) {
    for (const Field<Owner>& field : fields) {
        values.push_back({prefix + field.path, field.rule, field.get(owner)});
    }
}

void addArtwork(std::vector<ProjectValue>& values, const Artwork& artwork) {
    addValues(values, QStringLiteral("artwork."), artwork, artworkFields());
    for (std::size_t i = 0; i < artwork.layers.size(); ++i) {
        addValues(values, QStringLiteral("artwork.layers[%1].").arg(i), artwork.layers[i],
                  artworkLayerFields());
    }
}

void addMarks(std::vector<ProjectValue>& values, const Project& project) {
    const QJsonObject json = toJson(project);
    for (const char* list : {"masks", "tolerance.marks", "share.marks"}) {
        const QString path = QString::fromLatin1(list);
        values.push_back({path, {}, valueAt(json, path, {}).toArray(), true});
    }
}

// What is known about the model, and the id of a layer's picture, have values, but setByPath() does
// not set them.
bool isFixed(const ProjectValue& value) {
    return (value.path.startsWith(QLatin1String("model.")) &&
            value.path != QLatin1String("model.tessellation_mm")) ||
           (value.path.startsWith(QLatin1String("artwork.layers[")) &&
            value.path.endsWith(QLatin1String("].picture")));
}

} // namespace

std::vector<ProjectValue> projectValues(const Project& project) {
    std::vector<ProjectValue> values;
    addValues(values, {}, project, projectFields());
    for (std::size_t i = 0; i < project.immersions.size(); ++i) {
        addValues(values, QStringLiteral("immersions[%1].").arg(i), project.immersions[i],
                  immersionFields());
    }
    addArtwork(values, project.artwork);
    addMarks(values, project);
    std::erase_if(values, isFixed);
    return values;
}

ProjectValue valueByPath(const Project& project, const QString& path) {
    const std::vector<ProjectValue> values = projectValues(project);
    const auto found = std::ranges::find(values, path, &ProjectValue::path);
    if (found == values.end()) {
        Project copy = project;
        setByPath(copy, path, {}); // says why there is no such value
        throw Error(Text::tr("There is no such value; write its path as in the project file"),
                    path);
    }
    return *found;
}

int settingOrder(const QString& path) {
    return path == QLatin1String("film.preset") ? 0 : path == QLatin1String("film.size_mm") ? 1 : 2;
}

} // namespace dipwright
