#include "workbench/results/Timeline.h"

#include "workbench/widgets/Icons.h"
#include "workbench/widgets/PlainTexts.h"

#include <QHBoxLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QPainter>
#include <QProxyStyle>
#include <QSlider>
#include <QStyleOptionSlider>
#include <QToolButton>
#include <QToolTip>
#include <cstdlib>

namespace dipwright {

namespace {

constexpr double playSeconds = 4; // for the whole dip, whatever its real duration
constexpr int ticksPerSecond = 30;

// A press beside the handle moves it there, as in media players.
class JumpStyle : public QProxyStyle {
public:
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* result) const override {
        return hint == SH_Slider_AbsoluteSetButtons
                   ? int(Qt::LeftButton)
                   : QProxyStyle::styleHint(hint, option, widget, result);
    }
};

constexpr int markHeight = 5; // pixels, at the slider's lower edge
constexpr int markReach = 4;  // pixels to each side of a mark that count as the mark

} // namespace

// A slider with a tick at each notable moment; its tooltip describes the moment.
class MarkedSlider : public QSlider {
public:
    MarkedSlider() : QSlider(Qt::Horizontal) { setProperty(hasOwnToolTips, true); }

    void setMarks(const std::vector<TimelineMark>& marks) {
        marks_ = marks;
        QStringList texts;
        for (const TimelineMark& mark : marks) {
            texts.append(mark.text);
        }
        setAccessibleDescription(texts.join(QStringLiteral("; ")));
        update();
    }

protected:
    void paintEvent(QPaintEvent* event) override {
        QSlider::paintEvent(event);
        QPainter painter(this);
        for (const TimelineMark& mark : marks_) {
            painter.fillRect(QRect(placeOf(mark) - 1, height() - markHeight, 3, markHeight),
                             mark.colour);
        }
    }
    bool event(QEvent* event) override {
        if (event->type() == QEvent::ToolTip) {
            auto& help = static_cast<QHelpEvent&>(*event);
            QStringList texts;
            for (const TimelineMark& mark : marks_) {
                if (std::abs(placeOf(mark) - help.pos().x()) <= markReach) {
                    texts.append(mark.text);
                }
            }
            if (!texts.isEmpty()) {
                QToolTip::showText(help.globalPos(), texts.join(QLatin1Char('\n')), this);
                return true;
            }
        }
        return QSlider::event(event);
    }

private:
    // Returns the x of the handle's centre when the handle is at the mark.
    int placeOf(const TimelineMark& mark) const {
        QStyleOptionSlider option;
        initStyleOption(&option);
        const int handle = style()->pixelMetric(QStyle::PM_SliderLength, &option, this);
        return handle / 2 + QStyle::sliderPositionFromValue(minimum(), maximum(), mark.position,
                                                            width() - handle);
    }

    std::vector<TimelineMark> marks_;
};

Timeline::Timeline(QWidget* parent)
    : QWidget(parent), playButton_(new QToolButton), startButton_(new QToolButton),
      endButton_(new QToolButton), slider_(new MarkedSlider), depth_(new QLabel) {
    const auto makeButton = [](QToolButton* button, const QString& iconName, const QString& text) {
        button->setIcon(icon(iconName));
        button->setToolTip(text);
        button->setAccessibleName(text);
        button->setAutoRaise(true);
    };
    makeButton(startButton_, QStringLiteral("to-start"), tr("Before the dip"));
    makeButton(playButton_, QStringLiteral("play"), tr("Play the dip"));
    makeButton(endButton_, QStringLiteral("to-end"), tr("End of the dip"));
    slider_->setObjectName(QStringLiteral("timeline"));
    auto* style = new JumpStyle;
    style->setParent(slider_);
    slider_->setStyle(style);
    slider_->setAccessibleName(tr("Time of the dip"));
    slider_->setToolTip(tr("Time of the dip"));
    depth_->setMinimumWidth(
        depth_->fontMetrics().horizontalAdvance(QStringLiteral("  000.00 mm  ")));
    depth_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    depth_->setToolTip(tr("Depth of the part's lowest point below the waterline"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(6, 2, 8, 2);
    layout->addWidget(startButton_);
    layout->addWidget(playButton_);
    layout->addWidget(endButton_);
    layout->addWidget(slider_, 1);
    layout->addWidget(depth_);

    connect(slider_, &QSlider::valueChanged, this, &Timeline::positionChanged);
    connect(slider_, &QSlider::sliderPressed, this, &Timeline::pause);
    connect(startButton_, &QToolButton::clicked, this, [this] { setPosition(0); });
    connect(endButton_, &QToolButton::clicked, this, [this] { setPosition(frames()); });
    connect(playButton_, &QToolButton::clicked, this, &Timeline::togglePlaying);
    timer_.setInterval(1000 / ticksPerSecond);
    connect(&timer_, &QTimer::timeout, this, &Timeline::advance);
    setFrames(0);
}

void Timeline::setFrames(int frames) {
    pause();
    const QSignalBlocker quiet(slider_);
    slider_->setRange(0, frames);
    slider_->setValue(frames);
    slider_->setMarks({});
    slider_->setPageStep(std::max(1, frames / 10));
    setEnabled(frames > 0);
}

void Timeline::setMarks(const std::vector<TimelineMark>& marks) {
    slider_->setMarks(marks);
}

int Timeline::frames() const {
    return slider_->maximum();
}

int Timeline::position() const {
    return slider_->value();
}

void Timeline::setPosition(int position) {
    slider_->setValue(position);
}

void Timeline::setDepth(double millimetres, LengthUnit unit) {
    depth_->setText(shownLength(millimetres, unit));
}

void Timeline::togglePlaying() {
    if (isPlaying()) {
        pause();
        return;
    }
    if (frames() == 1) {
        emit recordingAsked();
    } else {
        play();
    }
}

void Timeline::play() {
    if (position() >= frames()) {
        setPosition(0);
    }
    playPosition_ = position();
    clock_.start();
    timer_.start();
    playButton_->setIcon(icon(QStringLiteral("pause")));
    playButton_->setToolTip(tr("Pause"));
}

void Timeline::pause() {
    timer_.stop();
    playButton_->setIcon(icon(QStringLiteral("play")));
    playButton_->setToolTip(tr("Play the dip"));
}

void Timeline::advance() {
    playPosition_ += double(clock_.restart()) / 1000 / playSeconds * frames();
    setPosition(std::min(frames(), int(playPosition_)));
    if (position() >= frames()) {
        pause();
    }
}

} // namespace dipwright
