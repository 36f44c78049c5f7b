#include "workbench/accuracy/ToleranceController.h"

#include "workbench/accuracy/ToleranceDialog.h"
#include "workbench/actions/WindowActions.h"

#include <QAction>

namespace dipwright {

ToleranceController::ToleranceController(const WindowActions& actions, const DipSession& session,
                                         ToleranceCheck& check, Messages& messages, QWidget& window)
    : actions_(actions), session_(session), check_(check), messages_(messages), window_(window) {
    connect(actions.tolerances, &QAction::triggered, this,
            [this] { check_.start(*session_.document()); });
    connect(actions.run, &QAction::triggered, &check_, &ToleranceCheck::cancel);
    connect(&check, &ToleranceCheck::done, this, &ToleranceController::take);
}

void ToleranceController::showDocument() {
    result_ = {};
    if (const Document* document = session_.document()) {
        connect(document, &Document::projectChanged, this, &ToleranceController::showTolerances);
    }
    showTolerances();
}

void ToleranceController::setLengthUnit(LengthUnit unit) {
    unit_ = unit;
    showTolerances();
}

void ToleranceController::setBrush(const MarkBrush& brush) {
    if (std::holds_alternative<ZoneMark>(brush)) {
        actions_.zones->setChecked(true);
    }
}

bool ToleranceController::isTrue() const {
    return result_.job && session_.document() &&
           session_.document()->project() == result_.job->project;
}

void ToleranceController::take(const ToleranceResult& result) {
    result_ = result;
    for (const QString& verdict : verdicts()) {
        messages_.log(verdict);
    }
    showTolerances();
    auto* dialog = new ToleranceDialog(*result.job, *result.tolerances, !isTrue(), unit_, &window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show(); // not modal: the user may be busy elsewhere
}

void ToleranceController::showTolerances() {
    if (isTrue()) {
        emit changed(result_.tolerances, verdicts());
    } else {
        emit changed(nullptr, {});
    }
}

QStringList ToleranceController::verdicts() const {
    QStringList sentences;
    for (const ZoneVerdict& zone : result_.tolerances->zones) {
        sentences.append(
            zoneText(zone, [this](double millimetres) { return shownLength(millimetres, unit_); }));
    }
    return sentences;
}

} // namespace dipwright
