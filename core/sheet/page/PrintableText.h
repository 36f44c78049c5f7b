// Names of any script on a page whose fonts do not have them all.
#pragma once

#include <QString>

class QFont;

namespace dipwright {

// The text with each letter that no font of this computer draws as its number, \u4E2D: it would be
// an empty box, in which nobody finds the name again. Needs a QGuiApplication.
QString printableText(const QString& text, const QFont& font);

} // namespace dipwright
