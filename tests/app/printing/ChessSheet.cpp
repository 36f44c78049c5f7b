#include "ChessSheet.h"

#include "PaperMeasure.h"

namespace dipwright {

Sheet chessSheet(const QString& immersion, QSizeF film) {
    Sheet sheet;
    sheet.filmWidth = Millimetres(film.width());
    sheet.filmHeight = Millimetres(film.height());
    sheet.image = QImage(sheetPixels(sheet.filmWidth, sheet.filmHeight, sheet.settings.resolution),
                         QImage::Format_RGBA8888);
    sheet.image.fill(Qt::transparent);
    QPainter painter(&sheet.image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(sheet.image.width() / film.width(), sheet.image.height() / film.height());
    painter.translate(film.width() / 2, film.height() / 2);
    for (int row = -5; row < 5; ++row) {
        for (int column = -5; column < 5; ++column) {
            if ((row + column) % 2 == 0) {
                const bool middle = row == 0 && column == 0;
                painter.fillRect(QRectF(17 * column, 17 * row, 17, 17),
                                 middle ? QColor(200, 20, 60) : QColor(0, 0, 0));
            }
        }
    }
    sheet.job = {QStringLiteral("Turtle"),     immersion,
                 QStringLiteral("2026-03-01"), QStringLiteral("A4 210 × 297 mm"),
                 QStringLiteral("1:1"),        QStringLiteral("3fa9c2d1")};
    return sheet;
}

std::vector<double> squares(const QString& path, bool across) {
    constexpr int dpi = 600;
    const QSizeF page = pdfPage(path);
    const double off = 2.5 * 17;
    const QRectF line = across ? QRectF(15, page.height() / 2 + off, page.width() - 30, 1)
                               : QRectF(page.width() / 2 + off, 15, 1, page.height() - 30);
    QImage strip = renderedPage(path, dpi, line);
    if (!across) {
        strip = strip.transformed(QTransform().rotate(90));
    }
    const std::vector<double> found = edges(strip, strip.height() / 2, 0);
    std::vector<double> sizes;
    for (std::size_t i = 1; i < found.size(); ++i) {
        sizes.push_back((found[i] - found[i - 1]) / dpi * millimetresPerInch);
    }
    return sizes;
}

} // namespace dipwright
