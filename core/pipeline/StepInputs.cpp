#include "pipeline/StepInputs.h"

namespace dipwright {

BodyInputs bodyInputs(const Project& project, std::size_t number) {
    return {project.model, project.immersions[number].rotation};
}

FieldInputs fieldInputs(const Project& project) {
    return {project.model, project.fieldResolution};
}

DipInputs dipInputs(const Project& project, std::size_t number, const QString& solver) {
    DipInputs inputs{bodyInputs(project, number),
                     fieldInputs(project),
                     project.immersions[number].offset,
                     project.film,
                     project.process,
                     solver};
    inputs.process.solver.clear();
    return inputs;
}

TextureInputs textureInputs(const Project& project, const JobOptions& options, std::size_t number,
                            const QString& solver) {
    return {dipInputs(project, number, solver),
            project.sheet.resolution,
            project.sheet.bleed,
            project.ink,
            options.chessboard,
            options.filmImage};
}

SheetInputs sheetInputs(const Project& project, const JobOptions& options, std::size_t number,
                        const QString& solver) {
    return {textureInputs(project, options, number, solver),
            project.name,
            project.date,
            project.immersions[number].name,
            project.sheet,
            project.profiles,
            project.unknown};
}

} // namespace dipwright
