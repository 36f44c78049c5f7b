// The two pages that a film is measured with: a chessboard on the film, and one on a stiff card
// that lies beside it on the water and says how long a millimetre is.
#pragma once

#include "base/Units.h"
#include "sheet/page/CodedBoard.h"

#include <QIODevice>
#include <QPainter>
#include <QSizeF>
#include <QString>

namespace dipwright {

struct WatchPage {
    BoardKind kind = BoardKind::Film;
    QSizeF paper{210, 297}; // mm
    // Printed length over true length of the printer that it goes to, across and along.
    double scaleX = 1, scaleY = 1;
    QString lot, date; // as they are to stand on the page; empty: a line to write them on
};

// Where the board's squares lie on the page, mm.
struct WatchBoard {
    int columns = 0, rows = 0;
    QRectF box;
};

// The least corners between four squares of either board that a film is measured by.
inline constexpr int leastWatchCorners = 60;
// Of both rulers on the page.
inline constexpr int watchRuler = 100; // mm

// As many whole squares as the paper has room for. Throws Error where these are too few.
WatchBoard watchBoard(const WatchPage& page);

// Draws it as for a true printer, with a painter in mm, origin the page's upper left corner. Needs
// a QGuiApplication.
void paintWatchPage(QPainter& painter, const WatchPage& page);
// At true size, with the scales corrected. Same bytes for the same page. Both throw Error where the
// paper is too small or `device` takes no more.
void writeWatchPdf(const WatchPage& page, QIODevice& device);
void writeWatchPng(const WatchPage& page, DotsPerInch resolution, QIODevice& device);

} // namespace dipwright
