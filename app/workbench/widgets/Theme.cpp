#include "workbench/widgets/Theme.h"

#include "workbench/widgets/Icons.h"

#include <QApplication>
#include <QPainter>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QStyleOption>

namespace dipwright {

namespace {

// Fusion, adapted to habits of current desktop programs.
class WorkbenchStyle : public QProxyStyle {
public:
    WorkbenchStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* data) const override {
        if (hint == SH_DialogButtonBox_ButtonsHaveIcons) {
            return 0;
        }
        return QProxyStyle::styleHint(hint, option, widget, data);
    }
    int pixelMetric(PixelMetric metric, const QStyleOption* option,
                    const QWidget* widget) const override {
        constexpr int roomInTabs = 14; // fits five tabs side by side in a dock, in any language
        return metric == PM_TabBarTabHSpace ? roomInTabs
                                            : QProxyStyle::pixelMetric(metric, option, widget);
    }
    // Message boxes use our own icons.
    QIcon standardIcon(StandardPixmap sign, const QStyleOption* option,
                       const QWidget* widget) const override {
        switch (sign) {
        case SP_MessageBoxQuestion:
        case SP_MessageBoxInformation:
            return icon(QStringLiteral("help"));
        case SP_MessageBoxWarning:
        case SP_MessageBoxCritical:
            return icon(QStringLiteral("warning"));
        default:
            return QProxyStyle::standardIcon(sign, option, widget);
        }
    }
    // Fusion's own outlines are hardly visible on a dark window.
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        const bool box = element == PE_IndicatorCheckBox;
        const bool dot = element == PE_IndicatorRadioButton;
        if ((!box && !dot) || !isDark()) {
            return;
        }
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(QPen(option->palette.color(QPalette::PlaceholderText), 1));
        painter->setBrush(Qt::NoBrush);
        const QRectF frame = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
        box ? painter->drawRect(frame) : painter->drawEllipse(frame);
        painter->restore();
    }
};

struct Colours {
    QColor window, base, alternate, text, faint, button, link, highlight, highlightedText, middle;
};

Colours coloursOf(bool dark) {
    if (dark) {
        return {0x30343b, 0x1d2025, 0x23272c, 0xe6e8eb, 0xa8afb9,
                0x363a42, 0x6cb6f5, 0x1f6fb2, 0xffffff, 0x4a4f58};
    }
    return {0xf2f3f5, 0xffffff, 0xf6f8fa, 0x1b1f24, 0x5c6570,
            0xfafbfc, 0x0a62a9, 0x0b67b2, 0xffffff, 0xc3c8d0};
}

} // namespace

QPalette themePalette(bool dark) {
    const Colours c = coloursOf(dark);
    QPalette palette(c.button, c.window);
    palette.setColor(QPalette::Window, c.window);
    palette.setColor(QPalette::WindowText, c.text);
    palette.setColor(QPalette::Base, c.base);
    palette.setColor(QPalette::AlternateBase, c.alternate);
    palette.setColor(QPalette::Text, c.text);
    palette.setColor(QPalette::PlaceholderText, c.faint);
    palette.setColor(QPalette::Button, c.button);
    palette.setColor(QPalette::ButtonText, c.text);
    palette.setColor(QPalette::BrightText, Qt::white);
    palette.setColor(QPalette::Link, c.link);
    palette.setColor(QPalette::LinkVisited, c.link);
    palette.setColor(QPalette::Highlight, c.highlight);
    palette.setColor(QPalette::HighlightedText, c.highlightedText);
    palette.setColor(QPalette::ToolTipBase, c.base);
    palette.setColor(QPalette::ToolTipText, c.text);
    palette.setColor(QPalette::Mid, c.middle);
    palette.setColor(QPalette::Midlight, dark ? c.middle.darker(115) : c.middle.lighter(108));
    palette.setColor(QPalette::Light, dark ? QColor(0x383d45) : QColor(Qt::white));
    palette.setColor(QPalette::Dark, dark ? QColor(0x17191d) : QColor(0x9aa1ab));
    palette.setColor(QPalette::Shadow, dark ? QColor(0x0f1114) : QColor(0x7b828c));
    for (const QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText}) {
        palette.setColor(QPalette::Disabled, role, dark ? QColor(0x7b828c) : QColor(0x8b929c));
    }
    palette.setColor(QPalette::Disabled, QPalette::Highlight, c.middle);
    return palette;
}

void applyTheme(QApplication& application, Theme theme) {
    static const bool desktopIsDark = isDark(); // read before our palette is set
    application.setStyle(new WorkbenchStyle);   // NOLINT: it is the application's own now
    application.setPalette(
        themePalette(theme == Theme::Dark || (theme == Theme::System && desktopIsDark)));
}

bool isDark() {
    return QGuiApplication::palette().color(QPalette::Window).lightness() < 128;
}

} // namespace dipwright
