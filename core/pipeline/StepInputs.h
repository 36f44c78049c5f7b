// What each step of the job depends on, one value a step. Whether a step has to be done anew, or a
// result still fits a project, is decided by comparing these and by nothing else: runJob() takes
// over what has the same inputs, the workbench marks as out of date what has others.
//
// A step's inputs hold those of the steps before it, so that equal inputs mean equal results.
#pragma once

#include "pipeline/JobOptions.h"
#include "settings/Artwork.h"
#include "settings/AsBuilt.h"
#include "settings/FilmSettings.h"
#include "settings/InkSettings.h"
#include "settings/ProcessSettings.h"
#include "settings/Profile.h"
#include "settings/ShareSettings.h"
#include "settings/SheetSettings.h"

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

// The body in its pose. Models are equal when they are one object: versions of a project share it.
struct BodyInputs {
    std::shared_ptr<const TexturedMesh> model;
    std::array<Degrees, 3> rotation{};
    bool operator==(const BodyInputs&) const = default;
};

// The body's distance field.
struct FieldInputs {
    std::shared_ptr<const TexturedMesh> model;
    int resolution = 0;
    bool operator==(const FieldInputs&) const = default;
};

// What the body is to look like. Films are dipped without it: a layer that is moved takes no dip.
struct PaintInputs {
    std::shared_ptr<const TexturedMesh> model;
    Artwork artwork;
    DotsPerInch resolution{0}; // of the sheet; 0 without artwork, which nothing then depends on
    bool operator==(const PaintInputs&) const = default;
};

// The film on the body, and what is measured of it there.
struct DipInputs {
    BodyInputs body;
    FieldInputs field;
    std::array<Millimetres, 2> offset{};
    FilmSettings film;
    ProcessSettings process; // its `solver` empty: that may be "auto"
    QString solver;          // the id of the solver that was chosen
    bool operator==(const DipInputs&) const = default;
};

// How the body is shared out between two dips.
struct ShareInputs {
    std::vector<DipInputs> dips;
    PaintInputs paint; // where the join shows least
    ShareSettings settings;
    InkSettings ink;
    bool operator==(const ShareInputs&) const = default;
};

// The picture of the whole film.
struct TextureInputs {
    DipInputs dip;
    PaintInputs paint;
    std::optional<ShareInputs> share; // none: it paints all that it reaches
    DotsPerInch resolution{0};
    Millimetres bleed{0};
    InkSettings ink;
    double white = 0; // tint of the white layer; 0: none
    bool chessboard = false;
    QImage filmImage;
    bool isReversed() const { return !chessboard && filmImage.isNull(); }
    // Whether printers of inks compensate each by itself, for which more of the film is kept.
    bool isPerInk() const { return isReversed() && ink.isPerInk(); }
    // Whether and how the picture's ink was compensated: a given picture's was not.
    InkSettings printedInk() const;
    bool operator==(const TextureInputs&) const = default;
};

// The sheet to print, with its job line.
struct SheetInputs {
    TextureInputs texture;
    QString project, date, immersion; // names
    SheetSettings settings;
    QString baseColour; // of the body, which the proof shows
    ProjectProfiles profiles;
    QJsonObject unknown;               // keys of the project's file; the job's hash is of them too
    std::optional<AsBuilt> correction; // none: it is printed as the film was made
    bool operator==(const SheetInputs&) const = default;
};

// What immersion `number` of `project` needs. `solver`: the id of the one that is chosen, see
// SolverChoice.h.
BodyInputs bodyInputs(const Project& project, std::size_t number);
FieldInputs fieldInputs(const Project& project);
PaintInputs paintInputs(const Project& project);
DipInputs dipInputs(const Project& project, std::size_t number, const QString& solver);
// Nothing where every dip paints all that it reaches, or a picture in place of the texture.
std::optional<ShareInputs> shareInputs(const Project& project, const JobOptions& options,
                                       const QString& solver);
TextureInputs textureInputs(const Project& project, const JobOptions& options, std::size_t number,
                            const QString& solver);
// Whether the immersions of `project` share the body out between them.
bool isShared(const Project& project);
// Whether what repeats in the parts before it is taken off the sheet: never off a chessboard or a
// picture of the user's, by which one may measure.
bool isSheetCorrected(const Project& project, const JobOptions& options, std::size_t number);
SheetInputs sheetInputs(const Project& project, const JobOptions& options, std::size_t number,
                        const QString& solver);

} // namespace dipwright
