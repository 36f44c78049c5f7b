// Light and dark themes, each with one palette that is checked for contrast.
#pragma once

#include <QPalette>
#include <QString>

class QApplication;

namespace dipwright {

enum class Theme { System, Light, Dark };

QPalette themePalette(bool dark);
void applyTheme(QApplication& application, Theme theme);
bool isDark(); // of the current palette

} // namespace dipwright
