// Writes pages that are drawn in mm, at true size. Private to this folder.
#pragma once

#include "base/Units.h"

#include <QIODevice>
#include <QPainter>
#include <QSizeF>
#include <QString>
#include <functional>

namespace dipwright {

struct DrawnPage {
    QString title;
    QSizeF paper; // mm
    // The length that the printer prints, divided by the true length; across and along the page.
    double scaleX = 1, scaleY = 1;
    std::function<void(QPainter&)> paint; // draws in mm; origin: the page's upper left corner
    QByteArray inks = {};                 // ICC profile of the inks for a PDF; empty: sRGB
    QString inksName = {};
};

// Write the page. The same page gives the same bytes. Throw Error if `device` cannot be written.
void writeDrawnPdf(const DrawnPage& page, QIODevice& device);
void writeDrawnPng(const DrawnPage& page, DotsPerInch resolution, QIODevice& device);

} // namespace dipwright
