// The tank-side page: a full-screen window in large letters that says what to do now, counts the
// time down, and records how long each step took. It is worked by the space bar or the pointer.
// It shows no dialogs. Its progress is stored in the user's settings, so that a closed page
// continues where it was.
#pragma once

#include "workbench/tank/TankWork.h"

#include <QTimer>
#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace dipwright {

class TankPage : public QWidget {
    Q_OBJECT

public:
    // `clock` is for tests; by default a monotonic clock.
    explicit TankPage(std::vector<TankJob> jobs, TankWork::Clock clock = {},
                      QWidget* parent = nullptr);

    const TankWork& work() const { return work_; }
    // Shows a sentence below the steps, for example why the times were not stored.
    void say(const QString& sentence);

signals:
    // All steps of a job are done once.
    void runFinished(const TankJob& job, const std::vector<TankTime>& times);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    QPushButton* makeButton(const char* name, const QString& text, const QString& help);
    void layOut();
    void next();
    void back();
    void pause();
    void tick();
    void showStep();
    void showColour(const std::optional<Seconds>& left);
    void setLetters();
    void keepProgress();

    TankWork work_;
    QTimer timer_;
    int beeped_ = 0; // seconds left at the last signal
    QLabel *where_, *title_, *time_, *text_, *next_, *message_;
    QProgressBar* bar_;
    QPushButton *done_, *back_, *pause_, *sound_, *close_;
};

} // namespace dipwright
