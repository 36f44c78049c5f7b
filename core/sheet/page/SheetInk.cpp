#include "sheet/page/SheetInk.h"

#include "sheet/page/PieceInk.h"
#include "sheet/pdf/InkedPages.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Sheet)
};

constexpr double rim = 0.5; // mm of white around lines and text that stand on ink

QPen whitePen(double width) {
    return {Qt::white, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
}

void enter(QPainter& painter, const SheetStrip& strip) {
    painter.translate(strip.origin);
    painter.rotate(strip.angle);
}

void paintJobLine(QPainter& painter, const SheetLayout& layout) {
    painter.save();
    enter(painter, *layout.jobLine);
    const double spare =
        layout.jobLine->size.height() - double(layout.jobLineText.size()) * jobLinePitch;
    double baseline = (spare + jobLinePitch + layout.jobLineHeight * 0.7) / 2;
    for (const QString& line : layout.jobLineText) {
        SheetInk(painter, layout.jobLine->overPaint)
            .text({0, baseline}, layout.jobLineHeight, line);
        baseline += jobLinePitch;
    }
    painter.restore();
}

} // namespace

void SheetInk::stroke(const QPainterPath& path) const {
    if (rimmed_) {
        painter_.strokePath(path, whitePen(hairline + 2 * rim));
    }
    painter_.strokePath(path, QPen(colour_, hairline, Qt::SolidLine, Qt::FlatCap));
}

void SheetInk::text(QPointF baseline, double height, const QString& text) const {
    const QFont font = sheetFont(height);
    painter_.save();
    painter_.translate(baseline);
    painter_.scale(typeUnit, typeUnit);
    if (rimmed_) {
        QPainterPath outline;
        outline.addText(QPointF(0, 0), font, text);
        painter_.strokePath(outline, whitePen(2 * rim / typeUnit));
    }
    painter_.setPen(colour_);
    painter_.setFont(font);
    painter_.drawText(QPointF(0, 0), text);
    painter_.restore();
}

void paintMark(QPainter& painter, const SheetMark& mark, bool first) {
    const SheetInk ink(painter, mark.overPaint, registrationBlack);
    const double radius = markReach * 0.6;
    const QRectF circle(mark.centre - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius));
    QPainterPath path;
    path.addEllipse(circle);
    path.moveTo(mark.centre - QPointF(markReach, 0));
    path.lineTo(mark.centre + QPointF(markReach, 0));
    path.moveTo(mark.centre - QPointF(0, markReach));
    path.lineTo(mark.centre + QPointF(0, markReach));
    ink.stroke(path);
    if (first) {
        QPainterPath quarters;
        for (int startAngle : {90, 270}) {
            quarters.moveTo(mark.centre);
            quarters.arcTo(circle, startAngle, 90);
            quarters.closeSubpath();
        }
        painter.fillPath(quarters, registrationBlack);
    }
}

void paintRuler(QPainter& painter, const SheetStrip& strip) {
    painter.save();
    enter(painter, strip);
    const SheetInk ink(painter, strip.overPaint);
    const int length = int(std::lround(strip.size.width() - 2 * rulerEndRoom));
    const double base = strip.size.height() - hairline / 2;
    QPainterPath lines;
    lines.moveTo(rulerEndRoom - hairline / 2, base);
    lines.lineTo(rulerEndRoom + length + hairline / 2, base);
    for (int mm = 0; mm <= length; ++mm) {
        const double tick = mm % 10 == 0 ? 2.6 : mm % 5 == 0 ? 1.9 : 1.2;
        lines.moveTo(rulerEndRoom + mm, base);
        lines.lineTo(rulerEndRoom + mm, base - tick);
    }
    ink.stroke(lines);
    constexpr double type = 1.6;
    const QFontMetricsF metrics(sheetFont(type));
    for (int mm = 0; mm <= length; mm += 10) {
        const QString number = QString::number(mm);
        const double half = metrics.horizontalAdvance(number) * typeUnit / 2;
        ink.text({rulerEndRoom + mm - half, base - 3.1}, type,
                 mm == length ? Text::tr("%1 mm").arg(mm) : number);
    }
    painter.restore();
}

void paintMarks(QPainter& painter, const SheetLayout& layout) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t corner = 0; corner < layout.marks.size(); ++corner) {
        paintMark(painter, layout.marks[corner], corner == 0);
    }
    for (const SheetPiece& piece : layout.pieces) {
        paintPiece(painter, piece);
    }
    if (layout.ruler) {
        paintRuler(painter, *layout.ruler);
    }
    if (layout.jobLine) {
        paintJobLine(painter, layout);
    }
    painter.restore();
}

} // namespace dipwright
