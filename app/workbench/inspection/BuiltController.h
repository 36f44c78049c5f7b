// Controls the page of a job's measured parts: runs its requests as jobs and shows their results.
#pragma once

#include "workbench/dip/DipSession.h"
#include "workbench/inspection/BuiltPage.h"
#include "workbench/inspection/MeasuredPart.h"
#include "workbench/jobs/Messages.h"

namespace dipwright {

class BuiltController : public QObject {
    Q_OBJECT

public:
    BuiltController(const DipSession& session, JobRunner& jobs, Messages& messages);

    BuiltPage* page() const { return page_; } // its window owns it
    // Call this when the session has another document.
    void showDocument();
    // Sets the current measured part; null: none.
    void setMeasured(std::shared_ptr<const MeasuredPart> measured);

private:
    void showProject();
    void computeRepeatingError(const AsBuilt& built, int dips);
    void keep(const std::shared_ptr<const MeasuredPart>& measured, const QString& acceptedBy);

    const DipSession& session_;
    JobRunner& jobs_;
    Messages& messages_;
    BuiltPage* page_;
    std::shared_ptr<const MeasuredPart> measured_;
    std::vector<BuiltPlace> places_; // the places from which the shown errors were computed
};

} // namespace dipwright
