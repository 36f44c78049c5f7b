#include "workbench/widgets/NoticeBar.h"

#include "workbench/widgets/Icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace dipwright {

NoticeBar::NoticeBar(QWidget* parent) : QFrame(parent), text_(new QLabel) {
    setObjectName(QStringLiteral("notice"));
    setAutoFillBackground(true);
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* sign = new QLabel;
    sign->setPixmap(icon(QStringLiteral("warning")).pixmap(18, 18));
    auto* close = new QToolButton;
    close->setText(tr("Close"));
    close->setToolTip(tr("Close this notice"));
    close->setAutoRaise(true);
    connect(close, &QToolButton::clicked, this, &NoticeBar::dismiss);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->addWidget(sign);
    layout->addWidget(text_, 1);
    layout->addWidget(close);
    hide();
}

void NoticeBar::say(const QString& text) {
    text_->setText(text);
    setVisible(!text.isEmpty());
}

QString NoticeBar::text() const {
    return text_->text();
}

} // namespace dipwright
