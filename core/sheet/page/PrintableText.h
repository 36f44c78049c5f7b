// Makes names in any script readable on a page whose fonts lack some of their letters.
#pragma once

#include <QString>

class QFont;

namespace dipwright {

// Returns the text with its code point, as in \u4E2D, in place of each letter that no installed
// font can draw. Otherwise such a letter would be an empty box, and the name could not be
// recognised. Needs a QGuiApplication.
QString printableText(const QString& text, const QFont& font);

} // namespace dipwright
