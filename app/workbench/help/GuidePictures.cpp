#include "workbench/help/GuidePictures.h"

#include "sheet/page/WatchPage.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>

#include <array>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::GuidePictures)
};

// All pictures are drawn in units of 1/100 of their width.
const QSizeF size(100, 46);
const QColor paper(Qt::white), ink(40, 44, 50), soft(120, 128, 136), water(196, 222, 240),
    deep(150, 192, 222), filmColour(232, 150, 70), cardColour(90, 96, 104),
    accent(0x12, 0x8c, 0xe8);

void letter(QPainter& painter, const QRectF& box, const QString& text, int alignment,
            const QColor& colour = ink, double height = 2.1) {
    constexpr double unit = 0.05; // a QFont has no sizes below a whole unit
    painter.save();
    painter.translate(box.topLeft());
    painter.scale(unit, unit);
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(int(height / unit));
    painter.setFont(font);
    painter.setPen(colour);
    painter.drawText(QRectF(QPointF(), box.size() / unit), alignment | Qt::TextWordWrap, text);
    painter.restore();
}

void line(QPainter& painter, const QColor& colour, double width, const QPointF& from,
          const QPointF& to) {
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(from, to);
}

void arrow(QPainter& painter, const QPointF& from, const QPointF& to) {
    line(painter, soft, 0.3, from, to);
    const QPointF along = (to - from) / std::hypot((to - from).x(), (to - from).y());
    const QPointF across(-along.y(), along.x());
    painter.setBrush(soft);
    painter.drawPolygon(
        QPolygonF{to, to - 1.4 * along + 0.6 * across, to - 1.4 * along - 0.6 * across});
    painter.setBrush(Qt::NoBrush);
}

