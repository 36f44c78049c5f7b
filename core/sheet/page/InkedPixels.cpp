#include "sheet/page/InkedPixels.h"

#include "parallel/ParallelFor.h"
#include "sheet/page/SheetLayout.h"

#include <algorithm>

namespace dipwright {
namespace {

void addPicture(QImage& mask, const QImage& picture, const QRect& part) {
    const QImage pixels = picture.copy(part).convertToFormat(QImage::Format_RGBA8888);
    uchar* const inked = mask.bits();
    parallelFor(0, mask.height(), [&](int y) {
        const uchar* pixel = pixels.constScanLine(y);
        uchar* row = inked + y * mask.bytesPerLine();
        for (int x = 0; x < mask.width(); ++x, pixel += 4) {
            row[x] |= prints(pixel) ? 255 : 0;
        }
    });
}

void addTints(QImage& mask, const QImage& tints, const QRect& part) {
    for (int y = 0; y < mask.height(); ++y) {
        const uchar* tint = tints.constScanLine(part.y() + y) + part.x();
        uchar* row = mask.scanLine(y);
        std::transform(tint, tint + mask.width(), row, row,
                       [](uchar ink, uchar before) { return uchar(ink != 0 ? 255 : before); });
    }
}

} // namespace

QImage inkedPixels(const Sheet& sheet, const QRect& part, InkedPlates plates) {
    QImage mask(part.size(), QImage::Format_Grayscale8);
    mask.fill(0);
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

QRect inkedBox(const Sheet& sheet, InkedPlates plates) {
    const QImage mask = inkedPixels(sheet, sheet.image.rect(), plates);
    const auto isInked = [](uchar ink) { return ink != 0; };
    int left = mask.width(), right = -1, top = -1, bottom = -1;
    for (int y = 0; y < mask.height(); ++y) {
        const uchar* const row = mask.constScanLine(y);
        const uchar* const end = row + mask.width();
        const uchar* const first = std::find_if(row, end, isInked);
        if (first == end) {
            continue;
        }
        left = std::min(left, int(first - row));
        const auto last =
            std::find_if(std::reverse_iterator(end), std::reverse_iterator(row), isInked);
        right = std::max(right, int(last.base() - row) - 1);
        top = top < 0 ? y : top;
        bottom = y;
    }
    return {QPoint(left, top), QPoint(right, bottom)};
}

} // namespace dipwright
