// Makes the page that measures how ink thins on stretched film: rows of patches from light to
// dense, and two rulers that stretch with them (docs/film-model.md, "Ink").
#pragma once

#include "base/Units.h"

#include <QColor>
#include <QIODevice>
#include <QSizeF>
#include <QString>
#include <vector>

namespace dipwright {

// A row of patches of one ink.
struct WedgeRow {
    QString name;
    std::vector<QColor> patches;
};

struct WedgePage {
    QSizeF paper{210, 297}; // mm
    // The length that the printer prints, divided by the true length; across and along the page.
    double scaleX = 1, scaleY = 1;
    std::vector<WedgeRow> rows;
    // ICC profile of the printer. With a profile, the patches are CMYK colours in the printer's
    // inks (PDF only). Empty: the patches are in sRGB.
    QByteArray inks;
    QString inksName;  // the profile's name
    QStringList tones; // captions of the columns
    QString lot, date; // printed on the page; empty: the page has a blank line to fill in
};

// Length of each of the two rulers before the film is stretched.
inline constexpr int wedgeRuler = 100; // mm

// Write the page so that the printer prints it at true size (scaleX, scaleY). The same page gives
// the same bytes. Both need a QGuiApplication. Both throw Error if the paper is too small for the
// rows or `device` cannot be written.
void writeWedgePdf(const WedgePage& page, QIODevice& device);
void writeWedgePng(const WedgePage& page, DotsPerInch resolution, QIODevice& device);

} // namespace dipwright
