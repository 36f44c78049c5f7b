#include "sheet/page/InkedPixels.h"

#include "base/ImageRows.h"
#include "parallel/ParallelFor.h"
#include "sheet/page/SheetLayout.h"

#include <QTransform>
#include <algorithm>

namespace dipwright {
namespace {

void addPicture(QImage& mask, const QImage& picture, const QRect& part) {
    uchar* const inked = mask.bits();
    parallelFor(0, mask.height(), [&](int y) {
        const QImage pixels = imageRows(picture, part.y() + y, part.y() + y + 1)
                                  .copy(part.x(), 0, part.width(), 1)
                                  .convertToFormat(QImage::Format_RGBA8888);
        const uchar* pixel = pixels.constScanLine(0);
        uchar* row = inked + y * mask.bytesPerLine();
        for (int x = 0; x < mask.width(); ++x, pixel += 4) {
            if (prints(pixel)) {
                row[x] = 255;
            }
        }
    });
}

void addTints(QImage& mask, const QImage& tints, const QRect& part) {
    for (int y = 0; y < mask.height(); ++y) {
        const uchar* tint = tints.constScanLine(part.y() + y) + part.x();
        uchar* row = mask.scanLine(y);
        for (int x = 0; x < mask.width(); ++x) {
            if (tint[x] != 0) {
                row[x] = 255;
            }
        }
    }
}

// Returns the film image's pixels in a box on the page.
QRect pixelBox(const QImage& image, const QRectF& film, const QRectF& box) {
    if (box.isEmpty()) {
        return {};
    }
    const QTransform toPixels =
        QTransform::fromTranslate(-film.x(), -film.y()) *
        QTransform::fromScale(image.width() / film.width(), image.height() / film.height());
    return toPixels.mapRect(box).toAlignedRect().intersected(image.rect());
}

} // namespace

QImage inkedPixels(const Sheet& sheet, const QRect& part, InkedPlates plates) {
    QImage mask = blankImage(part.size(), QImage::Format_Grayscale8);
    addPicture(mask, sheet.image, part);
    if (plates == InkedPlates::All) {
        if (sheet.wanted) {
            addPicture(mask, sheet.wanted->image, part);
        }
        for (const SheetPlate& plate : sheet.plates) {
            addTints(mask, plate.tint, part);
        }
    }
    return mask;
}

double inkedShare(const Sheet& sheet, const QRectF& film, const QRectF& box) {
    const QRect pixels = pixelBox(sheet.image, film, box.intersected(film));
    if (pixels.isEmpty()) {
        return 0;
    }
    const QImage mask = inkedPixels(sheet, pixels);
    qint64 painted = 0;
    for (int y = 0; y < mask.height(); ++y) {
        const uchar* row = mask.constScanLine(y);
        painted += mask.width() - std::count(row, row + mask.width(), 0);
    }
    return double(painted) / (double(pixels.width()) * pixels.height());
}

QRect inkedBox(const Sheet& sheet, InkedPlates plates) {
    return markedBox(inkedPixels(sheet, sheet.image.rect(), plates));
}

QRect markedBox(const QImage& mask) {
    const auto isInked = [](uchar ink) { return ink != 0; };
    QRect box;
    for (int y = 0; y < mask.height(); ++y) {
        const uchar* const row = mask.constScanLine(y);
        const uchar* const end = row + mask.width();
        const uchar* const first = std::find_if(row, end, isInked);
        if (first != end) {
            const auto last =
                std::find_if(std::reverse_iterator(end), std::reverse_iterator(first), isInked);
            box |= QRect(QPoint(int(first - row), y), QPoint(int(last.base() - row) - 1, y));
        }
    }
    return box;
}

} // namespace dipwright
