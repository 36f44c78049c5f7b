#include "sheet/page/QrCode.h"

#include <memory>
#include <new>
#include <qrencode.h>

namespace dipwright {

void paintQrCode(QPainter& painter, const QRectF& place, const QString& text) {
    constexpr int quiet = 4; // squares on each side
    const std::unique_ptr<QRcode, decltype(&QRcode_free)> code(
        QRcode_encodeString8bit(text.toUtf8().constData(), 0, QR_ECLEVEL_M), &QRcode_free);
    if (!code) {
        throw std::bad_alloc(); // a short text always fits
    }
    const double side = place.width() / (code->width + 2 * quiet);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false); // no light gaps between squares
    painter.fillRect(place, Qt::white);
    for (int row = 0; row < code->width; ++row) {
        for (int column = 0; column < code->width; ++column) {
            if (code->data[row * code->width + column] & 1) {
                painter.fillRect(QRectF(place.x() + (column + quiet) * side,
                                        place.y() + (row + quiet) * side, side, side),
                                 Qt::black);
            }
        }
    }
    painter.restore();
}

} // namespace dipwright
