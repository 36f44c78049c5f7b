// The tolerances of a window's document: told when asked, and shown on the body and in the report
// as long as they are true.
#pragma once

#include "document/Preferences.h"
#include "session/DipSession.h"
#include "session/ToleranceCheck.h"

class QWidget;

namespace dipwright {

class DipScene;
class PropertyPanel;
class ReportPanel;
class WindowActions;

class ToleranceController : public QObject {
    Q_OBJECT

public:
    ToleranceController(const WindowActions& actions, const DipSession& session,
                        ToleranceCheck& check, Messages& messages, DipScene& scene,
                        const PropertyPanel& properties, ReportPanel& report, QWidget& window);

    // To be called when the session has another document.
    void showDocument();
    void setLengthUnit(LengthUnit unit);

private:
    void take(const ToldTolerances& told);
    void dress();
    QStringList verdicts() const; // a sentence a zone
    bool isTrue() const;          // of the project as it is

    const WindowActions& actions_;
    const DipSession& session_;
    ToleranceCheck& check_;
    Messages& messages_;
    DipScene& scene_;
    ReportPanel& report_;
    QWidget& window_;
    LengthUnit unit_ = LengthUnit::Millimetre;
    ToldTolerances told_;
};

} // namespace dipwright
