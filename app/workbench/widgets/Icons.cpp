#include "workbench/widgets/Icons.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QSvgRenderer>

namespace dipwright {

namespace {

// Replaces each colour in an icon's file by the palette's colour for the same role.
QByteArray recoloured(QByteArray svg, QIcon::Mode mode) {
    const QPalette palette = QGuiApplication::palette();
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    const bool disabled = mode == QIcon::Disabled;
    const QColor text = palette.color(group, mode == QIcon::Selected ? QPalette::HighlightedText
                                                                     : QPalette::ButtonText);
    const bool dark = palette.color(QPalette::Window).lightness() < 128;
    const auto put = [&svg](const char* drawn, const QColor& shown) {
        svg.replace(drawn, shown.name().toLatin1());
    };
    put("#20242a", text);
    put("#0a6ebd", disabled                  ? text
                   : mode == QIcon::Selected ? text
                                             : palette.color(QPalette::Link));
    put("#c6372f", disabled ? text : dark ? QColor(0xf0, 0x6a, 0x60) : QColor(0xc6, 0x37, 0x2f));
    const bool selected = mode == QIcon::Selected;
    put("#b86e00", disabled           ? text
                   : dark || selected ? QColor(0xff, 0xc4, 0x5e)
                                      : QColor(0xb8, 0x6e, 0x00));
    put("#2c7d3c", disabled ? text : dark ? QColor(0x5c, 0xbf, 0x70) : QColor(0x2c, 0x7d, 0x3c));
    return svg;
}

class SvgIconEngine : public QIconEngine {
public:
    explicit SvgIconEngine(const QByteArray& svg) : svg_(svg) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        QSvgRenderer renderer(recoloured(svg_, mode));
        const int side = std::min(rect.width(), rect.height());
        const QRect square(rect.x() + (rect.width() - side) / 2,
                           rect.y() + (rect.height() - side) / 2, side, side);
        renderer.render(painter, square);
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return pixmap;
    }
    QIconEngine* clone() const override { return new SvgIconEngine(svg_); }

private:
    QByteArray svg_;
};

} // namespace

QIcon icon(const QString& name) {
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    if (!file.open(QIODevice::ReadOnly)) {
        qFatal("There is no icon %s", qUtf8Printable(name));
    }
    return QIcon(new SvgIconEngine(file.readAll()));
}

} // namespace dipwright
