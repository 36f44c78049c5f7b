#include "workbench/view/MeasureTool.h"

namespace dipwright {

MeasureTool::MeasureTool(DipView& view, const DipScene& scene, Messages& messages, QObject* parent)
    : QObject(parent), view_(view), scene_(scene), messages_(messages) {
    connect(&view, &DipView::clicked, this, &MeasureTool::click);
}

void MeasureTool::setActive(bool active) {
    active_ = active;
    places_.clear();
    view_.setMeasure({}, {});
}

void MeasureTool::setLengthUnit(LengthUnit unit) {
    unit_ = unit;
    show();
}

void MeasureTool::click(const ViewRay& ray) {
    const auto place = active_ ? scene_.modelPoint(ray) : std::nullopt;
    if (!place) {
        return;
    }
    if (places_.size() == 2) {
        places_.clear();
    }
    places_.push_back(*place);
    model_ = scene_.model();
    show();
    messages_.say(places_.size() < 2 ? tr("Click the second place on the part")
                                     : tr("Distance %1").arg(distance()),
                  0);
}

QString MeasureTool::distance() const {
    return places_.size() < 2 ? QString()
                              : shownLength(double((places_[1] - places_[0]).norm()), unit_);
}

void MeasureTool::show() {
    if (scene_.model() != model_) {
        places_.clear();
    }
    std::vector<Eigen::Vector3f> shown;
    for (const Eigen::Vector3f& place : places_) {
        shown.push_back(scene_.toWorld(place));
    }
    view_.setMeasure(shown, distance());
}

} // namespace dipwright
