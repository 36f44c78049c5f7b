// The page that says how ink thins on film that stretches: rows of patches from light to dense, and
// two rulers that stretch with them (docs/film-model.md, "Ink").
#pragma once

#include "base/Units.h"

#include <QColor>
#include <QIODevice>
#include <QSizeF>
#include <QString>
#include <vector>

namespace dipwright {

// A row of patches, all of one ink.
struct WedgeRow {
    QString name;
    std::vector<QColor> patches;
};

struct WedgePage {
    QSizeF paper{210, 297}; // mm
    // Printed length over true length of the printer that it goes to, across and along.
    double scaleX = 1, scaleY = 1;
    std::vector<WedgeRow> rows;
    // The ICC profile of the printer whose inks the patches are in, QColors in CMYK, and its name;
    // empty: they are in sRGB. PDF only.
    QByteArray inks;
    QString inksName;
    QStringList tones; // over the columns
    QString lot, date; // as they are to stand on the page; empty: a line to write them on
};

// Of both rulers, before the film is stretched.
inline constexpr int wedgeRuler = 100; // mm

// At true size, with the scales corrected. Same bytes for the same page. Needs a QGuiApplication.
// Throws Error where the paper is too small for the rows, or `device` takes no more.
void writeWedgePdf(const WedgePage& page, QIODevice& device);
void writeWedgePng(const WedgePage& page, DotsPerInch resolution, QIODevice& device);

} // namespace dipwright
