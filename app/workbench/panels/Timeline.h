// Plays, pauses and scrubs the recorded dip.
#pragma once

#include "panels/Units.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QLabel;
class QSlider;
class QToolButton;

namespace dipwright {

class Timeline : public QWidget {
    Q_OBJECT

public:
    explicit Timeline(QWidget* parent = nullptr);

    // Position 0 is before the dip, `frames` is its end; 0 frames: nothing recorded.
    void setFrames(int frames);
    int frames() const;
    int position() const;
    void setPosition(int position); // emits positionChanged when it differs
    void setDepth(double millimetres, LengthUnit unit);
    bool isPlaying() const { return timer_.isActive(); }
    void togglePlaying();
    void pause();

signals:
    void positionChanged(int position);

private:
    void advance();

    QToolButton* playButton_;
    QToolButton* startButton_;
    QToolButton* endButton_;
    QSlider* slider_;
    QLabel* depth_;
    QTimer timer_;
    QElapsedTimer clock_;
    double playPosition_ = 0;
};

} // namespace dipwright
