#include "sheet/page/InkedPixels.h"

#include "base/ImageRows.h"
#include "parallel/ParallelFor.h"
#include "sheet/page/SheetLayout.h"
#include "sheet/page/SheetRows.h"

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
QRect pixelBox(QSize image, const QRectF& film, const QRectF& box) {
    if (box.isEmpty()) {
        return {};
    }
    const QTransform toPixels =
        QTransform::fromTranslate(-film.x(), -film.y()) *
        QTransform::fromScale(image.width() / film.width(), image.height() / film.height());
    return toPixels.mapRect(box).toAlignedRect().intersected(QRect(QPoint(), image));
}

} // namespace

QImage inkedPixels(const Sheet& sheet, const QRect& part, InkedPlates plates) {
    const Sheet rows = sheetRows(sheet, part.top(), part.bottom() + 1);
    const QRect box(part.left(), 0, part.width(), part.height()); // in these rows
    QImage mask = blankImage(part.size(), QImage::Format_Grayscale8);
    addPicture(mask, rows.image, box);
    if (plates == InkedPlates::All) {
        if (rows.wanted) {
            addPicture(mask, rows.wanted->image, box);
        }
        for (const SheetPlate& plate : rows.plates) {
            addTints(mask, plate.tint, box);
        }
    }
    return mask;
}

void forInkedPixels(const Sheet& sheet, InkedPlates plates,
                    const std::function<void(const QImage& mask, int first)>& work) {
    forSheetRows(sheet, [&](const Sheet& rows, int first) {
        work(inkedPixels(rows, QRect(QPoint(), filmPixels(rows)), plates), first);
    });
}

double inkedShare(const Sheet& sheet, const QRectF& film, const QRectF& box) {
    const QRect pixels = pixelBox(filmPixels(sheet), film, box.intersected(film));
    const auto& pieces = sheet.pieces;
    const bool isBesidePieces =
        !pieces.empty() && std::none_of(pieces.begin(), pieces.end(), [&](const SheetPiece& piece) {
            return piece.pictureOnPage().intersects(box);
        });
    if (pixels.isEmpty() || isBesidePieces) {
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
    QRect box;
    forInkedPixels(sheet, plates, [&](const QImage& mask, int first) {
        box |= markedBox(mask).translated(0, first);
    });
    return box;
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
