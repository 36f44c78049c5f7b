// Makes names in any script readable on a page whose fonts lack some of their letters.
#pragma once

#include <QString>

class QFont;

namespace dipwright {

// Replaces each letter that no installed font can draw by its code point, as in \u4E2D. Otherwise
// such a letter would be an empty box, and the name could not be recognised. Needs a
// QGuiApplication.
QString printableText(const QString& text, const QFont& font);

} // namespace dipwright
