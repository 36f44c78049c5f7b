#include "sheet/page/PrintableText.h"

#include <QFont>
#include <QFontMetricsF>
#include <QList>

namespace dipwright {

QString printableText(const QString& text, const QFont& font) {
    constexpr char32_t lastOfFourDigits = 0xffff;
    const QFontMetricsF metrics(font); // also looks into fallback fonts
    QString printable;
    for (const char32_t letter : text.toUcs4()) {
        if (QChar::isSpace(letter) || metrics.inFontUcs4(letter)) {
            printable += QString::fromUcs4(&letter, 1);
            continue;
        }
        const bool isLong = letter > lastOfFourDigits;
        printable += QLatin1String(isLong ? "\\U" : "\\u") +
                     QString::number(uint(letter), 16)
                         .toUpper()
                         .rightJustified(isLong ? 8 : 4, QLatin1Char('0'));
    }
    return printable;
}

} // namespace dipwright
