// Light and dark: one palette each, checked for contrast.
#pragma once

#include <QPalette>
#include <QString>

class QApplication;

namespace dipwright {

enum class Theme { System, Light, Dark };

QPalette themePalette(bool dark);
void applyTheme(QApplication& application, Theme theme);
bool isDark(); // of the palette in use

} // namespace dipwright
