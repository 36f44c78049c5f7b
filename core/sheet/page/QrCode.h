// Draws a text as a QR code.
#pragma once

#include <QPainter>
#include <QRectF>
#include <QString>

namespace dipwright {

// Draws black squares on white in `place`, with the quiet zone of four squares that ISO/IEC 18004
// asks for. Uses libqrencode with error correction M. `text` has at most some hundred letters.
void paintQrCode(QPainter& painter, const QRectF& place, const QString& text);

} // namespace dipwright
