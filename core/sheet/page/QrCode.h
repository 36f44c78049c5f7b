// Draws a text as a QR code.
#pragma once

#include <QPainter>
#include <QRectF>
#include <QString>

namespace dipwright {

// Draws the code, black on white, in `place`, with the quiet zone of four squares that ISO/IEC
// 18004 requires. Uses libqrencode with error correction M. `text` may have several hundred
// characters.
void paintQrCode(QPainter& painter, const QRectF& place, const QString& text);

} // namespace dipwright
