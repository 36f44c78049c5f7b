// Measures pages of a PDF as poppler renders them.
#pragma once

#include <QImage>
#include <QRectF>
#include <QString>
#include <vector>

namespace dipwright {

// Runs a program and returns its standard output. If that fails, warns and returns nothing.
QByteArray output(const QString& program, const QStringList& arguments);

// The page's size in mm.
QSizeF pdfPage(const QString& path, int page = 1);
// The page's text.
QString pdfWords(const QString& path, int page = 1);

// Renders the page, or the part of it in `box` (mm), in grey.
QImage renderedPage(const QString& path, int dpi, const QRectF& box = {}, int page = 1);

// Where a row of pixels changes between light and dark, in pixels. The light of the pixels between
// gives the fraction. Ignores `margin` pixels at both ends.
std::vector<double> edges(const QImage& grey, int row, int margin);

// The middles of the dark runs along row or column `at`, in pixels.
std::vector<double> darkMiddles(const QImage& grey, bool alongRow, int at);

} // namespace dipwright
