#include "workbench/view/DipPlayback.h"

#include "results/Results.h"
#include "workbench/dip/DipMoments.h"
#include "workbench/results/Timeline.h"
#include "workbench/results/WarningTexts.h"

#include <QCoreApplication>
#include <QSignalBlocker>
#include <algorithm>
#include <utility>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(DipPlayback)
};

QString textOf(DipEvent event) {
    return event == DipEvent::FirstContact ? Text::tr("First contact")
           : event == DipEvent::AirTrapped ? Text::tr("Air is trapped under the part")
           : event == DipEvent::Torn       ? Text::tr("Film tears")
                                           : Text::tr("Film is released at an overhang");
}

QColor colourOf(DipEvent event) {
    switch (event) {
    case DipEvent::FirstContact:
        return QColor(0x2e, 0x8b, 0x57);
    case DipEvent::AirTrapped:
        return QColor(0x3a, 0x8f, 0xd0);
    case DipEvent::Torn:
        return markColour(solver::PointMark::Torn);
    case DipEvent::LetGo:
        break;
    }
    return markColour(solver::PointMark::LetGo);
}

const QColor poseColour(0x8a, 0x6d, 0xc8);
constexpr std::size_t coarsePoints = 6000; // of the moving film, without a GPU
constexpr std::size_t finePoints = 60000;

} // namespace

DipPlayback::DipPlayback(DipSession& session, DipView& view, DipScene& scene, Timeline& timeline,
                         QObject* parent)
    : QObject(parent), session_(session), view_(view), scene_(scene), timeline_(timeline) {
    connect(&session, &DipSession::shownChanged, this, &DipPlayback::showResults);
    connect(&session, &DipSession::finished, this, &DipPlayback::showResults);
    connect(&session, &DipSession::dropped, this, &DipPlayback::showResults);
    connect(&session, &DipSession::stopped, this, [this] {
        playsNext_ = false;
        scene_.setShowsDipped(session_.freshness().dip);
    });
    connect(&session, &DipSession::immersionChanged, this, [this] {
        scene_.setProject(session_.document()->project(), session_.immersion());
        showResults();
    });
    connect(&timeline, &Timeline::positionChanged, this, &DipPlayback::showMoment);
    connect(&timeline, &Timeline::recordingAsked, this, [this] {
        if (session_.canRecord()) {
            emit recordingAsked();
        } else {
            timeline_.play();
        }
    });
    connect(&session, &DipSession::started, this, [this] { playsNext_ = false; });
}

void DipPlayback::showDocument() {
    if (const Document* document = session_.document()) {
        connect(document, &Document::projectChanged, this, &DipPlayback::showProject);
        scene_.setProject(document->project(), session_.immersion());
        showResults();
    }
}

void DipPlayback::setPathKey(int key) {
    scene_.setPathKey(key);
    if (key >= 0) {
        timeline_.setPosition(0);
    }
    showDepth();
}

std::size_t DipPlayback::mostPoints() const {
    return view_.isUsable() && !view_.isSoftwareRendered() ? finePoints : coarsePoints;
}

void DipPlayback::showProject() {
    scene_.setProject(session_.document()->project(), session_.immersion());
    const bool isFresh = session_.freshness().dip;
    if (!isFresh) {
        timeline_.pause();
        timeline_.setPosition(0); // the body in its current pose
    }
    scene_.setShowsDipped(live_ || isFresh);
    showDepth();
}

void DipPlayback::showResults() {
    const auto reading = session_.reading();
    const auto recording = session_.recording();
    scene_.setResult(reading ? session_.shown().result : nullptr, reading);
    showWarnings();
    scene_.setShowsDipped(live_ || session_.freshness().dip);
    const QSignalBlocker quiet(&timeline_);
    // Drafts and cached dips have only their end.
    const bool isRecorded = recording && recording->size() > 0;
    const int frames = isRecorded ? int(recording->size()) : reading ? 1 : 0;
    if (timeline_.frames() != frames) {
        timeline_.setFrames(frames);
        timeline_.setPosition(0);
    }
    timeline_.setMarks({});
    if (isRecorded && reading) {
        showMarks(*recording, session_.shown().result->immersions[session_.immersion()]);
    }
    showMoment(timeline_.position());
    if (frames > 1 && std::exchange(playsNext_, false)) {
        timeline_.play();
    }
}

void DipPlayback::showWarnings() {
    std::vector<DipScene::Pin> pins;
    for (const JobWarning& warning : session_.shown().warnings) {
        pins.push_back({warning.dip,
                        {warning.place, warning.outward, warningColour(warning.kind),
                         warningText(warning, *session_.shown().result, unit_)}});
    }
    scene_.setPins(std::move(pins));
}

void DipPlayback::showMarks(const DipRecording& recording, const ImmersionResult& result) {
    std::vector<TimelineMark> marks;
    for (const DipMoment& moment : dipMoments(recording, result)) {
        const QString depth = shownLength(std::max(0.0, scene_.depthAt(moment.descent)), unit_);
        marks.push_back({int(recording.frameAt(moment.descent)) + 1, colourOf(moment.event),
                         Text::tr("%1, at depth %2").arg(textOf(moment.event), depth)});
    }
    int number = 0;
    for (const double travelled : scene_.travelledAtPoses()) {
        marks.push_back({int(recording.frameAt(travelled)) + 1, poseColour,
                         Text::tr("Pose %1 of the path").arg(++number)});
    }
    timeline_.setMarks(marks);
}

// Position 0 is before the dip. The last position is its end, with the whole film.
void DipPlayback::showMoment(int position) {
    const auto recording = session_.recording();
    if (position > 0 && position < timeline_.frames()) {
        scene_.showFrame(recording, *recording->frame(std::size_t(position) - 1));
    } else if (position > 0) {
        scene_.showEnd();
    } else {
        scene_.showSetup();
    }
    showDepth();
}

void DipPlayback::showDepth() {
    timeline_.setDepth(std::max(0.0, scene_.depth()), unit_);
    emit momentShown();
}

} // namespace dipwright
