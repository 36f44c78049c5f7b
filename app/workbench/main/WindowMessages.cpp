#include "main/WindowMessages.h"

#include "main/WindowLayout.h"
#include "panels/LogPanel.h"
#include "panels/NoticeBar.h"
#include "session/Messages.h"

#include <QMainWindow>
#include <QMessageBox>
#include <QStatusBar>

namespace dipwright {

WindowMessages::WindowMessages(const Messages& messages, const WindowParts& parts,
                               QMainWindow& window)
    : window_(window) {
    connect(&messages, &Messages::logged, parts.log, &LogPanel::add);
    connect(&messages, &Messages::said, window.statusBar(), &QStatusBar::showMessage);
    connect(&messages, &Messages::noticed, parts.notice, &NoticeBar::say);
    connect(&messages, &Messages::failed, this, &WindowMessages::showFailure);
}

void WindowMessages::showFailure(const QString& title, const QString& sentence) {
    auto* box = new QMessageBox(QMessageBox::Critical, title, sentence, QMessageBox::Ok, &window_);
    box->setObjectName(QStringLiteral("failure"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

} // namespace dipwright
