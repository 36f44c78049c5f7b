// Makes the two pages that measure a floating film: a chessboard on the film, and one on a stiff
// card that floats beside it and gives the scale.
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
    // The length that the printer prints, divided by the true length; across and along the page.
    double scaleX = 1, scaleY = 1;
    QString lot, date; // printed on the page; empty: the page has a blank line to fill in
};

// Returns the paper that fits the usual tank, mm: A4 for the film, A5 for the card.
QSizeF usualPaper(BoardKind kind);

// Size of the board and its place on the page, mm.
struct WatchBoard {
    int columns = 0, rows = 0;
    QRectF box;
};

// The least number of corners on a board with which a film can be measured. A corner is a point
// where four squares meet.
inline constexpr int leastWatchCorners = 60;
// Length of each of the two rulers on the page.
inline constexpr int watchRuler = 100; // mm

// Returns a board with as many whole squares as the paper has room for. Throws Error if it has
// fewer than leastWatchCorners.
WatchBoard watchBoard(const WatchPage& page);

// Draws the page without scale correction. The painter's unit is the millimetre, its origin the
// page's upper left corner. Needs a QGuiApplication.
void paintWatchPage(QPainter& painter, const WatchPage& page);
// Write the page so that the printer prints it at true size (scaleX, scaleY). The same page gives
// the same bytes. Both throw Error if the paper is too small or `device` cannot be written.
void writeWatchPdf(const WatchPage& page, QIODevice& device);
void writeWatchPng(const WatchPage& page, DotsPerInch resolution, QIODevice& device);

} // namespace dipwright
