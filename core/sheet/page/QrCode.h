// A text as a QR code.
#pragma once

#include <QPainter>
#include <QRectF>
#include <QString>

namespace dipwright {

// Black squares on white, with the quiet zone of four of them that ISO/IEC 18004 asks for, in
// `place`. By libqrencode, error correction M. `text` is short: some hundred letters.
void paintQrCode(QPainter& painter, const QRectF& place, const QString& text);

} // namespace dipwright
