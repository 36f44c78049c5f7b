// Handles large pictures without copies: blank pictures that take memory only where they are
// written, and views of some rows.
#pragma once

#include <QImage>

#include <functional>

namespace dipwright {

// Returns a picture of zeros: transparent in RGBA8888 and RGBA64, no tint in Grayscale8. The
// operating system provides its memory page by page when pixels are written. Null if it does not
// fit into memory.
QImage blankImage(QSize pixels, QImage::Format format);

// Returns the rows first … end - 1 of a picture. They share its pixels and must not outlive it.
QImage imageRows(const QImage& image, int first, int end);

// Calls work(rows, first) for runs of rows of about a megapixel, in order from the top.
void forImageRows(const QImage& image,
                  const std::function<void(const QImage& rows, int first)>& work);

} // namespace dipwright
