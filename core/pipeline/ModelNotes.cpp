#include "pipeline/ModelNotes.h"

#include "base/NumberText.h"
#include "geometry/FieldGrid.h"
#include "model/MeshRepair.h"
#include "model/NamedMaterials.h"
#include "project/Project.h"

#include <QCoreApplication>

#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

} // namespace

QString thinPartNote(const Project& project, const TriangleMesh& mesh, const SurfaceQuery& query) {
    const double thinnest = thinnestPart(mesh, query);
    const FieldGrid field = fieldGrid(project.model->mesh, project.fieldResolution, thinnest);
    if (!isFineEnough(field, thinnest)) {
        return Text::tr("Some places of the model are only %1 mm thick. The film may miss them, "
                        "because the smallest possible cells of the distance field are %2 mm. Make "
                        "these places thicker, or dip a smaller section of the model.")
            .arg(roundedText(thinnest, 2))
            .arg(roundedText(field.spacing, 2));
    }
    const MissedParts missed = missedParts(mesh, query, field.spacing);
    if (missed.area == 0) {
        return {};
    }
    return Text::tr("Fins or pins of the model, %1 mm² in all, are at most %2 mm thick. The film "
                    "may miss them, because the cells of the distance field are %3 mm. Increase "
                    "the resolution of the distance field, or make these places thicker.")
        .arg(std::round(missed.area))
        .arg(roundedText(missed.thickness, 2))
        .arg(roundedText(field.spacing, 2));
}

QStringList missingMaterialNotes(const Project& project) {
    QStringList used;
    const auto note = [&](const auto& users) {
        for (const auto& user : users) {
            if (!user.material.isEmpty() && !used.contains(user.material)) {
                used.append(user.material);
            }
        }
    };
    note(project.tolerance.marks);
    note(project.masks);
    note(project.artwork.layers);
    QStringList notes;
    for (const QString& name : used) {
        if (materialsNamed(*project.model, name).empty()) {
            notes.append(Text::tr("A zone, mask or layer names the face or material “%1”, which "
                                  "the model does not have; choose another name")
                             .arg(name));
        }
    }
    return notes;
}

bool isInsideOut(const TexturedMesh& model) {
    TexturedMesh turned = model;
    return flipInsideOutParts(turned, [] {}) > 0;
}

QString insideOutNote() {
    return Text::tr(
        "The model is inside out, at least in some places. Film does not adhere to faces that "
        "point inwards. Import the model again; the import turns these faces outwards.");
}

} // namespace dipwright
