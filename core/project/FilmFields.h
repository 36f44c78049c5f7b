// Declares the fields of a film's material that a project and a film profile share. All users take
// path, unit, limits and texts from here: project file, profile file, `--set`, the window, the job
// number and the check of docs/files-and-commands.md.
//
// Paths are relative to the JSON object of the group of settings. A project uses them as
// "film.swell", "ink.exponents" and "process.overhang_deg"; a profile as "swell", "ink_exponents"
// and "overhang_deg".
#pragma once

#include "base/Units.h"
#include "project/Field.h"
#include "settings/FilmSettings.h"
#include "settings/InkSettings.h"
#include "settings/ProcessSettings.h"

#include <QMap>
#include <vector>

namespace dipwright {

// The texts of a field for the user, in the program's language.
struct FieldWords {
    QString label;
    QString help; // one or two sentences: what it is and what it does
    Unit unit = Unit::None;
    QStringList parts = {};            // short names of several numbers: "X", "Y"
    QMap<QString, QString> words = {}; // the choices
    QString absent = {};               // shown for an optional value that is not set: "Elastic"
    double whenPresent = 1;            // initial value when the user switches an optional value on
    bool linked = false;               // the parts are usually equal
    bool isOfProductionFilm = false;   // does not apply to the paper's film
};

template <typename Part>
struct MaterialField {
    Field<Part> field;
    FieldWords words;
};

std::vector<MaterialField<FilmBehaviour>> filmBehaviourFields();
std::vector<MaterialField<InkLaw>> inkLawFields();
// Fields that a profile may leave to the project.
struct FilmLimitFields {
    MaterialField<ProcessSettings> tearStretch, overhang;
};
FilmLimitFields filmLimitFields();

// Returns the texts of the profile field at `path`. It must be one of the fields above.
FieldWords materialWords(const QString& path);

} // namespace dipwright
