// Shows the dip in the view: live while it runs, then at the position of the timeline.
#pragma once

#include "workbench/dip/DipSession.h"
#include "workbench/view/DipScene.h"
#include "workbench/widgets/Units.h"

#include <QTimer>

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
    // The largest number of film points that can be drawn while they move.
    std::size_t mostPoints() const;

signals:
    void momentShown(); // body and film may have moved

private:
    void showProject();
    void showResults();
    void begin();
    void showLiveFrame();
    void showMarks(const DipRecording& recording, const ImmersionResult& result);
    void showMoment(int position);
    void showDepth();

    DipSession& session_;
    DipView& view_;
    DipScene& scene_;
    Timeline& timeline_;
    LengthUnit unit_ = LengthUnit::Millimetre;
    QTimer liveTimer_;
    std::shared_ptr<const RecordedFrame> shownFrame_; // the shown frame of the dip in progress
};

} // namespace dipwright
