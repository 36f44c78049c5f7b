#include "pipeline/ValidateJob.h"

#include "accuracy/correction/SheetCorrection.h"
#include "accuracy/verdict/Verdict.h"
#include "artwork/EditArtwork.h"
#include "base/Error.h"
#include "dip/FilmFit.h"
#include "dip/FilmUnderBody.h"
#include "dip/TankFit.h"
#include "film/FilmGrid.h"
#include "geometry/Solid.h"
#include "model/TextureNotes.h"
#include "pipeline/JobSheet.h"
#include "pipeline/ModelNotes.h"
#include "pipeline/SheetMemory.h"
#include "pipeline/SolverChoice.h"
#include "project/DipKeys.h"
#include "project/Profiles.h"
#include "project/Project.h"
#include "settings/Profile.h"

#include <QCoreApplication>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

constexpr double cellsAcrossBody = 10; // fewer cells resolve the body's shape poorly

// The body in its pose frame, and its path there.
struct PosedShape {
    TriangleMesh mesh;
    solver::BodyPath path;
};

// Throws the errors of requirePath().
PosedShape posedShape(const Project& project, const Immersion& immersion) {
    if (!immersion.path.isStraightDown() &&
        !solver::isProductionFilm(project.film.lattice, project.film.support)) {
        throw Error(Text::tr("The film model of the paper allows only straight dips; choose the "
                             "production film, or a straight path"),
                    immersion.name);
    }
    const TriangleMesh& mesh = project.model->mesh;
    PosedShape shape{transformed(mesh, poseTransform(mesh, immersion)), {}};
    shape.path = bodyPath(shape.mesh, immersion, project.process);
    return shape;
}

// Returns the body's extent on the water in this immersion, as a box in x and z. On a path, the box
// contains the body at all times.
Eigen::AlignedBox2d footprint(const PosedShape& shape, const Immersion& immersion) {
    const Eigen::Vector2d offset(immersion.offset[0].value(), immersion.offset[1].value());
    if (!shape.path.isStraightDown()) {
        return shadowOnPath(shape.path, shape.mesh, ShadowOf::Whole).translated(offset);
    }
    const BoundingBox box = boundingBox(shape.mesh);
    return {Eigen::Vector2d(box.min().x(), box.min().z()) + offset,
            Eigen::Vector2d(box.max().x(), box.max().z()) + offset};
}

Eigen::AlignedBox2d centred(double width, double depth) {
    const Eigen::Vector2d half(width / 2, depth / 2);
    return {-half, half};
}

// Returns the outline of the floating film.
Eigen::AlignedBox2d filmOutline(const FilmSettings& settings) {
    const solver::FilmGrid film = filmGrid(settings);
    return centred(film.width, film.depth);
}

QString beside() {
    return Text::tr("The part does not meet the film; move it over the film or choose a larger "
                    "film");
}

// Returns the sentences of misplacement() for a body in its pose.
QString misplacementOf(const PosedShape& shape, const Project& project,
                       const Immersion& immersion) {
    const Eigen::AlignedBox2d body = footprint(shape, immersion);
    const Eigen::AlignedBox2d film = filmOutline(project.film);
    if (!film.intersects(body)) {
        return beside();
    }
    std::vector<TankFault> faults = tankFaults(project.profiles.tank, project.film, project.process,
                                               immersion, shape.mesh, shape.path);
    if (!film.contains(body)) {
        faults.insert(
            faults.begin(),
            {Text::tr("The part reaches past the film's edge; move or turn the part, or %1")
                 .arg(adviceOnFilm(body, project.film))});
    }
    return textOf(faults);
}

// `query` belongs to the project's mesh.
void checkImmersion(const Project& project, const Immersion& immersion, const SurfaceQuery& query,
                    QStringList& warnings) {
    const PosedShape shape = posedShape(project, immersion);
    const Underside underside = undersideOf(project.model->mesh, query, immersion, project.process);
    const Eigen::AlignedBox2d body = footprint(shape, immersion);
    if (!filmOutline(project.film).intersects(body)) {
        throw Error(beside(), immersion.name);
    }
    const Eigen::Vector2d offset(immersion.offset[0].value(), immersion.offset[1].value());
    requireFilmBeyondBody(underside.shadow.translated(offset), project.film, immersion);
    const solver::FilmGrid grid = filmUnderBody(project.film, underside, immersion.offset);
    if (const QString wrong = misplacementOf(shape, project, immersion); !wrong.isEmpty()) {
        warnings.append(Text::tr("%1: %2").arg(immersion.name, wrong));
    }
    if (const auto rises = riseReason(shape.path, shape.mesh)) {
        warnings.append(Text::tr("%1: %2").arg(immersion.name, reasonText(*rises, millimetres)));
    }
    if (body.sizes().maxCoeff() < grid.leastSpacingX()) {
        throw Error(
            Text::tr("The part is smaller than the film's cells; give the film smaller cells "
                     "or more points, or check the model's unit"),
            immersion.name);
    }
    if (body.sizes().minCoeff() < cellsAcrossBody * grid.leastSpacingX()) {
        warnings.append(Text::tr("%1: the film's cells are too coarse for this part; give the "
                                 "film smaller cells or more points")
                            .arg(immersion.name));
    }
}

} // namespace

QStringList validateJob(const Project& project, const SolverRegistry& registry) {
    if (!project.model) {
        throw Error(Text::tr("The project has no model; import one first"), project.name);
    }
    sheetPixels(project.film.width, project.film.height, project.sheet.resolution);
    pageSize(Sheet{{}, project.film.width, project.film.height, project.sheet, {}});
    checkSpots(project);
    checkMemory(project, Printed::Texture);
    const AsBuilt built = partsDippedAlike(project);
    if (isCorrected(built, 1) || isCorrected(built, 2)) {
        requirePossibleErrors(built, project.film.width, project.film.height, project.name);
    }
    QStringList warnings;
    if (const QString note = memoryNote(project, Printed::Texture); !note.isEmpty()) {
        warnings.append(note);
    }
    warnings += chooseSolver(project.process.solver, registry).notes;
    const SurfaceQuery query(project.model->mesh);
    if (const QString notes = project.modelOrigin.notes(); !notes.isEmpty()) {
        warnings.append(Text::tr("Import of the model: %1").arg(notes));
    }
    if (const QString note = thinPartNote(project, project.model->mesh, query); !note.isEmpty()) {
        warnings.append(note);
    }
    if (isInsideOut(*project.model)) {
        warnings.append(insideOutNote());
    }
    if (!boundsSolid(project.model->mesh)) {
        warnings.append(Text::tr("The model is not closed; Dipwright guesses what is inside"));
    }
    if (project.model->textures.empty() && project.artwork.isEmpty()) {
        warnings.append(
            Text::tr("The model has no texture; the colours of its materials are printed"));
    }
    warnings += missingMaterialNotes(project);
    warnings += misplacedNotes(project, query);
    warnings += fontWarnings(project.artwork);
    warnings += colourNotes(*project.model) + layerNotes(project.artwork);
    for (const Immersion& immersion : project.immersions) {
        checkImmersion(project, immersion, query, warnings);
    }
    if (const QString expiry = expiryWarning(project.profiles.film); !expiry.isEmpty()) {
        warnings.append(expiry);
    }
    return warnings;
}

void requirePath(const Project& project, const Immersion& immersion) {
    posedShape(project, immersion);
}

QString misplacement(const Project& project, const Immersion& immersion) {
    try {
        return misplacementOf(posedShape(project, immersion), project, immersion);
    } catch (const Error& error) {
        return error.message();
    }
}

} // namespace dipwright
