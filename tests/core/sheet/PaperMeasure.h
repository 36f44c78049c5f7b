// Measures what is on a PDF's page, by poppler's renderer.
#pragma once

#include <QImage>
#include <QRectF>
#include <QString>
#include <vector>

namespace dipwright {

// Runs a program and gives its standard output; empty, with a warning, when it fails.
QByteArray output(const QString& program, const QStringList& arguments);

// The page's size in mm.
QSizeF pdfPage(const QString& path, int page = 1);
// Its words.
QString pdfWords(const QString& path, int page = 1);

// The page in grey, or the part of it in `box` (mm).
QImage renderedPage(const QString& path, int dpi, const QRectF& box = {}, int page = 1);

// Where a row of pixels passes from light to dark or back, in pixels, to a fraction by the share of
// light in the pixels between; `margin` pixels at both ends are left out.
std::vector<double> edges(const QImage& grey, int row, int margin);

// Middles of the dark runs along a row of pixels (or a column), in pixels.
std::vector<double> darkMiddles(const QImage& grey, bool alongRow, int at);

} // namespace dipwright
