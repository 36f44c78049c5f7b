#include "workbench/main/JobIndicator.h"

#include "workbench/jobs/JobRunner.h"
#include "workbench/jobs/TimeLeft.h"

#include <QAction>
#include <QLabel>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolButton>

namespace dipwright {

namespace {

constexpr int progressSteps = 1000;

} // namespace

JobIndicator::JobIndicator(QStatusBar& bar, const JobRunner& jobs, QAction& cancel,
                           const QString& name, int width)
    : QObject(&bar), text_(new QLabel) {
    auto* progress = new QProgressBar;
    progress->setObjectName(name);
    progress->setAccessibleName(tr("Progress"));
    progress->setRange(0, progressSteps);
    progress->setFixedWidth(width);
    progress->setTextVisible(false);
    auto* timeLeft = new QLabel;
    timeLeft->setToolTip(tr("Estimated from the progress of the job."));
    auto* button = new QToolButton;
    button->setDefaultAction(&cancel);
    button->setAutoRaise(true);
    widgets_ = {text_, progress, timeLeft, button};
    const auto setVisible = [this](bool visible) {
        for (QWidget* widget : widgets_) {
            widget->setVisible(visible);
        }
    };
    for (QWidget* widget : widgets_) {
        bar.addPermanentWidget(widget);
    }
    setVisible(false);
    connect(new TimeLeft(jobs, this), &TimeLeft::told, timeLeft, &QLabel::setText);
    connect(&jobs, &JobRunner::busy, this, [setVisible] { setVisible(true); });
    connect(&jobs, &JobRunner::idle, this, [setVisible] { setVisible(false); });
    connect(&jobs, &JobRunner::started, this, [this, progress](const QString& title) {
        setText(title);
        progress->setValue(0);
    });
    connect(&jobs, &JobRunner::progressed, this,
            [this, progress](double share, const QString& text) {
                progress->setValue(int(share * progressSteps));
                setText(text);
            });
}

void JobIndicator::setText(const QString& text) {
    text_->setText(text);
}

} // namespace dipwright
