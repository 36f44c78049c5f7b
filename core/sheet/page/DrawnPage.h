// A page that is drawn in mm, written at true size. Private to this folder.
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
    // Printed length over true length of the printer that it goes to, across and along.
    double scaleX = 1, scaleY = 1;
    std::function<void(QPainter&)> paint; // in mm, origin the page's upper left corner
    QByteArray inks = {}; // the ICC profile of those that a PDF is drawn in; empty: sRGB
    QString inksName = {};
};

// Same bytes for the same page. Throws Error where `device` takes no more.
void writeDrawnPdf(const DrawnPage& page, QIODevice& device);
void writeDrawnPng(const DrawnPage& page, DotsPerInch resolution, QIODevice& device);

} // namespace dipwright
