#include "workbench/main/WindowMessages.h"

#include "workbench/jobs/Messages.h"
#include "workbench/main/LogPanel.h"
#include "workbench/main/WindowLayout.h"
#include "workbench/widgets/NoticeBar.h"

#include <QDir>
#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>

namespace dipwright {

WindowMessages::WindowMessages(const Messages& messages, const WindowParts& parts,
                               QMainWindow& window)
    : window_(window) {
    connect(&messages, &Messages::logged, parts.log, &LogPanel::add);
    connect(&messages, &Messages::said, window.statusBar(), &QStatusBar::showMessage);
    connect(&messages, &Messages::noticed, parts.notice,
            [notice = parts.notice](const QString& text) { notice->say(text); });
    connect(&messages, &Messages::informed, parts.notice,
            [notice = parts.notice](const QString& text) { notice->say(text, NoticeKind::Done); });
    connect(&messages, &Messages::failed, this, &WindowMessages::showFailure);
    connect(&messages, &Messages::askedToRead, this, &WindowMessages::askToRead);
}

void WindowMessages::showFailure(const QString& title, const QString& sentence) {
    auto* box = new QMessageBox(QMessageBox::Critical, title, sentence, QMessageBox::Ok, &window_);
    box->setObjectName(QStringLiteral("failure"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

void WindowMessages::askToRead(const QString& title, const QString& who, const QStringList& files,
                               const std::function<void()>& allowed) {
    constexpr qsizetype mostShown = 8;
    QStringList shown;
    for (const QString& file : files.first(std::min(files.size(), mostShown))) {
        shown << QDir::toNativeSeparators(file);
    }
    if (files.size() > mostShown) {
        shown << QStringLiteral("…");
    }
    auto* box = new QMessageBox(QMessageBox::Warning, title,
                                who + QStringLiteral("\n\n") + shown.join(u'\n'),
                                QMessageBox::Cancel, &window_);
    box->setInformativeText(tr("Read these files only if they belong to the model or project. A "
                               "model or project from someone else may refer to your private "
                               "files. These files would then be saved in the project."));
    box->setObjectName(QStringLiteral("outsideQuestion"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    const QPushButton* read = box->addButton(tr("Read files"), QMessageBox::AcceptRole);
    box->setDefaultButton(QMessageBox::Cancel);
    connect(read, &QPushButton::clicked, this, allowed);
    box->open();
}

} // namespace dipwright
