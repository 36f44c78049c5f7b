#include "workbench/widgets/HtmlView.h"

#include <QEvent>
#include <QScrollBar>

namespace dipwright {

void HtmlView::showHtml(const QString& html) {
    html_ = html;
    render();
}

void HtmlView::render() {
    document()->setDefaultStyleSheet(
        QStringLiteral("a { color: %1 }").arg(palette().color(QPalette::Link).name()));
    setHtml(html_);
}

void HtmlView::changeEvent(QEvent* event) {
    QTextBrowser::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && !html_.isEmpty()) {
        const int place = verticalScrollBar()->value();
        render();
        verticalScrollBar()->setValue(place);
    }
}

} // namespace dipwright
