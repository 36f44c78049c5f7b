#include "workbench/widgets/NoticeBar.h"

#include "workbench/widgets/Icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QToolButton>

#include <algorithm>

namespace dipwright {

namespace {

constexpr int mostHeight = 180; // of the text, pixels; longer text scrolls

} // namespace

NoticeBar::NoticeBar(QWidget* parent)
    : QFrame(parent), sign_(new QLabel), text_(new QLabel), scroll_(new QScrollArea) {
    setObjectName(QStringLiteral("notice"));
    setAutoFillBackground(true);
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setFocusPolicy(Qt::ClickFocus);
    scroll_->setWidgetResizable(true);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll_->setWidget(text_);
    scroll_->viewport()->setAutoFillBackground(false);
    text_->setAutoFillBackground(false);
    auto* close = new QToolButton;
    close->setIcon(icon(QStringLiteral("close")));
    close->setToolTip(tr("Close this notice"));
    close->setAccessibleName(close->toolTip());
    close->setAutoRaise(true);
    connect(close, &QToolButton::clicked, this, &NoticeBar::dismiss);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->addWidget(sign_, 0, Qt::AlignTop);
    layout->addWidget(scroll_, 1);
    layout->addWidget(close, 0, Qt::AlignTop);
    hide();
}

void NoticeBar::say(const QString& text, NoticeKind kind) {
    const bool isDone = kind == NoticeKind::Done;
    sign_->setPixmap(
        icon(isDone ? QStringLiteral("done") : QStringLiteral("warning")).pixmap(18, 18));
    text_->setText(text);
    fitText();
    setVisible(!text.isEmpty());
}

void NoticeBar::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    fitText();
}

// Makes the area as tall as its text.
void NoticeBar::fitText() {
    const int words = std::max(0, text_->heightForWidth(scroll_->width())); // -1 without text
    scroll_->setVerticalScrollBarPolicy(words > mostHeight ? Qt::ScrollBarAlwaysOn
                                                           : Qt::ScrollBarAlwaysOff);
    scroll_->setFixedHeight(std::min(words, mostHeight));
}

QString NoticeBar::text() const {
    return text_->text();
}

} // namespace dipwright
