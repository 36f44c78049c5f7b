#include "workbench/help/Tour.h"

#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

namespace dipwright {

Tour::Tour(const std::vector<TourStep>& steps, QWidget* parent)
    : QWidget(parent), steps_(steps), bubble_(new QFrame(this)), title_(new QLabel),
      text_(new QLabel), count_(new QLabel), back_(new QPushButton(tr("Back"))),
      next_(new QPushButton) {
    setObjectName(QStringLiteral("tour"));
    setAttribute(Qt::WA_DeleteOnClose);
    setFocusPolicy(Qt::StrongFocus);
    bubble_->setAutoFillBackground(true);
    static_cast<QFrame*>(bubble_)->setFrameShape(QFrame::StyledPanel);
    bubble_->setFixedWidth(380);
    QFont bold = title_->font();
    bold.setBold(true);
    bold.setPointSizeF(bold.pointSizeF() * 1.2);
    title_->setFont(bold);
    title_->setWordWrap(true);
    text_->setWordWrap(true);
    count_->setForegroundRole(QPalette::PlaceholderText);
    auto* skip = new QPushButton(tr("Close"));
    next_->setDefault(true);
    auto* row = new QHBoxLayout;
    row->addWidget(count_);
    row->addStretch();
    row->addWidget(skip);
    row->addWidget(back_);
    row->addWidget(next_);
    auto* layout = new QVBoxLayout(bubble_);
    layout->setContentsMargins(16, 14, 16, 12);
    layout->setSpacing(10);
    layout->addWidget(title_);
    layout->addWidget(text_);
    layout->addLayout(row);
    connect(skip, &QPushButton::clicked, this, &QWidget::close);
    connect(back_, &QPushButton::clicked, this, [this] { show(step_ - 1); });
    connect(next_, &QPushButton::clicked, this, [this] {
        if (step_ + 1 == steps_.size()) {
            close();
        } else {
            show(step_ + 1);
        }
    });
    parent->installEventFilter(this);
    setGeometry(parent->rect());
    QWidget::show();
    raise();
    show(0);
    next_->setFocus();
}

void Tour::show(std::size_t step) {
    step_ = step;
    title_->setText(steps_[step].title);
    text_->setText(steps_[step].text);
    count_->setText(tr("%1 of %2").arg(step + 1).arg(steps_.size()));
    back_->setEnabled(step > 0);
    next_->setText(step + 1 == steps_.size() ? tr("Done") : tr("Next"));
    place();
}

QRect Tour::targetRect() const {
    const QWidget* target = steps_[step_].target;
    if (!target || !target->isVisible()) {
        return {};
    }
    return QRect(target->mapTo(parentWidget(), QPoint()), target->size()).intersected(rect());
}

// Places the bubble beside the target if there is room, else in the middle of the window.
void Tour::place() {
    bubble_->adjustSize();
    const QRect target = targetRect();
    const QSize size = bubble_->size();
    QPoint corner((width() - size.width()) / 2, (height() - size.height()) / 2);
    constexpr int gap = 14;
    if (!target.isNull()) {
        if (target.right() + gap + size.width() < width()) {
            corner = {target.right() + gap, target.top() + gap};
        } else if (target.left() - gap - size.width() > 0) {
            corner = {target.left() - gap - size.width(), target.top() + gap};
        } else if (target.bottom() + gap + size.height() < height()) {
            corner = {target.left() + gap, target.bottom() + gap};
        }
    }
    corner.setX(std::clamp(corner.x(), gap, std::max(gap, width() - size.width() - gap)));
    corner.setY(std::clamp(corner.y(), gap, std::max(gap, height() - size.height() - gap)));
    bubble_->move(corner);
    update();
}

void Tour::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setClipRegion(QRegion(rect()) - QRegion(targetRect()));
    painter.fillRect(rect(), QColor(0, 0, 0, 120));
    painter.setClipping(false);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 3));
    painter.drawRect(targetRect().adjusted(1, 1, -2, -2));
}

void Tour::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        close();
    }
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) {
        setGeometry(parentWidget()->rect());
        place();
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace dipwright
