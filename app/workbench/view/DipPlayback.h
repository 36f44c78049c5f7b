// Shows the dip in the view: while it runs, and afterwards the moment that the timeline says.
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

    // To be called when the session has another document.
    void showDocument();
    void setLengthUnit(LengthUnit unit) { unit_ = unit; }
    // Of the film that is to be recorded: as many as can be shown moving.
    std::size_t mostPoints() const;

signals:
    void momentShown(); // body and film may be somewhere else now

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
    std::shared_ptr<const RecordedFrame> shownFrame_; // of the dip that runs
};

} // namespace dipwright
