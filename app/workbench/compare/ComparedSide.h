// One of two compared states, with its document, its dips and its view.
#pragma once

#include "viewport/DipView.h"
#include "workbench/dip/DipSession.h"
#include "workbench/results/StateFigures.h"
#include "workbench/view/DipScene.h"
#include "workbench/widgets/HeatScale.h"

namespace dipwright {

enum class ComparedLook { Film, Stretch, Coverage, Difference };

class ComparedSide : public QObject {
    Q_OBJECT

public:
    // `view` must outlive this object. No dip runs before run().
    ComparedSide(const ComparedState& state, std::shared_ptr<const JobResult> kept, JobRunner& jobs,
                 const SolverRegistry& registry, DipView& view, QObject* parent);

    void run();
    void lookAt(std::size_t immersion);
    // Before the dip, the body shows a preview of the painted area, estimated from the body's
    // shape.
    void show(ComparedLook look, const HeatScale& scale);
    // What show() shows as ComparedLook::Difference.
    void setDifference(const BodyAppearance& appearance) { scene_.setDifference(appearance); }
    void lookAt(const Eigen::Vector3f& place) { scene_.lookAt(place); } // in model coordinates
    std::shared_ptr<const FilmReadout> reading() const { return session_.reading(); }
    QString title() const { return title_; }
    // Returns the figures given with the state, followed by the figures of the dips.
    std::vector<StateFigure> figures(LengthUnit unit) const;
    DipSession& session() { return session_; }

private:
    QString title_;
    std::vector<StateFigure> figures_;
    Document document_;
    DipSession session_;
    DipView& view_;
    DipScene scene_;
};

} // namespace dipwright
