#include "workbench/view/MeasureTool.h"

#include "geometry/SurfacePath.h"

#include <utility>

namespace dipwright {

MeasureTool::MeasureTool(DipView& view, const DipScene& scene, Messages& messages, QObject* parent)
    : QObject(parent), view_(view), scene_(scene), messages_(messages) {
    connect(&view, &DipView::clicked, this, &MeasureTool::click);
}

void MeasureTool::setActive(bool active) {
    if (std::exchange(active_, active) && !active) {
        messages_.say({}); // what it asked for
    }
    view_.setCatchPins(!active);
    clear();
    show();
}

void MeasureTool::setLengthUnit(LengthUnit unit) {
    unit_ = unit;
    show();
}

void MeasureTool::clear() {
    search_.cancel();
    places_.clear();
    line_.clear();
}

void MeasureTool::click(const ViewRay& ray) {
    const auto place = active_ ? scene_.modelSurface(ray) : std::nullopt;
    if (!place) {
        return;
    }
    if (places_.size() == 2 || scene_.model() != model_) {
        clear();
    }
    places_.push_back(*place);
    model_ = scene_.model();
    show();
    if (places_.size() < 2) {
        messages_.say(tr("Click the second place on the part"), 0);
    } else {
        messages_.say(distance(), 0);
        findLine();
    }
}

void MeasureTool::findLine() {
    search_ = jobs_.start(std::make_unique<ValueJob<Line>>(
        QString(),
        [model = model_, from = places_[0], to = places_[1]](const Progress& progress) {
            return surfacePath(model->mesh, from, to, progress.cancelToken);
        },
        [this](const Line& line) { takeLine(line); }, [](const std::exception_ptr&) {}));
}

void MeasureTool::takeLine(const Line& line) {
    line_ = line;
    show();
    if (!line_.empty()) {
        messages_.say(distance(), 0);
    }
}

QString MeasureTool::distance() const {
    if (places_.size() < 2) {
        return {};
    }
    const Eigen::Vector3f apart =
        position(model_->mesh, places_[1]) - position(model_->mesh, places_[0]);
    const QString straight = tr("Distance %1").arg(shownLength(double(apart.norm()), unit_));
    return line_.empty()
               ? straight
               : tr("%1, along the surface %2").arg(straight, shownLength(lengthOf(line_), unit_));
}

void MeasureTool::show() {
    if (scene_.model() != model_) {
        clear();
    }
    const auto inWorld = [this](Line line) {
        for (Eigen::Vector3f& point : line) {
            point = scene_.toWorld(point);
        }
        return line;
    };
    Line places;
    for (const SurfacePoint& place : places_) {
        places.push_back(position(model_->mesh, place));
    }
    std::vector<Line> lines;
    if (!line_.empty()) {
        lines.push_back(inWorld(line_));
    }
    if (places.size() == 2) {
        lines.push_back(inWorld(places));
    }
    // The label stands at the first line; the status bar gives both lengths.
    const QString label = lines.empty() ? QString() : shownLength(lengthOf(lines.front()), unit_);
    view_.setMeasure(inWorld(places), lines, label);
}

} // namespace dipwright
