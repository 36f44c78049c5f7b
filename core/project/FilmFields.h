// A film's material: the fields that a project and a film profile have in common, each declared
// once. Project file and profile file, `--set`, the window, the job's number and the check of
// docs/files-and-commands.md have path, unit, limits and words from here.
//
// Paths are those from the part's own object. A project has them as "film.swell", "ink.exponents"
// and "process.overhang_deg"; a profile as "swell", "ink_exponents" and "overhang_deg".
#pragma once

#include "base/Units.h"
#include "project/Field.h"
#include "settings/FilmSettings.h"
#include "settings/InkSettings.h"
#include "settings/ProcessSettings.h"

#include <QMap>
#include <vector>

namespace dipwright {

// How a field is called and explained to the user, in the program's language.
struct FieldWords {
    QString label;
    QString help; // a sentence or two: what it is and what it does
    Unit unit = Unit::None;
    QStringList parts = {};            // short names where the value has several: "X", "Y"
    QMap<QString, QString> words = {}; // the choices
    QString absent = {};               // what no value means, where there may be none: "Elastic"
    double whenPresent = 1;            // the value when the user asks for one
    bool linked = false;               // several parts that usually are one number
    bool isOfProductionFilm = false;   // says nothing of the paper's film
};

template <typename Part>
struct MaterialField {
    Field<Part> field;
    FieldWords words;
};

std::vector<MaterialField<FilmBehaviour>> filmBehaviourFields();
std::vector<MaterialField<InkLaw>> inkLawFields();
// A profile may leave these to the project.
struct FilmLimitFields {
    MaterialField<ProcessSettings> tearStretch, overhang;
};
FilmLimitFields filmLimitFields();

// Of the field that a profile has at `path`, which must be one of those above.
FieldWords materialWords(const QString& path);

} // namespace dipwright
