// The user's preferences for the program.
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
    QString language; // "en", "de", "pt_BR"; empty: system language
    NavigationChoice navigation = NavigationChoice::Turntable;
    int autosaveSeconds = 20;
    QString filmPreset = QStringLiteral("A4"); // for new projects
    QString filmProfile;                       // for new projects; empty: none
    QString printerProfile;                    // for new projects; empty: none
    bool liveUpdate = true;                // run again after each change, once there is a result
    bool keepsResults = true;              // keep results in a cache beside the project file
    QMap<QString, QKeySequence> shortcuts; // by action name, only if not the default
    bool operator==(const Preferences&) const = default;
};

Preferences loadPreferences();
void savePreferences(const Preferences& preferences);

} // namespace dipwright
