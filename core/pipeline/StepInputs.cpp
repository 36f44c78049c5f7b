#include "pipeline/StepInputs.h"

#include "accuracy/correction/SheetCorrection.h"
#include "dip/FilmUnderBody.h"
#include "pipeline/JobOptions.h"
#include "project/DipKeys.h"
#include "project/Project.h"
#include "texture/InkAppearance.h"

#include <utility>

namespace dipwright {

InkSettings TextureInputs::printedInk() const {
    InkSettings printed = ink;
    printed.compensate = ink.compensate && isReversed();
    return printed;
}

BodyInputs bodyInputs(const Project& project, std::size_t number) {
    const Immersion& immersion = project.immersions[number];
    BodyInputs inputs{project.model, immersion.rotation, {}, std::nullopt};
    if (!immersion.path.isStraightDown()) {
        inputs.path = immersion.path;
        inputs.process = project.process;
        inputs.process->solver.clear();
    }
    return inputs;
}

FieldInputs fieldInputs(const Project& project) {
    return {project.model, project.fieldResolution};
}

PaintInputs paintInputs(const Project& project) {
    return {project.model, project.artwork,
            project.artwork.isEmpty() ? DotsPerInch(0) : project.sheet.resolution};
}

DipInputs dipInputs(const Project& project, std::size_t number, const QString& solver) {
    DipInputs inputs{bodyInputs(project, number),
                     fieldInputs(project),
                     project.immersions[number].offset,
                     project.film,
                     project.process,
                     solver,
                     {}};
    inputs.process.solver.clear();
    const bool isDraft = project.film.refinement < 1;
    if (isRefinable(project.film) && !isDraft) {
        inputs.refinement = {project.tolerance.limits, project.tolerance.marks, project.masks};
    }
    return inputs;
}

bool beginAlike(DipInputs first, const DipInputs& second) {
    first.refinement = second.refinement;
    first.film.work = second.film.work;
    first.film.wantedError = second.film.wantedError;
    return first == second;
}

bool TextureInputs::hasInks() const {
    return paint.model && !inkSpaceOf(*paint.model).isEmpty() &&
           paint.artwork.inColours().isEmpty();
}

bool isShared(const Project& project) {
    return project.immersions.size() == 2 && project.share.enabled;
}

std::optional<ShareInputs> shareInputs(const Project& project, const JobOptions& options,
                                       const QString& solver) {
    if (!isShared(project) || !options.printsTexture()) {
        return std::nullopt;
    }
    return ShareInputs{{dipInputs(project, 0, solver), dipInputs(project, 1, solver)},
                       paintInputs(project),
                       project.share,
                       project.ink};
}

TextureInputs textureInputs(const Project& project, const JobOptions& options, std::size_t number,
                            const QString& solver) {
    return {dipInputs(project, number, solver),
            paintInputs(project),
            shareInputs(project, options, solver),
            project.sheet.resolution,
            project.sheet.bleed,
            project.ink,
            project.sheet.white == WhiteLayer::None ? 0 : project.sheet.whiteDensity,
            project.masks,
            options.chessboard,
            options.filmImage,
            options.filmInks};
}

SheetInputs sheetInputs(const Project& project, const JobOptions& options, std::size_t number,
                        const QString& solver) {
    SheetInputs inputs{textureInputs(project, options, number, solver),
                       project.name,
                       project.date,
                       project.immersions[number].name,
                       project.sheet,
                       project.baseColour,
                       withoutCosts(project.profiles),
                       project.unknown,
                       std::nullopt,
                       {},
                       {project.verdict, project.tolerance.limits, project.tolerance.marks}};
    const int dip = int(number) + 1;
    if (options.printsTexture() && isCorrected(project.asBuilt, dip)) {
        const QStringList keys = dipKeys(project);
        inputs.built = countParts(project.asBuilt, dip, keys);
        AsBuilt alike = dippedAlike(project.asBuilt, keys);
        if (isCorrected(alike, dip)) {
            alike.times.clear();
            inputs.correction = std::move(alike);
        }
    }
    return inputs;
}

} // namespace dipwright
