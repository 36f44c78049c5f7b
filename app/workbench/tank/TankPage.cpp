#include "workbench/tank/TankPage.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDateTime>
#include <QHBoxLayout>
#include <QJsonDocument>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace dipwright {

namespace {

constexpr int tickMilliseconds = 100;
constexpr int firstSignal = 3; // s before the end of a step
// Heights of the letters as shares of the window's height; on a screen 25 cm high, a letter of
// 15 mm can be read from 3 m.
constexpr double titleShare = 0.11, timeShare = 0.22, textShare = 0.042, smallShare = 0.032;
constexpr double widestTitle = 0.062; // of the window's width
const QString soundKey = QStringLiteral("tank/sound");

double steadySeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

double wallSeconds() {
    return double(QDateTime::currentMSecsSinceEpoch()) / 1000;
}

QString now() {
    return QDateTime::currentDateTime().toString(Qt::ISODate);
}

QString progressKey(const TankJob& job) {
    return QStringLiteral("tank/progress/") + job.job;
}

// "1:05", or "+0:08" if the step takes longer than planned.
QString clockText(Seconds left) {
    constexpr int perMinute = 60;
    const bool isOver = left < Seconds(0);
    const auto seconds = qint64(isOver ? std::floor(-left.value()) : std::ceil(left.value()));
    return QStringLiteral("%1%2:%3")
        .arg(isOver ? QStringLiteral("+") : QString())
        .arg(seconds / perMinute)
        .arg(seconds % perMinute, 2, 10, QLatin1Char('0'));
}

QLabel* makeLabel(const char* name, Qt::Alignment alignment, bool wraps) {
    auto* label = new QLabel;
    label->setObjectName(QLatin1String(name));
    label->setAlignment(alignment);
    label->setWordWrap(wraps);
    label->setMinimumSize(1, 1); // the window's size decides, not the text
    return label;
}

void setPixels(QWidget& widget, double height, bool bold = false) {
    QFont font = widget.font();
    font.setPixelSize(std::max(8, int(height)));
    font.setBold(bold);
    widget.setFont(font);
}

} // namespace

TankPage::TankPage(std::vector<TankJob> jobs, TankWork::Clock clock, QWidget* parent)
    : QWidget(parent, Qt::Window),
      work_(std::move(jobs), clock ? std::move(clock) : TankWork::Clock(steadySeconds), now()),
      where_(makeLabel("tankWhere", Qt::AlignLeft, true)),
      title_(makeLabel("tankTitle", Qt::AlignCenter, true)),
      time_(makeLabel("tankTime", Qt::AlignCenter, false)),
      text_(makeLabel("tankText", Qt::AlignHCenter | Qt::AlignTop, true)),
      next_(makeLabel("tankNext", Qt::AlignCenter, true)),
      message_(makeLabel("tankMessage", Qt::AlignCenter, true)), bar_(new QProgressBar),
      done_(makeButton("tankDone", tr("Done (space bar)"),
                       tr("Ends this step and stores its time; space bar"))),
      back_(makeButton("tankBack", tr("Back (←)"),
                       tr("Returns to the step before and forgets its time; left arrow"))),
      pause_(makeButton("tankPause", tr("Pause (P)"), tr("Stops the clock until you continue; P"))),
      sound_(makeButton("tankSound", tr("Sound (S)"),
                        tr("Beeps in the last three seconds of a step; S"))),
      close_(makeButton("tankClose", tr("Close (Esc)"),
                        tr("Closes the page. It continues at this step when it is opened again; "
                           "Escape"))) {
    setObjectName(QStringLiteral("tankPage"));
    setWindowTitle(tr("At the tank"));
    setFocusPolicy(Qt::StrongFocus);
    bar_->setObjectName(QStringLiteral("tankBar"));
    bar_->setAccessibleName(tr("Time of the step"));
    bar_->setTextVisible(false);
    bar_->setRange(0, 1000);
    sound_->setCheckable(true);
    sound_->setChecked(QSettings().value(soundKey, false).toBool());
    layOut();
    connect(done_, &QPushButton::clicked, this, &TankPage::next);
    connect(back_, &QPushButton::clicked, this, &TankPage::back);
    connect(pause_, &QPushButton::clicked, this, &TankPage::pause);
    connect(sound_, &QPushButton::toggled, this,
            [](bool on) { QSettings().setValue(soundKey, on); });
    connect(close_, &QPushButton::clicked, this, &QWidget::close);
    connect(&timer_, &QTimer::timeout, this, &TankPage::tick);
    work_.restore(
        QJsonDocument::fromJson(QSettings().value(progressKey(work_.job())).toByteArray()).object(),
        wallSeconds());
    timer_.start(tickMilliseconds);
    showStep();
}

QPushButton* TankPage::makeButton(const char* name, const QString& text, const QString& help) {
    auto* button = new QPushButton(text);
    button->setObjectName(QLatin1String(name));
    button->setToolTip(help);
    button->setFocusPolicy(Qt::TabFocus); // the space bar belongs to the page
    return button;
}

void TankPage::layOut() {
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {back_, pause_, done_, sound_, close_}) {
        button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        buttons->addWidget(button, button == done_ ? 2 : 1);
    }
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(where_);
    layout->addWidget(title_, 4);
    layout->addWidget(time_, 5);
    layout->addWidget(bar_);
    layout->addWidget(text_, 4);
    layout->addWidget(next_, 1);
    layout->addWidget(message_);
    layout->addLayout(buttons);
    message_->hide();
}

