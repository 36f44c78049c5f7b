#include "sheet/page/PieceInk.h"

#include "sheet/page/PrintableText.h"
#include "sheet/page/QrCode.h"
#include "sheet/page/SheetInk.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Sheet)
};

constexpr double markOff = 3.5; // mm from the printed box's edges to a mark's centre
constexpr double codeSide = 11; // side of the QR code, mm
constexpr double type = 2.2, lineHeight = 3.4;
constexpr double tick = 3; // length of a tick, mm

QRectF grown(const QRectF& box, double by) {
    return box.adjusted(-by, -by, by, by);
}

// Returns the box of the picture, its cut contour and the bleed past it.
QRectF printedBox(const SheetPiece& piece) {
    return grown(piece.picture, piece.cutReach);
}

void paintMarksOf(QPainter& painter, const SheetPiece& piece) {
    const QRectF centres = grown(printedBox(piece), markOff);
    bool first = true;
    for (const QPointF& corner :
         {centres.topLeft(), centres.topRight(), centres.bottomLeft(), centres.bottomRight()}) {
        paintMark(painter, {corner}, first);
        first = false;
    }
}

// Draws ticks beside the printed box that show the centre of the job's own film. The body's offset
// refers to that centre. Draws no tick where the centre lies outside the box.
void paintCentreTicks(QPainter& painter, const SheetPiece& piece) {
    const QRectF box = printedBox(piece);
    const QPointF& middle = piece.middle;
    QPainterPath ticks;
    const auto line = [&](QPointF from, QPointF along) {
        ticks.moveTo(from);
        ticks.lineTo(from + along);
    };
    if (middle.x() > box.left() && middle.x() < box.right()) {
        line({middle.x(), box.top() - 1}, {0, -tick});
        line({middle.x(), box.bottom() + 1}, {0, tick});
    }
    if (middle.y() > box.top() && middle.y() < box.bottom()) {
        line({box.left() - 1, middle.y()}, {-tick, 0});
        line({box.right() + 1, middle.y()}, {tick, 0});
    }
    SheetInk(painter, false).stroke(ticks);
}

void paintLine(QPainter& painter, QPointF baseline, double width, const QString& text) {
    const QFontMetricsF metrics(sheetFont(type));
    SheetInk(painter, false)
        .text(baseline, type, metrics.elidedText(text, Qt::ElideRight, width / typeUnit));
}

void paintFoot(QPainter& painter, const SheetPiece& piece) {
    const QRectF foot(1, piece.size.height() - pieceFoot, piece.size.width() - 2, pieceFoot - 1);
    paintQrCode(painter, {foot.topLeft(), QSizeF(codeSide, codeSide)}, pieceCode(piece));
    const JobLine& job = piece.job;
    const QFont font = sheetFont(type);
    const QString lines[]{
        Text::tr("Job %1").arg(job.hash.simplified()),
        Text::tr("Dip %1, copy %2 of %3").arg(piece.dip).arg(piece.copy).arg(piece.copies),
        Text::tr("%1 · %2 · %3 · Film %4 · Scale %5")
            .arg(printableText(job.project.simplified(), font),
                 printableText(job.immersion.simplified(), font), job.date.simplified(),
                 printableText(job.film.simplified(), font), job.scale.simplified())};
    const QPointF start = foot.topLeft() + QPointF(codeSide + 1, lineHeight - 0.4);
    for (int line = 0; line < 3; ++line) {
        paintLine(painter, start + QPointF(0, line * lineHeight), foot.right() - start.x(),
                  lines[line]);
    }
}

// Draws lines outside the corners of a whole sheet, and between it and the next the job's number.
void paintCutMarks(QPainter& painter, const SheetPiece& piece) {
    constexpr double off = 0.5; // mm from the corner, so that no line is on the sheet
    const double length = std::min(tick, piece.gap - off);
    const QRectF box({0, 0}, piece.size);
    QPainterPath marks;
    for (const QPointF& corner :
         {box.topLeft(), box.topRight(), box.bottomLeft(), box.bottomRight()}) {
        const QPointF away(corner.x() > 0 ? 1 : -1, corner.y() > 0 ? 1 : -1);
        for (const QPointF& way : {QPointF(away.x(), 0), QPointF(0, away.y())}) {
            marks.moveTo(corner + way * off);
            marks.lineTo(corner + way * (off + length));
        }
    }
    SheetInk(painter, false).stroke(marks);
    if (piece.gap >= lineHeight + off) {
        const double left = tick; // beside the mark at the corner
        paintLine(painter, {left, piece.size.height() + lineHeight}, piece.size.width() - 2 * left,
                  Text::tr("Job %1 · %2 · copy %3 of %4")
                      .arg(piece.job.hash.simplified(), nameOnPaper(piece.job.immersion))
                      .arg(piece.copy)
                      .arg(piece.copies));
    }
}

void paintCutLine(QPainter& painter, const SheetPiece& piece) {
    painter.setPen(QPen(Qt::black, hairline, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF({0, 0}, piece.size));
}

} // namespace

QString pieceCode(const SheetPiece& piece) {
    return QStringLiteral("%1/%2/%3").arg(piece.job.hash).arg(piece.dip).arg(piece.copy);
}

void paintPiece(QPainter& painter, const SheetPiece& piece) {
    painter.save();
    painter.translate(piece.corner);
    if (piece.turned) {
        painter.translate(piece.size.height(), 0);
        painter.rotate(90);
    }
    if (piece.whole) {
        paintMarks(painter, *piece.whole);
        if (piece.gap >= leastCutGap) {
            paintCutMarks(painter, piece);
        } else {
            paintCutLine(painter, piece);
        }
        painter.restore();
        return;
    }
    paintCutLine(painter, piece);
    if (piece.marks) {
        paintMarksOf(painter, piece);
        paintCentreTicks(painter, piece);
    }
    if (piece.jobLine) {
        paintFoot(painter, piece);
    }
    painter.restore();
}

} // namespace dipwright
