#include "workbench/compare/ComparedSide.h"

#include "workbench/document/SnapshotEdits.h"

namespace dipwright {

namespace {

constexpr std::size_t recordedPoints = 1000; // few: the motion is not shown

} // namespace

ComparedSide::ComparedSide(const ComparedState& state, std::shared_ptr<const JobResult> kept,
                           JobRunner& jobs, const SolverRegistry& registry, DipView& view,
                           QObject* parent)
    : QObject(parent), title_(state.title), figures_(state.figures), document_(state.project),
      session_(jobs, registry), view_(view), scene_(view) {
    session_.setDocument(&document_);
    session_.setKept(std::move(kept));
    scene_.setShowHandles(false);
    view.setWaterVisible(false);
    view.setFilmFitted(false);
}

void ComparedSide::run() {
    session_.run(recordedPoints, DipReach::JobOnly);
}

void ComparedSide::lookAt(std::size_t immersion) {
    session_.lookAt(immersion);
}

void ComparedSide::show(ComparedLook look, const HeatScale& scale) {
    const bool isDipped = reading() != nullptr;
    scene_.setProject(document_.project(), session_.immersion());
    scene_.setPreviewed(!isDipped);
    scene_.setBodyLook(look == ComparedLook::Coverage     ? BodyLook::Coverage
                       : look == ComparedLook::Difference ? BodyLook::Difference
                                                          : BodyLook::Own);
    // Hides the body under its film, because both lie at the same depth and would flicker.
    const bool showsFilm = look == ComparedLook::Film || look == ComparedLook::Stretch;
    const bool isFilmAlone = showsFilm && isDipped;
    scene_.setFilmExtent(isFilmAlone ? FilmExtent::OnBody : FilmExtent::Whole);
    view_.setBodyVisible(!isFilmAlone);
    scene_.setHeat(FilmQuantity::Length, scale);
    scene_.setFilmLook(look == ComparedLook::Stretch ? FilmLook::Stretch : FilmLook::Lines);
    scene_.setResult(isDipped ? session_.outcome().result : nullptr, reading());
    if (isDipped) {
        scene_.showEnd();
    } else {
        scene_.showSetup();
    }
}

std::vector<StateFigure> ComparedSide::figures(LengthUnit unit) const {
    std::vector<StateFigure> all = figures_;
    const std::vector<StateFigure> found = stateFigures(snapshotMeasures(document_), unit);
    all.insert(all.end(), found.begin(), found.end());
    return all;
}

} // namespace dipwright
