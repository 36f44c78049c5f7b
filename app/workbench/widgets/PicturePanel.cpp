#include "workbench/widgets/PicturePanel.h"

#include "workbench/widgets/Icons.h"

#include <QAction>
#include <QLabel>
#include <QScreen>
#include <QToolBar>
#include <QVBoxLayout>

namespace dipwright {

PicturePanel::PicturePanel(const QString& name, const QString& hint, QWidget* parent)
    : QWidget(parent), hint_(hint), view_(new PictureView), bar_(new QToolBar),
      zoomLabel_(new QLabel), legend_(new QLabel) {
    view_->setAccessibleName(name);
    bar_->setIconSize({18, 18});
    zoomButtons_ = {bar_->addAction(icon(QStringLiteral("fit")), tr("Whole picture"), view_,
                                    &PictureView::zoomToFit),
                    bar_->addAction(icon(QStringLiteral("zoom-in")), tr("Zoom in"), this,
                                    [this] { view_->zoomBy(1.25); }),
                    bar_->addAction(icon(QStringLiteral("zoom-out")), tr("Zoom out"), this,
                                    [this] { view_->zoomBy(0.8); })};
    for (QAction* button : zoomButtons_) {
        takeFocus(button);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(bar_);
    layout->addWidget(view_, 1);
    layout->addWidget(legend_);
    legend_->setTextFormat(Qt::RichText);
    legend_->setContentsMargins(8, 4, 8, 4);
    legend_->hide();
    zoomLabel_->setContentsMargins(6, 0, 6, 0);
    connect(view_, &PictureView::zoomChanged, this, [this] {
        const double trueSize = view_->screen()->physicalDotsPerInch() / 25.4;
        zoomLabel_->setText(
            view_->isEmpty() ? QString() : tr("%1 %").arg(qRound(view_->zoom() / trueSize * 100)));
    });
    clear();
}

void PicturePanel::setPicture(const QImage& picture, QSizeF millimetres) {
    view_->setPicture(picture, millimetres);
    for (QAction* button : zoomButtons_) {
        button->setEnabled(true);
    }
    emit view_->zoomChanged();
}

void PicturePanel::clear() {
    view_->clear(hint_);
    zoomLabel_->clear();
    setLegend({});
    for (QAction* button : zoomButtons_) {
        button->setEnabled(false);
    }
}

void PicturePanel::setLegend(const QString& text) {
    legend_->setText(text);
    legend_->setVisible(!text.isEmpty());
}

void PicturePanel::addButton(QAction* action) {
    bar_->addSeparator();
    bar_->addAction(action);
    takeFocus(action);
}

void PicturePanel::offerTrueSize() {
    zoomButtons_ << bar_->addAction(icon(QStringLiteral("true-size")), tr("True size"), view_,
                                    &PictureView::zoomToTrueSize);
    takeFocus(zoomButtons_.last());
    zoomButtons_.last()->setEnabled(!view_->isEmpty());
    bar_->addWidget(zoomLabel_);
}

// The panel's buttons take the focus, because they are in no menu. The buttons of the window's tool
// bars are.
void PicturePanel::takeFocus(QAction* action) {
    bar_->widgetForAction(action)->setFocusPolicy(Qt::TabFocus);
}

} // namespace dipwright
