// Film and dip fitted to photos of a dipped part: what the page asks for, done by jobs, and told to
// it.
#pragma once

#include "solver/SolverRegistry.h"
#include "workbench/dip/DipSession.h"
#include "workbench/inspection/FitPage.h"
#include "workbench/inspection/MeasuredPart.h"
#include "workbench/jobs/Messages.h"

namespace dipwright {

class FitController : public QObject {
    Q_OBJECT

public:
    FitController(const DipSession& session, JobRunner& jobs, const SolverRegistry& registry,
                  Messages& messages, QWidget& window);

    FitPage* page() const { return page_; } // belongs to who puts it into a window
    // What is known of the part at hand; null: nothing. A fit to another one is not shown, but as
    // long as the project is what its use has made.
    void setMeasured(std::shared_ptr<const MeasuredPart> measured);

private:
    void fit();
    void showFitted();
    void use();
    void save(const QString& profile);
    void exportFit();

    const DipSession& session_;
    JobRunner& jobs_;
    const SolverRegistry& registry_;
    Messages& messages_;
    QWidget& window_;
    FitPage* page_;
    std::shared_ptr<const MeasuredPart> measured_, fittedTo_;
    std::shared_ptr<const FittedPart> fitted_;
    std::optional<Project> used_; // the project with what was fitted
};

} // namespace dipwright
