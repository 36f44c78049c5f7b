// Asks for a film profile and saves a measurement in it.
#pragma once

#include "settings/Profile.h"
#include "workbench/jobs/Messages.h"

#include <QWidget>
#include <functional>

namespace dipwright {

// Opens a dialog. Calls `chosen` later with a name that is not empty, unless the user cancels.
void askProfileName(QWidget& window, const std::function<void(const QString& name)>& chosen);

// Applies `change` to the profile with this name, or to `fresh` if there is none, and saves it.
// Reports the outcome to `messages`.
void saveToProfile(Messages& messages, const QString& name, const FilmProfile& fresh,
                   const std::function<FilmProfile(const FilmProfile&)>& change);

} // namespace dipwright