void TankPage::say(const QString& sentence) {
    message_->setText(sentence);
    message_->setVisible(!sentence.isEmpty());
}

void TankPage::next() {
    if (!work_.task()) {
        work_.again(now());
    } else {
        const TankJob job = work_.job();
        const std::vector<TankTime> times = work_.next(now());
        if (!times.empty()) {
            QSettings().remove(progressKey(job));
            say({});
            emit runFinished(job, times);
        }
    }
    keepProgress();
    showStep();
}

void TankPage::back() {
    work_.back(now());
    keepProgress();
    showStep();
}

void TankPage::pause() {
    work_.setPaused(!work_.isPaused());
    keepProgress();
    showStep();
}

void TankPage::keepProgress() {
    if (work_.task()) {
        QSettings().setValue(
            progressKey(work_.job()),
            QJsonDocument(work_.progress(wallSeconds())).toJson(QJsonDocument::Compact));
    }
}

// Shows the clock, and beeps in the last seconds of a step.
void TankPage::tick() {
    const std::optional<Seconds> left = work_.left();
    time_->setText(left ? clockText(*left) : work_.task() ? clockText(work_.spent()) : QString());
    showColour(left);
    const double planned = left ? work_.task()->time->value() : 0;
    bar_->setValue(planned > 0 ? int(1000 * std::clamp(work_.spent().value() / planned, 0.0, 1.0))
                               : 0);
    const int seconds = left ? int(std::ceil(left->value())) : firstSignal + 1;
    if (seconds != beeped_ && seconds >= 0 && seconds <= firstSignal && sound_->isChecked() &&
        !work_.isPaused()) {
        QApplication::beep();
    }
    beeped_ = seconds;
}

// The time is red if the step is overdue, and grey if it counts up because no time is planned.
void TankPage::showColour(const std::optional<Seconds>& left) {
    const bool isDark = palette().color(QPalette::Window).lightness() < 128;
    const QColor overdue = isDark ? QColor(255, 120, 100) : QColor(180, 20, 20);
    QPalette colours = palette();
    colours.setColor(QPalette::WindowText, !left ? palette().color(QPalette::PlaceholderText)
                                           : *left < Seconds(0)
                                               ? overdue
                                               : palette().color(QPalette::WindowText));
    time_->setPalette(colours);
}

void TankPage::showStep() {
    const TankTask* task = work_.task();
    const TankTask* after = work_.nextTask();
    QStringList where{work_.job().project};
    if (work_.jobCount() > 1) {
        where << tr("job %1 of %2").arg(work_.jobNumber() + 1).arg(work_.jobCount());
    }
    if (task) {
        where << tr("dip %1").arg(task->dip)
              << tr("step %1 of %2").arg(work_.taskNumber() + 1).arg(work_.job().tasks.size());
    }
    if (work_.run() > 1) {
        where << tr("run %1").arg(work_.run());
    }
    where_->setText(where.join(QStringLiteral(" · ")));
    title_->setText(!task              ? tr("All steps are done")
                    : work_.isPaused() ? tr("Paused: %1").arg(task->title)
                                       : task->title);
    text_->setText(task ? task->text
                        : tr("The times are stored with the job. The space bar starts the next "
                             "run."));
    next_->setText(after ? tr("Next: %1").arg(after->title) : QString());
    done_->setText(task ? tr("Done (space bar)") : tr("Next run (space bar)"));
    pause_->setText(work_.isPaused() ? tr("Continue (P)") : tr("Pause (P)"));
    pause_->setEnabled(task);
    back_->setEnabled(task && work_.taskNumber() > 0);
    bar_->setVisible(task != nullptr && task->time.has_value());
    tick();
    setLetters();
}

void TankPage::setLetters() {
    const double high = height(), wide = width();
    setPixels(*where_, smallShare * high);
    setPixels(*title_, std::min(titleShare * high, widestTitle * wide), true);
    setPixels(*time_, timeShare * high, true);
    // A long sentence gets smaller letters, so that it fits.
    constexpr double usualLength = 170;
    const double length = std::max(1.0, double(text_->text().size()) / usualLength);
    setPixels(*text_, textShare * high / std::sqrt(length));
    setPixels(*next_, textShare * high);
    setPixels(*message_, smallShare * high);
    for (QPushButton* button : {done_, back_, pause_, sound_, close_}) {
        setPixels(*button, std::min(smallShare * high, 0.016 * wide));
        button->setMinimumHeight(int(0.075 * high));
    }
    bar_->setFixedHeight(int(0.02 * high));
}

void TankPage::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Space:
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Right:
        if (!event->isAutoRepeat()) { // a held key must not skip steps
            next();
        }
        break;
    case Qt::Key_Left:
    case Qt::Key_Backspace:
        back();
        break;
    case Qt::Key_P:
        pause();
        break;
    case Qt::Key_S:
        sound_->toggle();
        break;
    case Qt::Key_Escape:
        close();
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

void TankPage::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    setLetters();
}

void TankPage::closeEvent(QCloseEvent* event) {
    keepProgress();
    QWidget::closeEvent(event);
}

} // namespace dipwright
