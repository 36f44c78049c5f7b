#include "pipeline/ModelNotes.h"

#include "artwork/EditArtwork.h"
#include "base/NumberText.h"
#include "geometry/FieldGrid.h"
#include "model/MeshRepair.h"
#include "model/NamedMaterials.h"
#include "project/Project.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

constexpr double farOffPart = 1; // mm; marks are drawn on the surface

// Tells whether a mark lies farther from the part than its radius and farOffPart, at least in
// places.
class OffPart {
public:
    // Keeps references.
    OffPart(const SurfaceQuery& query, const Eigen::Isometry3d& modelToPose)
        : query_(query), modelToPose_(modelToPose) {}

    bool operator()(const SurfaceMark& mark) const {
        if (mark.extent == MarkExtent::Stroke) {
            return mark.path.empty() || isOff(mark.path, mark.radius);
        }
        const bool isNamed = mark.extent == MarkExtent::Material && !mark.material.isEmpty();
        return !isNamed &&
               isOff(mark.place, mark.extent == MarkExtent::Spot ? mark.radius : Millimetres(0));
    }
    bool operator()(const ShareMark& mark) const {
        return mark.path.empty() ? isOff(mark.place, mark.radius) : isOff(mark.path, mark.radius);
    }

private:
    bool isOff(const std::array<Millimetres, 3>& place, Millimetres radius) const {
        const Eigen::Vector3d inModel(place[0].value(), place[1].value(), place[2].value());
        return !query_.isNear((modelToPose_ * inModel).cast<float>(),
                              float(std::max(radius.value(), farOffPart)));
    }
    bool isOff(const BrushPath& path, Millimetres radius) const {
        return std::any_of(path.begin(), path.end(),
                           [&](const BrushPoint& point) { return isOff(point.place, radius); });
    }

    const SurfaceQuery& query_;
    const Eigen::Isometry3d& modelToPose_;
};

} // namespace

QString thinPartNote(const Project& project, const TriangleMesh& mesh, const SurfaceQuery& query) {
    const ThinParts thin = thinParts(mesh, query);
    const FieldGrid field = fieldGrid(project.model->mesh, project.fieldResolution, thin.thickness);
    if (!isFineEnough(field, thin.plate)) {
        return Text::tr("Some places of the model are only %1 mm thick. The film may miss them, "
                        "because the smallest possible cells of the distance field are %2 mm. Make "
                        "these places thicker, or dip a smaller section of the model.")
            .arg(roundedText(thin.plate, 2))
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

QStringList misplacedNotes(const Project& project, const SurfaceQuery& query,
                           const Eigen::Isometry3d& modelToPose) {
    const OffPart offPart(query, modelToPose);
    const auto count = [&](const auto& marks) {
        return std::count_if(marks.begin(), marks.end(), offPart);
    };
    QStringList notes = cutOffWarnings(project.artwork, project.model->mesh);
    const auto note = [&notes](qsizetype off, const QString& sentence) {
        if (off > 0) {
            notes.append(sentence.arg(off));
        }
    };
    note(count(project.masks),
         Text::tr("Masks that lie off the part: %1. Perhaps they were made for "
                  "another model; draw them again"));
    note(count(project.tolerance.marks),
         Text::tr("Zones that lie off the part: %1. Perhaps they were made for "
                  "another model; mark them again"));
    note(count(project.share.marks),
         Text::tr("Marks for the seam that lie off the part: %1. Perhaps they were "
                  "made for another model; mark the seam again"));
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
