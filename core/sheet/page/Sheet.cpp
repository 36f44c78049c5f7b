#include "sheet/page/Sheet.h"

#include "base/Error.h"
#include "base/Sha256.h"
#include "base/WideGamut.h"
#include "sheet/page/CutContour.h"
#include "sheet/page/SheetInk.h"
#include "sheet/page/SheetRows.h"
#include "sheet/pdf/InkedPages.h"

#include <QColorSpace>
#include <QCoreApplication>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Sheet)
};

// Draws a film whose pictures are made on demand: reduced to the painter's own pixels, or in bands.
void drawFilmRows(QPainter& painter, const QRectF& film, const Sheet& sheet) {
    const QSize pixels = filmPixels(sheet);
    const int width = int(std::ceil(painter.combinedTransform().mapRect(film).width()));
    if (width < pixels.width()) {
        painter.drawImage(film, reduced(sheet, std::max(width, 1)));
        return;
    }
    const double row = film.height() / pixels.height();
    forSheetRows(sheet, [&](const Sheet& rows, int first) {
        painter.drawImage(
            QRectF(film.left(), film.top() + first * row, film.width(), rows.image.height() * row),
            flattened(rows.image));
    });
}

} // namespace

QSize sheetPixels(Millimetres width, Millimetres height, DotsPerInch resolution) {
    const double columns = std::round(width.value() * pixelsPerMillimetre(resolution));
    const double rows = std::round(height.value() * pixelsPerMillimetre(resolution));
    if (!(columns >= 1 && rows >= 1 && columns <= mostSheetPixels && rows <= mostSheetPixels)) {
        throw Error(Text::tr("A film of %1 × %2 mm at %3 dpi needs an image outside the range of 1 "
                             "to %4 pixels per side; choose another resolution or film size")
                        .arg(width.value())
                        .arg(height.value())
                        .arg(resolution.value())
                        .arg(mostSheetPixels),
                    QStringLiteral("sheet.dpi"));
    }
    return {int(columns), int(rows)};
}

QImage onWhitePaper(const QImage& filmImage) {
    const bool wide = isWide(filmImage);
    QImage page(filmImage.size(), wide ? QImage::Format_RGBX64 : QImage::Format_RGB888);
    page.fill(Qt::white);
    QPainter painter(&page);
    painter.drawImage(0, 0, filmImage);
    painter.end();
    page.setColorSpace(wide ? wideSpace() : QColorSpace(QColorSpace::SRgb));
    return page;
}

QImage flattened(const QImage& filmImage) {
    QImage page = inSrgb(onWhitePaper(filmImage));
    page.setColorSpace(QColorSpace::SRgb);
    return page;
}

QImage reduced(const Sheet& sheet, int width) {
    const QSize film = filmPixels(sheet);
    const int height = std::max(int(std::lround(double(film.height()) * width / film.width())), 1);
    constexpr int rowsAtOnce = 16;
    if (film.height() < 2 * height) {
        return flattened(sheetRows(sheet, 0, film.height()).image)
            .scaled(width, height, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    }
    QImage picture(width, height, QImage::Format_RGB888);
    QPainter painter(&picture);
    const auto source = [&](int row) { return int(qint64(row) * film.height() / height); };
    for (int row = 0; row < height; row += rowsAtOnce) {
        const int end = std::min(row + rowsAtOnce, height);
        const QImage rows = flattened(sheetRows(sheet, source(row), source(end)).image);
        painter.drawImage(
            0, row, rows.scaled(width, end - row, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
    }
    return picture;
}

bool isWhite(const SheetPlate& plate, const SheetSettings& settings) {
    return settings.white != WhiteLayer::None && plate.name == settings.whiteName;
}

QString hashOfJobs(const QStringList& jobs) {
    constexpr int letters = 12;
    return sha256Hex(jobs.join(u' ').toLatin1()).left(letters);
}

void paintSheet(QPainter& painter, const Sheet& sheet) {
    const SheetLayout layout = sheetLayout(sheet);
    painter.save();
    painter.setRenderHint(QPainter::LosslessImageRendering);
    if (replacesImages(painter)) {
        QImage pixel(1, 1, QImage::Format_RGB888);
        pixel.fill(Qt::white); // the same in every run
        painter.drawImage(layout.film, pixel);
    } else if (sheet.rows) {
        drawFilmRows(painter, layout.film, sheet);
    } else {
        painter.drawImage(layout.film, flattened(sheet.image));
    }
    if (isInkedPage(painter)) {
        const SpotInk cutter{sheet.settings.cutName,
                             {0, 1, 0, 0}}; // magenta where the name is unknown
        strokeCut(painter, cutContour(sheet, layout), hairline, cutter,
                  sheet.settings.cutBleed.value());
    }
    paintMarks(painter, layout);
    painter.restore();
}

void correctScale(QPainter& painter, QSizeF paper, const PrintCorrection& correction) {
    const QPointF middle(paper.width() / 2, paper.height() / 2);
    painter.translate(middle);
    painter.scale(1 / correction.scaleX, 1 / correction.scaleY);
    painter.translate(-middle);
}

void paintCorrectedSheet(QPainter& painter, const Sheet& sheet, const PrintCorrection& correction) {
    const QSizeF page = pageSize(sheet);
    painter.save();
    correctScale(painter, correction.acrossPaper ? page.transposed() : page, correction);
    if (correction.acrossPaper) {
        painter.translate(page.height(), 0);
        painter.rotate(90);
    }
    paintSheet(painter, sheet);
    painter.restore();
}

} // namespace dipwright
