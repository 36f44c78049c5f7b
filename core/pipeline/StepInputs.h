// Holds the inputs of each step of the job as one value. A step is computed again only if this
// value has changed: runJob() takes over results with equal inputs, and the workbench marks results
// with other inputs as out of date.
//
// The inputs of a step include the inputs of the steps before it. Equal inputs mean equal results.
#pragma once

#include "pipeline/JobOptions.h"
#include "settings/Artwork.h"
#include "settings/AsBuilt.h"
#include "settings/DipPath.h"
#include "settings/FilmSettings.h"
#include "settings/InkSettings.h"
#include "settings/MaskSettings.h"
#include "settings/ProcessSettings.h"
#include "settings/Profile.h"
#include "settings/ShareSettings.h"
#include "settings/SheetSettings.h"
#include "settings/ToleranceSettings.h"
#include "settings/VerdictSettings.h"

#include <QImage>
#include <QJsonObject>
#include <QString>
#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace dipwright {

struct Project;
struct TexturedMesh;

// Inputs of the body in its pose. Models are equal only if they are the same object; versions of a
// project share that object.
struct BodyInputs {
    std::shared_ptr<const TexturedMesh> model;
    std::array<Degrees, 3> rotation{};
    DipPath path = {};
    // Depth and speed, if the part follows a path.
    std::optional<ProcessSettings> process;
    bool operator==(const BodyInputs&) const = default;
};

// Inputs of the body's distance field.
struct FieldInputs {
    std::shared_ptr<const TexturedMesh> model;
    int resolution = 0;
    bool operator==(const FieldInputs&) const = default;
};

// Inputs of the body's appearance. No dip depends on the appearance, so moving a layer does not
// repeat a dip.
struct PaintInputs {
    std::shared_ptr<const TexturedMesh> model;
    Artwork artwork;
    DotsPerInch resolution{0}; // resolution of the sheet; 0 without artwork
    bool operator==(const PaintInputs&) const = default;
};

// What decides how far a film is refined: the limits of the numerical error, and the surface that
// is not judged.
struct RefinementInputs {
    std::array<Millimetres, zoneCount> limits;
    std::vector<ZoneMark> marks;
    std::vector<MaskMark> masks;
    bool operator==(const RefinementInputs&) const = default;
};

// Inputs of the laid film and its measurements.
struct DipInputs {
    BodyInputs body;
    FieldInputs field;
    std::array<Millimetres, 2> offset{};
    FilmSettings film;
    // Its `solver` is empty, because the project may say "auto"; the chosen solver is below.
    ProcessSettings process;
    QString solver;                             // the id of the chosen solver
    std::optional<RefinementInputs> refinement; // none: the film is not refined
    bool operator==(const DipInputs&) const = default;
};

// Whether dips with these inputs begin with the same film. They may be refined differently.
bool beginAlike(DipInputs first, const DipInputs& second);

// Inputs of the split of the body between two dips.
struct ShareInputs {
    std::vector<DipInputs> dips;
    PaintInputs paint; // decides where the seam shows least
    ShareSettings settings;
    InkSettings ink;
    bool operator==(const ShareInputs&) const = default;
};

// Inputs of the picture on the film.
struct TextureInputs {
    DipInputs dip;
    PaintInputs paint;
    std::optional<ShareInputs> share; // none: the dip paints every place that it reaches
    DotsPerInch resolution{0};
    Millimetres bleed{0};
    InkSettings ink;
    double white = 0; // tint of the white layer; 0: none
    std::vector<MaskMark> masks;
    bool chessboard = false;
    QImage filmImage, filmInks;
    bool isReversed() const { return !chessboard && filmImage.isNull(); }
    // Tells whether each ink is compensated separately when printed. The result then also keeps the
    // wanted colours and the film's stretch.
    bool isPerInk() const { return isReversed() && (ink.isPerInk() || hasInks()); }
    // Tells whether the body has amounts of ink (base/InkPicture.h), which are printed as they are.
    // Artwork on the model hides them.
    bool hasInks() const;
    // Returns the settings by which the ink was compensated; the ink of a given picture is not
    // compensated.
    InkSettings printedInk() const;
    bool operator==(const TextureInputs&) const = default;
};

// What a verdict measures the results against.
struct VerdictInputs {
    VerdictSettings settings;
    std::array<Millimetres, zoneCount> limits;
    std::vector<ZoneMark> marks;
    bool operator==(const VerdictInputs&) const = default;
};

// Inputs of the verdict and of the sheet with its job line, whose job number counts them all.
struct SheetInputs {
    TextureInputs texture;
    QString project, date, immersion; // names
    SheetSettings settings;
    QString baseColour; // colour of the body; shown in the proof
    ProjectProfiles profiles;
    QJsonObject unknown; // unknown keys of the project file, which are part of the job's hash
    // The measured parts that were dipped like this dip. None: the sheet is not corrected.
    std::optional<AsBuilt> correction;
    BuiltPartCounts built; // the parts that the project wants to correct by; none if it does not
    VerdictInputs verdict;
    bool operator==(const SheetInputs&) const = default;
};

// Return the inputs of the steps of immersion `number`. `solver` is the id of the chosen solver
// (SolverChoice.h).
BodyInputs bodyInputs(const Project& project, std::size_t number);
FieldInputs fieldInputs(const Project& project);
PaintInputs paintInputs(const Project& project);
DipInputs dipInputs(const Project& project, std::size_t number, const QString& solver);
// None if every dip paints every place that it reaches, or if a picture replaces the texture.
std::optional<ShareInputs> shareInputs(const Project& project, const JobOptions& options,
                                       const QString& solver);
TextureInputs textureInputs(const Project& project, const JobOptions& options, std::size_t number,
                            const QString& solver);
// Tells whether the dips of `project` share the body.
bool isShared(const Project& project);
// A sheet with a chessboard or a given picture is never corrected, because it may be used for
// measuring.
SheetInputs sheetInputs(const Project& project, const JobOptions& options, std::size_t number,
                        const QString& solver);

} // namespace dipwright
