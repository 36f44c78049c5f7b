// Shows HTML with links.
#pragma once

#include <QTextBrowser>

namespace dipwright {

// A text browser whose links have the theme's colour, also after the theme has changed.
// QTextBrowser itself keeps the colour of the theme in which the text was set.
class HtmlView : public QTextBrowser {
public:
    using QTextBrowser::QTextBrowser;

    void showHtml(const QString& html);

protected:
    void changeEvent(QEvent* event) override; // keeps the place that the user reads

private:
    QString html_;
};

} // namespace dipwright
