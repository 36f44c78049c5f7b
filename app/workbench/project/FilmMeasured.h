// What of a film was measured by photos and what is a guess, in words.
#pragma once

#include <QString>

class QComboBox;

namespace dipwright {

struct FilmProfile;
struct Project;

// "measured on 2026-11-02" or "not measured".
QString measuredText(const FilmProfile& film);
// The same of the numbers that a project's film is dipped with: "Swell measured on 2026-11-02;
// growth, relaxation not measured".
QString measuredText(const Project& project);

// Adds "None" and the film profiles at hand, each marked so, the name as its data, and shows
// `chosen` if it is there. Files that are damaged are passed over.
void addFilmProfiles(QComboBox& box, const QString& chosen);

} // namespace dipwright
