// The tolerances of a window's document: computed when they are asked for, and announced to those
// who show them as long as they hold for the project.
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

    // To be called when the session has another document.
    void showDocument();
    void setLengthUnit(LengthUnit unit);
    // Zones are shown to whoever marks them.
    void setBrush(const MarkBrush& brush);

signals:
    // Gives the tolerances of the current project and one sentence for each zone. Null, without
    // sentences, where they are not known.
    void changed(const std::shared_ptr<const dipwright::JobTolerances>& tolerances,
                 const QStringList& verdicts);

private:
    void take(const ToleranceResult& result);
    void showTolerances();
    QStringList verdicts() const; // a sentence a zone
    bool isTrue() const;          // of the project as it is

    const WindowActions& actions_;
    const DipSession& session_;
    ToleranceCheck& check_;
    Messages& messages_;
    QWidget& window_;
    LengthUnit unit_ = LengthUnit::Millimetre;
    ToleranceResult result_;
};

} // namespace dipwright
