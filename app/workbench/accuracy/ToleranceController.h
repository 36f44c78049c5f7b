// Computes the tolerances of a window's document on request. Emits them while they match the
// project.
#pragma once

#include "workbench/accuracy/ToleranceCheck.h"
#include "workbench/dip/DipSession.h"
#include "workbench/document/MarkEdits.h"
#include "workbench/document/Preferences.h"

class QWidget;

namespace dipwright {

class WindowActions;

class ToleranceController : public QObject {
    Q_OBJECT

public:
    ToleranceController(const WindowActions& actions, const DipSession& session,
                        ToleranceCheck& check, Messages& messages, QWidget& window);

    // Call this when the session has another document.
    void showDocument();
    void setLengthUnit(LengthUnit unit);
    // Shows the zones if `brush` marks zones.
    void setBrush(const MarkBrush& brush);

signals:
    // Gives the tolerances of the current project and one sentence for each zone. If they are
    // unknown, `tolerances` is null and `verdicts` is empty.
    void changed(const std::shared_ptr<const dipwright::JobTolerances>& tolerances,
                 const QStringList& verdicts);

private:
    void take(const ToleranceResult& result);
    void showTolerances();
    QStringList verdicts() const; // one sentence for each zone
    bool isTrue() const;          // whether the result matches the current project

    const WindowActions& actions_;
    const DipSession& session_;
    ToleranceCheck& check_;
    Messages& messages_;
    QWidget& window_;
    LengthUnit unit_ = LengthUnit::Millimetre;
    ToleranceResult result_;
};

} // namespace dipwright
