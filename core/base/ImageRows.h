// Large pictures without copies: blank ones that take memory only where they are written, and runs
// of their rows.
#pragma once

#include <QImage>

#include <functional>

namespace dipwright {

// A picture of zeros: transparent in RGBA8888 and RGBA64, no tint in Grayscale8. The system gives
// it memory page by page, where a pixel is written. Null where it does not fit into memory.
QImage blankImage(QSize pixels, QImage::Format format);

// The rows first … end - 1 of a picture, its pixels shared with it: not to outlive it.
QImage imageRows(const QImage& image, int first, int end);

// Calls work(rows, first) for runs of about a megapixel, from the top down, one after the other.
void forImageRows(const QImage& image,
                  const std::function<void(const QImage& rows, int first)>& work);

} // namespace dipwright
