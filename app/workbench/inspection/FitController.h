// Controls the page that fits film and dip to photos of a dipped part: runs its requests as jobs
// and shows their results.
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

    FitPage* page() const { return page_; } // its window owns it
    // Sets the current measured part; null: none. Hides a fit to another part, unless the project
    // still uses that fit.
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
    std::optional<Project> used_; // the project after the fit was used
};

} // namespace dipwright
