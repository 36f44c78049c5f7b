#include "main/ToleranceController.h"

#include "dialogs/ToleranceDialog.h"
#include "main/WindowActions.h"
#include "panels/PropertyPanel.h"
#include "panels/ReportPanel.h"
#include "view/DipScene.h"

#include <QAction>

namespace dipwright {

ToleranceController::ToleranceController(const WindowActions& actions, const DipSession& session,
                                         ToleranceCheck& check, Messages& messages, DipScene& scene,
                                         const PropertyPanel& properties, ReportPanel& report,
                                         QWidget& window)
    : actions_(actions), session_(session), check_(check), messages_(messages), scene_(scene),
      report_(report), window_(window) {
    connect(actions.tolerances, &QAction::triggered, this,
            [this] { check_.start(*session_.document()); });
    connect(actions.run, &QAction::triggered, &check_, &ToleranceCheck::cancel);
    connect(&properties, &PropertyPanel::tolerancesAsked, actions.tolerances, &QAction::trigger);
    // Who marks zones wants to see them.
    connect(&properties, &PropertyPanel::brushChanged, this, [this](const MarkBrush& brush) {
        if (std::holds_alternative<ZoneMark>(brush)) {
            actions_.zones->setChecked(true);
        }
    });
    connect(&check, &ToleranceCheck::done, this, &ToleranceController::take);
}

void ToleranceController::showDocument() {
    told_ = {};
    if (const Document* document = session_.document()) {
        connect(document, &Document::projectChanged, this, &ToleranceController::dress);
    }
    dress();
}

void ToleranceController::setLengthUnit(LengthUnit unit) {
    unit_ = unit;
    dress();
}

bool ToleranceController::isTrue() const {
    return told_.job && session_.document() && session_.document()->project() == told_.job->project;
}

void ToleranceController::take(const ToldTolerances& told) {
    told_ = told;
    for (const QString& verdict : verdicts()) {
        messages_.log(verdict);
    }
    dress();
    auto* dialog = new ToleranceDialog(*told.job, *told.tolerances, !isTrue(), unit_, &window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show(); // beside what the user does by now
}

void ToleranceController::dress() {
    scene_.setTolerances(isTrue() ? told_.tolerances : nullptr);
    report_.setTolerances(isTrue() ? verdicts() : QStringList());
}

QStringList ToleranceController::verdicts() const {
    QStringList sentences;
    for (const ZoneVerdict& zone : told_.tolerances->zones) {
        sentences.append(
            zoneText(zone, [this](double millimetres) { return shownLength(millimetres, unit_); }));
    }
    return sentences;
}

} // namespace dipwright
