#include "workbench/main/StatusLine.h"

#include "workbench/jobs/JobRunner.h"
#include "workbench/main/JobIndicator.h"
#include "workbench/widgets/Icons.h"

#include <QAction>
#include <QLabel>
#include <QStatusBar>
#include <QToolButton>

namespace dipwright {

namespace {

constexpr int jobWidth = 200, saveWidth = 100; // of the progress bars, in pixels
constexpr std::chrono::seconds answerTime{15}; // time for a cancelled job to end

} // namespace

StatusLine::StatusLine(QStatusBar& bar, const JobRunner& jobs, QAction& cancel,
                       const JobRunner& saves)
    : QObject(&bar), reading_(new QLabel), warning_(new QToolButton) {
    addReading(bar);
    addSaves(bar, saves);
    job_ = new JobIndicator(bar, jobs, cancel, QStringLiteral("progress"), jobWidth);
    unanswered_.setSingleShot(true);
    unanswered_.setInterval(answerTime);
    connect(&cancel, &QAction::triggered, &unanswered_, qOverload<>(&QTimer::start));
    connect(&jobs, &JobRunner::started, &unanswered_, &QTimer::stop);
    connect(&jobs, &JobRunner::idle, &unanswered_, &QTimer::stop);
    connect(&unanswered_, &QTimer::timeout, this, [this] {
        job_->setText(
            tr("The job does not respond. Save your work, then close the window to end the job."));
    });
}

void StatusLine::addReading(QStatusBar& bar) {
    reading_->setObjectName(QStringLiteral("reading"));
    reading_->setAccessibleName(tr("Value under the cursor"));
    reading_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    warning_->setObjectName(QStringLiteral("placeWarning"));
    warning_->setAccessibleName(tr("Warning"));
    warning_->setIcon(icon(QStringLiteral("warning")));
    warning_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    warning_->setAutoRaise(true);
    connect(warning_, &QToolButton::clicked, this, &StatusLine::warningClicked);
    warning_->hide();
    bar.addWidget(reading_, 1);
    bar.addPermanentWidget(warning_);
}

void StatusLine::addSaves(QStatusBar& bar, const JobRunner& saves) {
    auto* cancel = new QAction(icon(QStringLiteral("cancel")), tr("Cancel saving"), this);
    cancel->setObjectName(QStringLiteral("cancelSave"));
    cancel->setToolTip(tr("Cancel saving. The file stays as it was."));
    connect(cancel, &QAction::triggered, this, &StatusLine::saveCancelled);
    new JobIndicator(bar, saves, *cancel, QStringLiteral("saveProgress"), saveWidth);
}

void StatusLine::setReading(const QString& text) {
    reading_->setText(text);
}

void StatusLine::setWarning(const QString& text) {
    // The tooltip has the whole text, which the bar may be too narrow for.
    warning_->setText(text.section(QLatin1Char(';'), 0, 0));
    warning_->setToolTip(text);
    warning_->setVisible(!text.isEmpty());
}

void StatusLine::setJob(const QString& text) {
    job_->setText(text);
}

} // namespace dipwright
