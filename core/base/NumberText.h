// Gives negative numbers a minus sign in texts for people: windows, reports and printed pages.
#pragma once

#include <QRegularExpression>
#include <QString>

namespace dipwright {

// Returns the text of a number with a minus sign (−, U+2212) instead of a hyphen. A number that is
// rounded to zero has no sign. `number` is formatted by QLocale, whose English, German and
// Portuguese numbers have hyphens.
inline QString withMinusSign(QString number) {
    static const QRegularExpression hyphenOfZero(QStringLiteral("^-(?=[0.,]+$)"));
    return number.remove(hyphenOfZero).replace(QLatin1Char('-'), QStringLiteral("−"));
}

} // namespace dipwright
