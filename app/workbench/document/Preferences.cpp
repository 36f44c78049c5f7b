#include "workbench/document/Preferences.h"

#include <QSettings>
#include <algorithm>

namespace dipwright {

Preferences loadPreferences() {
    QSettings settings;
    settings.beginGroup(QStringLiteral("preferences"));
    const Preferences standard;
    const auto choice = [&settings](const char* key, int count) {
        return std::clamp(settings.value(QLatin1String(key), 0).toInt(), 0, count - 1);
    };
    Preferences preferences;
    preferences.unit = LengthUnit(choice("unit", 2));
    preferences.theme = ThemeChoice(choice("theme", 3));
    preferences.navigation = NavigationChoice(choice("navigation", 2));
    preferences.language = settings.value(QStringLiteral("language")).toString();
    preferences.autosaveSeconds = std::clamp(
        settings.value(QStringLiteral("autosaveSeconds"), standard.autosaveSeconds).toInt(), 1,
        3600);
    preferences.filmPreset =
        settings.value(QStringLiteral("filmPreset"), standard.filmPreset).toString();
    preferences.filmProfile = settings.value(QStringLiteral("filmProfile")).toString();
    preferences.printerProfile = settings.value(QStringLiteral("printerProfile")).toString();
    preferences.liveUpdate =
        settings.value(QStringLiteral("liveUpdate"), standard.liveUpdate).toBool();
    preferences.keepsResults =
        settings.value(QStringLiteral("keepsResults"), standard.keepsResults).toBool();
    settings.beginGroup(QStringLiteral("shortcuts"));
    for (const QString& action : settings.childKeys()) {
        preferences.shortcuts[action] =
            QKeySequence(settings.value(action).toString(), QKeySequence::PortableText);
    }
    return preferences;
}

void savePreferences(const Preferences& preferences) {
    QSettings settings;
    settings.beginGroup(QStringLiteral("preferences"));
    settings.setValue(QStringLiteral("unit"), int(preferences.unit));
    settings.setValue(QStringLiteral("theme"), int(preferences.theme));
    settings.setValue(QStringLiteral("navigation"), int(preferences.navigation));
    settings.setValue(QStringLiteral("language"), preferences.language);
    settings.setValue(QStringLiteral("autosaveSeconds"), preferences.autosaveSeconds);
    settings.setValue(QStringLiteral("filmPreset"), preferences.filmPreset);
    settings.setValue(QStringLiteral("filmProfile"), preferences.filmProfile);
    settings.setValue(QStringLiteral("printerProfile"), preferences.printerProfile);
    settings.setValue(QStringLiteral("liveUpdate"), preferences.liveUpdate);
    settings.setValue(QStringLiteral("keepsResults"), preferences.keepsResults);
    settings.remove(QStringLiteral("shortcuts"));
    settings.beginGroup(QStringLiteral("shortcuts"));
    for (auto shortcut = preferences.shortcuts.begin(); shortcut != preferences.shortcuts.end();
         ++shortcut) {
        settings.setValue(shortcut.key(), shortcut->toString(QKeySequence::PortableText));
    }
}

} // namespace dipwright
