// Asks for the film profile that takes what was measured, and writes it.
#pragma once

#include "settings/Profile.h"
#include "workbench/jobs/Messages.h"

#include <QWidget>
#include <functional>

namespace dipwright {

// `chosen` is called later with a name that is not empty, or never.
void askProfileName(QWidget& window, const std::function<void(const QString& name)>& chosen);

// The profile of that name, or a new one, with what `change` makes of it; says so, or why not.
void saveToProfile(Messages& messages, const QString& name,
                   const std::function<FilmProfile(const FilmProfile&)>& change);

} // namespace dipwright
