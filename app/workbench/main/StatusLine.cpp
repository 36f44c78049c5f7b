#include "workbench/main/StatusLine.h"

#include "workbench/jobs/JobRunner.h"
#include "workbench/jobs/TimeLeft.h"
#include "workbench/widgets/Icons.h"

#include <QAction>
#include <QLabel>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolButton>

namespace dipwright {

namespace {

constexpr int progressSteps = 1000;
constexpr std::chrono::seconds answerTime{15}; // time for a cancelled job to end

} // namespace

StatusLine::StatusLine(QStatusBar& bar, const JobRunner& jobs, QAction& cancel)
    : QObject(&bar), reading_(new QLabel), warning_(new QToolButton), job_(new QLabel),
      progress_(new QProgressBar), timeLeft_(new QLabel), cancel_(new QToolButton) {
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
    progress_->setObjectName(QStringLiteral("progress"));
    progress_->setAccessibleName(tr("Progress"));
    progress_->setRange(0, progressSteps);
    progress_->setFixedWidth(200);
    progress_->setTextVisible(false);
    timeLeft_->setObjectName(QStringLiteral("timeLeft"));
    timeLeft_->setToolTip(tr("Estimated from the progress of the job."));
    cancel_->setDefaultAction(&cancel);
    cancel_->setAutoRaise(true);
    bar.addWidget(reading_, 1);
    bar.addPermanentWidget(warning_);
    bar.addPermanentWidget(job_);
    bar.addPermanentWidget(progress_);
    bar.addPermanentWidget(timeLeft_);
    bar.addPermanentWidget(cancel_);
    showJob(false);
    unanswered_.setSingleShot(true);
    unanswered_.setInterval(answerTime);
    connect(&cancel, &QAction::triggered, &unanswered_, qOverload<>(&QTimer::start));
    connect(&jobs, &JobRunner::started, &unanswered_, &QTimer::stop);
    connect(&jobs, &JobRunner::idle, &unanswered_, &QTimer::stop);
    connect(&unanswered_, &QTimer::timeout, this, [this] {
        job_->setText(
            tr("The job does not respond. Save your work, then close the window to end the job."));
    });
    connect(new TimeLeft(jobs, this), &TimeLeft::told, timeLeft_, &QLabel::setText);
    connect(&jobs, &JobRunner::busy, this, [this] { showJob(true); });
    connect(&jobs, &JobRunner::idle, this, [this] { showJob(false); });
    connect(&jobs, &JobRunner::started, this, [this](const QString& title) {
        job_->setText(title);
        progress_->setValue(0);
    });
    connect(&jobs, &JobRunner::progressed, this, [this](double share, const QString& text) {
        progress_->setValue(int(share * progressSteps));
        job_->setText(text);
    });
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

void StatusLine::showJob(bool shown) {
    for (QWidget* widget : {static_cast<QWidget*>(job_), static_cast<QWidget*>(progress_),
                            static_cast<QWidget*>(timeLeft_), static_cast<QWidget*>(cancel_)}) {
        widget->setVisible(shown);
    }
}

} // namespace dipwright
