// Shows the dip in the view at the position of the timeline. Position 0 is before the dip, where
// the user places the body. There, the film of the shown results lies on the body.
#pragma once

#include "workbench/dip/DipSession.h"
#include "workbench/view/DipScene.h"
#include "workbench/widgets/Units.h"

namespace dipwright {

class Timeline;

class DipPlayback : public QObject {
    Q_OBJECT

public:
    DipPlayback(DipSession& session, DipView& view, DipScene& scene, Timeline& timeline,
                QObject* parent = nullptr);

    // Call this when the session has another document.
    void showDocument();
    void setLengthUnit(LengthUnit unit) { unit_ = unit; }
    // Whether results follow each change. The shown results are then at most a moment old.
    void setLive(bool live) { live_ = live; }
    // The largest number of film points that can be drawn while they move.
    std::size_t mostPoints() const;

    // The pose of the path that the view shows before the dip; −1: the first moment of the dip.
    void setPathKey(int key);
    // Plays the dip as soon as it is recorded.
    void playNext() { playsNext_ = true; }

signals:
    void momentShown();    // body and film may have moved
    void recordingAsked(); // Timeline::recordingAsked()

private:
    void showProject();
    void showResults();
    void showWarnings();
    void showMarks(const DipRecording& recording, const ImmersionResult& result);
    void showMoment(int position);
    void showDepth();

    DipSession& session_;
    DipView& view_;
    DipScene& scene_;
    Timeline& timeline_;
    LengthUnit unit_ = LengthUnit::Millimetre;
    bool live_ = false, playsNext_ = false;
};

} // namespace dipwright
