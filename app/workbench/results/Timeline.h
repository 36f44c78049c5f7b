// Plays, pauses and scrubs the recorded dip.
#pragma once

#include "workbench/widgets/Units.h"

#include <QColor>
#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QLabel;
class QToolButton;

namespace dipwright {

// A notable moment at a position of the timeline.
struct TimelineMark {
    int position = 0;
    QColor colour;
    QString text;
};

class MarkedSlider;

class Timeline : public QWidget {
    Q_OBJECT

public:
    explicit Timeline(QWidget* parent = nullptr);

    // Position 0 is before the dip, `frames` is its end. 0 frames: nothing was recorded.
    void setFrames(int frames);
    void setMarks(const std::vector<TimelineMark>& marks); // valid until the frames are set again
    int frames() const;
    int position() const;
    void setPosition(int position); // emits positionChanged when it differs
    void setDepth(double millimetres, LengthUnit unit);
    bool isPlaying() const { return timer_.isActive(); }
    void togglePlaying(); // emits recordingAsked() if only the end of the dip is known
    void play();
    void pause();

signals:
    void positionChanged(int position);
    void recordingAsked(); // the user wants to play a dip of which only the end is known

private:
    void advance();

    QToolButton* playButton_;
    QToolButton* startButton_;
    QToolButton* endButton_;
    MarkedSlider* slider_;
    QLabel* depth_;
    QTimer timer_;
    QElapsedTimer clock_;
    double playPosition_ = 0;
};

} // namespace dipwright
