// Says which values of a film were measured from photos and which are guesses.
#pragma once

#include <QString>

class QComboBox;

namespace dipwright {

struct FilmProfile;
struct Project;

// "measured on 2026-11-02" or "not measured".
QString measuredText(const FilmProfile& film);
// Says which film values of a project were measured: "Swell measured on 2026-11-02; growth,
// relaxation not measured".
QString measuredText(const Project& project);

// Adds "None" and all film profiles with their measuredText(); each item's data is the name.
// Selects `chosen` if it exists. Skips damaged files.
void addFilmProfiles(QComboBox& box, const QString& chosen);

} // namespace dipwright