// Draws a printed page. `at`: the middle of its left edge.
QRectF drawPage(QPainter& painter, BoardKind kind, const QSizeF& paperSize, const QPointF& at,
                double height) {
    WatchPage page;
    page.kind = kind;
    page.paper = paperSize;
    const double scale = height / paperSize.height();
    const QRectF box(at - QPointF(0, height / 2), paperSize * scale);
    painter.fillRect(box, paper);
    painter.save();
    painter.translate(box.topLeft());
    painter.scale(scale, scale);
    paintWatchPage(painter, page);
    painter.restore();
    painter.setPen(QPen(soft, 0.2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(box);
    return box;
}

void drawPages(QPainter& painter) {
    const QRectF film = drawPage(painter, BoardKind::Film, {210, 297}, {4, 23}, 42);
    const QRectF card = drawPage(painter, BoardKind::Card, {148, 210}, {58, 23 + 21 - 14.9}, 29.7);
    letter(painter, {film.right() + 1.5, 4, 20, 12}, Text::tr("film.pdf\nprinted on the film"),
           Qt::AlignLeft);
    letter(painter, {card.left(), 4, 40, 9},
           Text::tr("card.pdf\nprinted on stiff, waterproof cardboard"), Qt::AlignLeft);
    letter(painter, {film.right() + 1.5, 24, 20, 18},
           Text::tr("The rulers on both must measure 100 mm"), Qt::AlignLeft | Qt::AlignTop,
           accent);
}

// Draws the tank from the side, with film and card on the water.
void drawWater(QPainter& painter) {
    constexpr double level = 22, left = 10, right = 90, bottom = 40;
    painter.fillRect(QRectF(left, level, right - left, bottom - level), water);
    painter.fillRect(QRectF(left, level + 10, right - left, bottom - level - 10), deep);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(ink, 0.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(QPolygonF{{left, 14}, {left, bottom}, {right, bottom}, {right, 14}});
    painter.setPen(Qt::NoPen);
    painter.setBrush(filmColour);
    painter.drawRect(QRectF(18, level - 0.7, 38, 0.7));
    painter.setBrush(cardColour);
    painter.drawRect(QRectF(64, level - 0.7, 18, 1.8));
    for (int i = 0; i < 9; ++i) { // the ink on top of film and card
        painter.setBrush(ink);
        painter.drawRect(QRectF(19 + 4.2 * i, level - 1.1, 2.1, 0.4));
        if (i < 4) {
            painter.drawRect(QRectF(65 + 4.4 * i, level - 1.1, 2.2, 0.4));
        }
    }
    letter(painter, {12, 4.5, 48, 6}, Text::tr("The film, ink side up, as for a dip"),
           Qt::AlignHCenter | Qt::AlignTop);
    arrow(painter, {37, 11}, {37, level - 2});
    letter(painter, {61, 4.5, 30, 6}, Text::tr("The card beside it, flat"),
           Qt::AlignHCenter | Qt::AlignTop);
    arrow(painter, {73, 11}, {73, level - 2});
    line(painter, accent, 0.25, {14, level - 0.9}, {86, level - 0.9});
    letter(painter, {14, 25, 72, 6}, Text::tr("Both at the same height: the card gives the scale"),
           Qt::AlignHCenter | Qt::AlignTop, accent);
    letter(painter, {14, 33, 72, 5}, Text::tr("Note the time when you lay the film"),
           Qt::AlignHCenter | Qt::AlignTop);
}

void drawCamera(QPainter& painter, const QPointF& lens) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    painter.drawRoundedRect(QRectF(lens.x() - 5, lens.y() - 7, 10, 5), 0.8, 0.8);
    painter.drawRect(QRectF(lens.x() - 1.8, lens.y() - 2, 3.6, 2));
    painter.setBrush(accent);
    painter.drawRect(QRectF(lens.x() - 1.4, lens.y() - 0.5, 2.8, 0.5));
}

// Draws one photo. `grown`: size of the film relative to the first photo.
void drawFrame(QPainter& painter, const QRectF& frame, double grown, const QString& when) {
    painter.fillRect(frame, water);
    painter.save();
    painter.setClipRect(frame);
    painter.translate(frame.left() + 0.34 * frame.width(), frame.center().y());
    painter.rotate(-4);
    painter.scale(grown, grown);
    const double height = 0.6 * frame.height();
    drawPage(painter, BoardKind::Film, {210, 297}, {-height * 105 / 297, 0}, height);
    painter.restore();
    painter.save();
    painter.setClipRect(frame);
    painter.translate(frame.left() + 0.82 * frame.width(), frame.center().y());
    painter.rotate(7);
    drawPage(painter, BoardKind::Card, {148, 210}, {-0.32 * frame.height() * 74 / 210, 0},
             0.32 * frame.height());
    painter.restore();
    painter.setPen(QPen(ink, 0.4));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(frame);
    letter(painter, {frame.left(), frame.bottom() + 0.8, frame.width(), 4}, when,
           Qt::AlignHCenter | Qt::AlignTop);
}

// Draws the camera above film and card, and its photos.
void drawPhotos(QPainter& painter) {
    const QPointF lens(17, 14);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0x12, 0x8c, 0xe8, 40));
    painter.drawPolygon(QPolygonF{lens, {3, 34}, {31, 34}});
    drawCamera(painter, lens);
    painter.fillRect(QRectF(2, 34.6, 30, 5), water);
    line(painter, filmColour, 0.7, {5, 34.4}, {19, 34.4});
    line(painter, cardColour, 1.2, {22, 34.4}, {29, 34.4});
    letter(painter, {1, 40.3, 32, 5.5}, Text::tr("From above, both whole, no glare"),
           Qt::AlignHCenter | Qt::AlignTop, ink, 1.9);
    const std::array<double, 3> grown{1, 1.06, 1.1};
    const std::array<int, 3> seconds{60, 90, 150};
    for (std::size_t i = 0; i < grown.size(); ++i) {
        drawFrame(painter, {36.0 + 21.2 * double(i), 8, 20, 24}, grown[i],
                  Text::tr("%1 s").arg(seconds[i]));
    }
    letter(painter, {36, 1.5, 62, 6},
           Text::tr("One photo gives the swell, three or more give the growth"),
           Qt::AlignHCenter | Qt::AlignTop);
    letter(painter, {36, 38, 62, 7},
           Text::tr("Take photos before the dip and until the film stops growing"),
           Qt::AlignHCenter | Qt::AlignTop, accent);
}

} // namespace

QStringList guidePictures() {
    return {QStringLiteral("tank-pages"), QStringLiteral("tank-water"),
            QStringLiteral("tank-photos")};
}

QImage guidePicture(const QString& name, int width) {
    const double unit = width / size.width();
    QImage picture((size * unit).toSize(), QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.scale(unit, unit);
    painter.setPen(Qt::NoPen);
    painter.setBrush(paper);
    painter.drawRoundedRect(QRectF(QPointF(), size), 1.5, 1.5); // light also in a dark guide
    painter.setBrush(Qt::NoBrush);
    if (name == guidePictures()[0]) {
        drawPages(painter);
    } else if (name == guidePictures()[1]) {
        drawWater(painter);
    } else {
        drawPhotos(painter);
    }
    return picture;
}

} // namespace dipwright
