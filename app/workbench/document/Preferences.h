// What the user has chosen for the program, not for a project.
#pragma once

#include "base/Units.h"

#include <QKeySequence>
#include <QMap>
#include <QString>

namespace dipwright {

enum class ThemeChoice { System, Light, Dark };
enum class NavigationChoice { Turntable, Trackball };

struct Preferences {
    LengthUnit unit = LengthUnit::Millimetre;
    ThemeChoice theme = ThemeChoice::System;
    QString language; // "en", "de", "pt_BR"; empty: the system's
    NavigationChoice navigation = NavigationChoice::Turntable;
    int autosaveSeconds = 20;
    QString filmPreset = QStringLiteral("A4"); // of new projects
    QString filmProfile;                       // of new projects; empty: none
    QString printerProfile;                    // of new projects; empty: none
    bool liveUpdate = true;   // simulate again after each change, once there is a result
    bool keepsResults = true; // beside a project's file, for who opens it again
    QMap<QString, QKeySequence> shortcuts; // by the action's name, where not the default
    bool operator==(const Preferences&) const = default;
};

Preferences loadPreferences();
void savePreferences(const Preferences& preferences);

} // namespace dipwright
