#include "sheet/page/WatchPage.h"

#include "base/Error.h"
#include "sheet/page/DrawnPage.h"
#include "sheet/page/Sheet.h"
#include "sheet/page/SheetInk.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::WatchPage)
};

constexpr double sideRoom = 11;   // mm left and right of the board, for the upright ruler
constexpr double headHeight = 38; // mm above the board, for the text
constexpr double footHeight = 22; // mm below the board, for the horizontal ruler
constexpr double markInset = 8;   // mm from the page's edges to the corner marks
constexpr double rulerInset = 5;  // mm from the page's edge to the upright ruler

QString titleOf(const WatchPage& page) {
    return page.kind == BoardKind::Film
               ? Text::tr("Film watch: print this page on the film")
               : Text::tr("Film watch, card: print this page on stiff, waterproof cardboard");
}

QStringList wordsOf(const WatchPage& page) {
    const QString side = page.kind == BoardKind::Film
                             ? Text::tr("Ink side: lay the film on the water with this side up, so "
                                        "that you can read this text from above.")
                             : Text::tr("For every photo, lay the card flat on the water beside "
                                        "the film, with this side up.");
    const QString scale = Text::tr("Both rulers must measure %1 mm. If they do not, enter their "
                                   "measured lengths when you evaluate the photos.")
                              .arg(watchRuler);
    const QString open = QString(18, QLatin1Char('_'));
    if (page.kind == BoardKind::Card) {
        return {side, scale};
    }
    return {side, scale,
            Text::tr("Date %1   Lot %2   Water %3 °C")
                .arg(page.date.isEmpty() ? open : page.date, page.lot.isEmpty() ? open : page.lot,
                     QString(8, QLatin1Char('_')))};
}

void paintWords(QPainter& painter, const WatchPage& page) {
    const SheetInk ink(painter, false);
    const double left = markInset + 2 * markReach;
    const double room = page.paper.width() - 2 * left;
    double y = markInset + 4;
    const auto line = [&](const QString& text, double height) {
        const double natural = QFontMetricsF(sheetFont(height)).horizontalAdvance(text) * typeUnit;
        ink.text({left, y}, std::min(height, height * room / std::max(natural, 1.0)), text);
    };
    line(titleOf(page), 4.5);
    for (const QString& text : wordsOf(page)) {
        y += 6.5;
        line(text, 3);
    }
}

void paintBoard(QPainter& painter, BoardKind kind, const WatchBoard& board) {
    const double square = boardSquare(kind);
    painter.setPen(Qt::NoPen);
    for (int row = 0; row < board.rows; ++row) {
        for (int column = 0; column < board.columns; ++column) {
            const QRectF box(board.box.topLeft() + QPointF(column * square, row * square),
                             QSizeF(square, square));
            const bool black = isBlackSquare(column, row);
            if (black) {
                painter.fillRect(box, Qt::black);
            }
            if (isDottedSquare(kind, column, row)) {
                painter.setBrush(black ? Qt::white : Qt::black);
                painter.drawEllipse(box.center(), boardDot / 2 * square, boardDot / 2 * square);
            }
        }
    }
}

void paintRulers(QPainter& painter, const WatchPage& page, const WatchBoard& board) {
    const QSizeF size(watchRuler + 2 * rulerEndRoom, rulerDepth);
    paintRuler(painter, {{board.box.left(), board.box.bottom() + 6}, 0, size, false});
    // The ruler beside the board reads upwards.
    const double bottom = std::min(board.box.bottom(), page.paper.height() - markInset);
    paintRuler(painter, {{rulerInset, bottom}, -90, size, false});
}

// Throws Error if the paper is too small.
DrawnPage drawnPage(const WatchPage& page) {
    watchBoard(page);
    return {titleOf(page), page.paper, page.scaleX, page.scaleY,
            [page](QPainter& painter) { paintWatchPage(painter, page); }};
}

} // namespace

QSizeF usualPaper(BoardKind kind) {
    return kind == BoardKind::Film ? QSizeF(210, 297) : QSizeF(148, 210);
}

WatchBoard watchBoard(const WatchPage& page) {
    const double square = boardSquare(page.kind);
    WatchBoard board;
    const auto squares = [square](double room) {
        return std::min(mostBoardSquares, int(std::floor(room / square + 1e-9)));
    };
    board.columns = squares(page.paper.width() - 2 * sideRoom);
    board.rows = squares(page.paper.height() - headHeight - footHeight);
    const double rulers = watchRuler + 2 * rulerEndRoom;
    if ((board.columns - 1) * (board.rows - 1) < leastWatchCorners ||
        board.columns * square < rulers || board.rows * square < rulers) {
        throw Error(Text::tr("Paper of %1 × %2 mm is too small for a chessboard with %3 corners; "
                             "use larger paper")
                        .arg(page.paper.width())
                        .arg(page.paper.height())
                        .arg(leastWatchCorners),
                    QStringLiteral("paper"));
    }
    const QSizeF size(board.columns * square, board.rows * square);
    board.box = QRectF(QPointF((page.paper.width() - size.width()) / 2, headHeight), size);
    return board;
}

void paintWatchPage(QPainter& painter, const WatchPage& page) {
    const WatchBoard board = watchBoard(page);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    paintWords(painter, page);
    paintBoard(painter, page.kind, board);
    paintRulers(painter, page, board);
    painter.restore();
    SheetLayout marks;
    for (const double y : {markInset, page.paper.height() - markInset}) {
        for (const double x : {markInset, page.paper.width() - markInset}) {
            marks.marks.push_back({{x, y}, false});
        }
    }
    paintMarks(painter, marks);
}

void writeWatchPdf(const WatchPage& page, QIODevice& device) {
    writeDrawnPdf(drawnPage(page), device);
}

void writeWatchPng(const WatchPage& page, DotsPerInch resolution, QIODevice& device) {
    writeDrawnPng(drawnPage(page), resolution, device);
}

} // namespace dipwright
