// Handles large pictures without copies: blank pictures that take memory only where they are
// written, and views of some rows.
#pragma once

#include <QImage>

#include <functional>

namespace dipwright {

// Returns a picture of zeros: transparent in RGBA8888 and RGBA64, no tint in Grayscale8. The
// operating system provides the picture's memory page by page when pixels are written. Returns a
// null picture if memory does not suffice.
QImage blankImage(QSize pixels, QImage::Format format);

// Returns the rows first … end - 1 of a picture. The result shares the picture's pixels and must
// not outlive the picture.
QImage imageRows(const QImage& image, int first, int end);

// Calls work(rows, first) for bands of about one megapixel each, from top to bottom. `first` is the
// number of the band's first row.
void forImageRows(const QImage& image,
                  const std::function<void(const QImage& rows, int first)>& work);

} // namespace dipwright
