#include "sheet/page/SheetRows.h"

#include "base/ImageRows.h"

#include <QColorSpace>
#include <algorithm>
#include <cstring>

namespace dipwright {
namespace {

constexpr int pixelsAtOnce = 1 << 20;

void pasteRows(QImage& picture, const QImage& rows, int first) {
    if (picture.isNull()) {
        return;
    }
    for (int y = 0; y < rows.height(); ++y) {
        std::memcpy(picture.scanLine(first + y), rows.constScanLine(y),
                    std::size_t(rows.width()) * std::size_t(rows.depth()) / 8);
    }
}

QImage blankLike(const QImage& picture, QSize pixels) {
    QImage blank = blankImage(pixels, picture.format());
    blank.setColorSpace(picture.colorSpace());
    return blank;
}

} // namespace

QSize filmPixels(const Sheet& sheet) {
    return sheet.rows ? sheet.rows->pixels : sheet.image.size();
}

Sheet sheetRows(const Sheet& sheet, int first, int end) {
    if (sheet.rows) {
        return sheet.rows->make(first, end);
    }
    Sheet rows = sheet;
    rows.image = imageRows(sheet.image, first, end);
    for (SheetPlate& plate : rows.plates) {
        plate.tint = imageRows(plate.tint, first, end);
    }
    if (rows.wanted) {
        rows.wanted->image = imageRows(sheet.wanted->image, first, end);
        rows.wanted->stretch = imageRows(sheet.wanted->stretch, first, end);
        rows.wanted->inks = sheet.wanted->inks.each(
            [&](const QImage& plane) { return imageRows(plane, first, end); });
    }
    return rows;
}

void forSheetRows(const Sheet& sheet,
                  const std::function<void(const Sheet& rows, int first)>& work) {
    const QSize pixels = filmPixels(sheet);
    const int step = std::max(pixelsAtOnce / std::max(pixels.width(), 1), 1);
    for (int first = 0; first < pixels.height(); first += step) {
        work(sheetRows(sheet, first, std::min(first + step, pixels.height())), first);
    }
}

Sheet scaledSheet(const Sheet& sheet, QSize pixels) {
    constexpr int rowsAtOnce = 16;
    Sheet small = sheet;
    small.rows.reset();
    small.plates.clear();
    const int height = filmPixels(sheet).height();
    const auto source = [&](int row) { return int(qint64(row) * height / pixels.height()); };
    for (int first = 0; first < pixels.height(); first += rowsAtOnce) {
        const int end = std::min(first + rowsAtOnce, pixels.height());
        const int from = source(first);
        const Sheet rows = sheetRows(sheet, from, std::max(source(end), from + 1));
        const QSize size(pixels.width(), end - first);
        if (first == 0) {
            small.image = blankLike(rows.image, pixels);
            if (small.wanted) {
                small.wanted->image = blankLike(rows.wanted->image, pixels);
                small.wanted->stretch = blankLike(rows.wanted->stretch, pixels);
                small.wanted->inks = rows.wanted->inks.each(
                    [&](const QImage& plane) { return blankLike(plane, pixels); });
            }
        }
        const auto smooth = [&](const QImage& image) {
            return image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
                .convertToFormat(image.format());
        };
        pasteRows(small.image, smooth(rows.image), first);
        if (small.wanted) {
            pasteRows(small.wanted->image, smooth(rows.wanted->image), first);
            // Unsmoothed, because the pixels are numbers.
            pasteRows(small.wanted->stretch, rows.wanted->stretch.scaled(size), first);
            if (const InkPlanes& inks = rows.wanted->inks; !inks.isNull()) {
                pasteRows(small.wanted->inks.colours, inks.colours.scaled(size), first);
                pasteRows(small.wanted->inks.black, inks.black.scaled(size), first);
            }
        }
    }
    return small;
}

} // namespace dipwright
