#include "workbench/view/FilmProbe.h"

#include "base/NumberText.h"
#include "workbench/results/ResultsPanel.h"

namespace dipwright {

FilmProbe::FilmProbe(const DipSession& session, DipView& view, const DipScene& scene,
                     ResultsPanel& results, QObject* parent)
    : QObject(parent), session_(session), view_(view), scene_(scene), results_(results) {
    connect(&results, &ResultsPanel::hovered, this,
            [this](const Eigen::Vector2f& rest) { show(session_.reading()->at(rest)); });
    connect(&results, &ResultsPanel::hoverLeft, this, [this] { show({}); });
    connect(&view, &DipView::hovered, this, &FilmProbe::readAlong);
    connect(&view, &DipView::hoverLeft, this, [this] { show({}); });
}

void FilmProbe::lookAtFilmPlace(const Eigen::Vector2f& rest) {
    const auto point = session_.reading()->at(rest);
    show(point);
    const auto worldToEnd = scene_.worldToEnd();
    if (point && point->body.isValid() && worldToEnd) {
        const Eigen::Isometry3f toWorld = worldToEnd->inverse().cast<float>();
        view_.lookAt(toWorld * point->place, toWorld.linear() * point->outward);
    }
}

void FilmProbe::readAlong(const ViewRay& ray) {
    if (const auto worldToEnd = scene_.worldToEnd()) {
        const Eigen::Isometry3f toPose = worldToEnd->cast<float>();
        show(session_.reading()->at(toPose * ray.origin, toPose.linear() * ray.direction));
        return;
    }
    view_.setMarker({}); // it may be left from a film that is no longer drawn
    const auto place = scene_.modelPoint(ray);
    emit read(place ? describeBody(*place) : QString());
}

void FilmProbe::show(const std::optional<FilmReadoutPoint>& point) {
    results_.showReading(point);
    if (!point) {
        view_.setMarker({});
    } else if (const auto worldToEnd = scene_.worldToEnd()) {
        view_.setMarker(Eigen::Vector3f(worldToEnd->inverse().cast<float>() * point->place));
    }
    emit read(point ? describe(*point) : QString());
}

QString FilmProbe::describeBody(const Eigen::Vector3f& place) const {
    return tr("Part at %1, %2, %3")
        .arg(shownLength(double(place.x()), unit_), shownLength(double(place.y()), unit_),
             shownLength(double(place.z()), unit_));
}

QString FilmProbe::describe(const FilmReadoutPoint& point) const {
    const solver::FilmGrid& grid = session_.reading()->film().grid;
    const FilmSettings& film = session_.shown().result->project.film;
    const auto number = [](float value) { return numberText(double(value), 3); };
    return tr("Sheet at %1, %2 · %3 · stretch %4 and %5, area stretch %6")
        .arg(shownLength((double(point.rest.x()) / grid.width + 0.5) * film.width.value(), unit_),
             shownLength((double(point.rest.y()) / grid.depth + 0.5) * film.height.value(), unit_),
             point.onPart ? tr("on the part") : tr("on the water"), number(point.stretch.larger),
             number(point.stretch.smaller), number(point.stretch.area()));
}

} // namespace dipwright
