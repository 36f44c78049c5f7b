#include "workbench/widgets/HtmlView.h"

#include <QEvent>
#include <QScrollBar>

namespace dipwright {

void HtmlView::showHtml(const QString& html) {
    html_ = html;
    setHtml(html);
}

void HtmlView::changeEvent(QEvent* event) {
    QTextBrowser::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && !html_.isEmpty()) {
        const int place = verticalScrollBar()->value();
        setHtml(html_);
        verticalScrollBar()->setValue(place);
    }
}

} // namespace dipwright
