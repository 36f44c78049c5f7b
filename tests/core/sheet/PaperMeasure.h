// Measures the pages of a PDF, rendered by poppler.
#pragma once

#include <QImage>
#include <QRectF>
#include <QString>
#include <vector>

namespace dipwright {

// Runs a program and returns its standard output. If the program fails, warns and returns an empty
// text.
QByteArray output(const QString& program, const QStringList& arguments);

// Returns the page's size in mm.
QSizeF pdfPage(const QString& path, int page = 1);
// Returns the page's text.
QString pdfWords(const QString& path, int page = 1);

// Renders the page, or the part of it in `box` (mm), in grey.
QImage renderedPage(const QString& path, int dpi, const QRectF& box = {}, int page = 1);

// Returns the places, in pixels, where a row changes between light and dark. The grey of the pixels
// in between gives the fraction. Ignores `margin` pixels at both ends.
std::vector<double> edges(const QImage& grey, int row, int margin);

// Returns the middles of the dark runs along row or column `at`, in pixels.
std::vector<double> darkMiddles(const QImage& grey, bool alongRow, int at);

} // namespace dipwright
