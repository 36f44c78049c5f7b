// The document: everything a job is, as one value. docs/files-and-commands.md, "The project file",
// gives its file form.
#pragma once

#include "settings/Artwork.h"
#include "settings/AsBuilt.h"
#include "settings/CradleSettings.h"
#include "settings/FilmOnWater.h"
#include "settings/FilmSettings.h"
#include "settings/Immersion.h"
#include "settings/InkSettings.h"
#include "settings/InspectedPart.h"
#include "settings/ProcessSettings.h"
#include "settings/Profile.h"
#include "settings/SearchSettings.h"
#include "settings/ShareSettings.h"
#include "settings/SheetSettings.h"
#include "settings/ToleranceSettings.h"
#include "settings/VerdictSettings.h"

#include <QByteArray>
#include <QJsonObject>
#include <QString>
#include <map>
#include <memory>
#include <vector>

namespace dipwright {

struct TexturedMesh;

// Where the model came from.
struct ModelOrigin {
    QString source;  // the file it was imported from, for "reload from disk"
    QString texture; // the picture that replaced the model's own, or empty
    double unitMillimetres = 1;
    QString remarks;   // what was put right in it, or is missing: sentences; empty: nothing
    QByteArray sha256; // of the embedded model, hex
    bool operator==(const ModelOrigin&) const = default;
};

inline constexpr int longestProjectName = 200;

struct Project {
    QString name;
    QString date; // ISO date of creation; stands in the job line
    std::shared_ptr<const TexturedMesh>
        model; // shared between versions of the document, never null in a valid project
    ModelOrigin modelOrigin;
    Artwork artwork; // on the model; in the file only where there is any
    FilmSettings film;
    ProcessSettings process;
    int fieldResolution = 128;                      // body.sdf_resolution
    std::vector<Immersion> immersions{Immersion{}}; // one or two
    SheetSettings sheet;
    InkSettings ink;
    // Of the bare part, "#rrggbb"; empty: proofs show it light grey, and ink as it looks on white.
    QString baseColour;
    ShareSettings share; // of two immersions
    CradleSettings cradle;
    ToleranceSettings tolerance;
    VerdictSettings verdict; // in the file only what is not usual
    PoseAims poseAims;       // of its pose searches; in the file only what is not usual
    AsBuilt asBuilt;
    InspectedPart inspection;
    FilmOnWater filmOnWater;
    ProjectProfiles profiles; // that it was made with, by content
    QJsonObject unknown;      // keys this version does not know; they survive a save
    std::map<QString, QByteArray> unknownEntries; // and so do the file's other entries, by name

    bool operator==(const Project&) const = default;
};

// What a project is called that is made of this file, or written to it: as the file, as far as a
// name may be long.
QString projectName(const QString& path);

// "production" (the default) or "paper-2020"; changes film and process, throws Error on another
// name.
void applyPreset(Project& project, const QString& preset);

// Sets one value by its path in the schema ("film.points", "immersions[0].rotation_deg"), parts of
// an array joined by x or ;. Throws Error naming the path when it is unknown or out of range; the
// project is then as it was.
void setByPath(Project& project, const QString& path, const QString& value);

// What the number of a job is made of: project.json of version 1, without what sheets were made
// before there was, where it is as usual (Field::uncountedWhenUsual).
QJsonObject countedSettings(const Project& project);

// project.json and back; `fromJson` checks every value's range and throws Error by its path.
QJsonObject toJson(const Project& project);
Project fromJson(const QJsonObject& json, const QString& where);

} // namespace dipwright
