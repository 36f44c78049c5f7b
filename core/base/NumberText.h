// Numbers in texts for people: windows, reports, notes and printed pages. Files and the output that
// scripts read have plain numbers instead (QString::number).
#pragma once

#include <QLocale>
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

// Returns a number with this number of decimals, in the program's language (QLocale's default).
inline QString numberText(double value, int decimals) {
    return withMinusSign(QLocale().toString(value, 'f', decimals));
}

// The same with this number of significant digits, but without trailing zeros.
inline QString roundedText(double value, int digits) {
    return withMinusSign(QLocale().toString(value, 'g', digits));
}

} // namespace dipwright
