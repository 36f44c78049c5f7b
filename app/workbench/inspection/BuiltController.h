// The parts that a job keeps: what their page asks for, done by jobs, and told to it.
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

    BuiltPage* page() const { return page_; } // belongs to who puts it into a window
    // To be called when the session has another document.
    void showDocument();
    // What is known of the part at hand; null: nothing.
    void setMeasured(std::shared_ptr<const MeasuredPart> measured);

private:
    void showProject();
    void findWhatRepeats(const AsBuilt& built, int dips);
    void keep(const QString& acceptedBy);

    const DipSession& session_;
    JobRunner& jobs_;
    Messages& messages_;
    BuiltPage* page_;
    std::shared_ptr<const MeasuredPart> measured_;
    std::vector<BuiltPlace> places_; // that the page's errors are of
};

} // namespace dipwright
