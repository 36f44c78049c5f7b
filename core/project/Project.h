// Holds everything that defines a job as one value: the document. Its file format is in
// docs/files-and-commands.md, "The project file".
#pragma once

#include "settings/Artwork.h"
#include "settings/AsBuilt.h"
#include "settings/CradleSettings.h"
#include "settings/FilmOnWater.h"
#include "settings/FilmSettings.h"
#include "settings/Immersion.h"
#include "settings/InkSettings.h"
#include "settings/InspectedPart.h"
#include "settings/MaskSettings.h"
#include "settings/ProcessSettings.h"
#include "settings/Profile.h"
#include "settings/SearchSettings.h"
#include "settings/ShareSettings.h"
#include "settings/SheetSettings.h"
#include "settings/ToleranceSettings.h"
#include "settings/UnknownKeys.h"
#include "settings/VerdictSettings.h"

#include <QByteArray>
#include <QJsonObject>
#include <QString>
#include <map>
#include <memory>
#include <vector>

namespace dipwright {

struct TexturedMesh;

// The origin of the model.
struct ModelOrigin {
    QString source;  // the imported file, for "reload from disk"
    QString texture; // the picture that replaced the model's texture, or empty
    double unitMillimetres = 1;
    QString remarks;   // sentences about repairs and oddities; empty: none
    QString losses;    // sentences on what the import left out; empty: nothing
    QByteArray sha256; // of the embedded model, hexadecimal
    // For a CAD model, the largest distance of its triangles from its surfaces; 0: no CAD model.
    Millimetres tessellation{0};
    QString fileUnit; // of a CAD model, such as "inch"
    // Returns the sentences in one line.
    QString notes() const {
        return losses + (losses.isEmpty() || remarks.isEmpty() ? QString() : QStringLiteral("; ")) +
               remarks;
    }
    bool operator==(const ModelOrigin&) const = default;
};

// The CAD file from which the model was made, so that it can be made again with other triangles.
struct CadFile {
    QString name;     // with the suffix, such as "bracket.step"; empty: no CAD model
    QByteArray bytes; // content
    bool operator==(const CadFile&) const = default;
};

inline constexpr int longestProjectName = 200;
inline constexpr int mostPartsToMake = 100'000;

struct Project {
    QString name;
    QString date; // ISO date of creation; printed in the job line
    std::shared_ptr<const TexturedMesh>
        model; // shared between versions of the document, never null in a valid project
    ModelOrigin modelOrigin;
    CadFile cad;
    Artwork artwork; // on the model; the file omits it if there is none
    FilmSettings film;
    ProcessSettings process;
    int fieldResolution = 128;                      // body.sdf_resolution
    std::vector<Immersion> immersions{Immersion{}}; // one or two
    SheetSettings sheet;
    InkSettings ink;
    // Colour of the bare part, "#rrggbb". Empty: soft proofs show the part in light grey, and the
    // ink as it looks on white.
    QString baseColour;
    ShareSettings share; // of two immersions
    CradleSettings cradle;
    ToleranceSettings tolerance;
    std::vector<MaskMark> masks; // later marks override earlier ones
    VerdictSettings verdict;     // the file omits default values
    PoseAims poseAims;           // of pose searches; the file omits default values
    AsBuilt asBuilt;
    InspectedPart inspection;
    FilmOnWater filmOnWater;
    int partsToMake = 1;      // how many parts are ordered; only the cost depends on it
    ProjectProfiles profiles; // contents of the profiles in use
    UnknownKeys unknown;      // outside the lists and profiles
    std::map<QString, QByteArray> unknownEntries; // the file's other entries by name; also kept

    bool operator==(const Project&) const = default;
};

// Returns the name of a project that is made from this file or saved to it: the file's name, cut to
// longestProjectName.
QString projectName(const QString& path);

// Sets film and process to the preset "production" (the default) or "paper-2020". Keeps
// ProcessSettings::contactTravel. Throws Error for another name.
void applyPreset(Project& project, const QString& preset);

// Sets one value by its path in the schema ("film.points", "immersions[0].rotation_deg"), parts of
// an array separated by x or ;. The lists masks, tolerance.marks and share.marks are set as a
// whole, by their text in JSON. For "model.tessellation_mm" makes the model's triangles again,
// which takes seconds. Throws Error naming the path if it is unknown or the value is out of range;
// the project then does not change.
void setByPath(Project& project, const QString& path, const QString& value);

// Returns the settings that the job number hashes: project.json with version 1, without the newer
// fields that have their default value (Field::notHashedIfDefault).
QJsonObject countedSettings(const Project& project);

// Returns the path of an immersion with all its fields, as "path" in project.json.
QJsonObject pathToJson(const Immersion& immersion);

// Converts a project to project.json.
QJsonObject toJson(const Project& project);
// Converts project.json to a project. Checks the range of every value and throws Error naming the
// value's path.
Project fromJson(const QJsonObject& json, const QString& where);

} // namespace dipwright
