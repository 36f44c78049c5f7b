#include "workbench/main/PlaceWarning.h"

#include "pipeline/ValidateJob.h"
#include "workbench/main/StatusLine.h"

namespace dipwright {

PlaceWarning::PlaceWarning(const DipSession& session, StatusLine& status)
    : session_(session), status_(status) {
    connect(&session, &DipSession::immersionChanged, this, &PlaceWarning::show);
}

void PlaceWarning::showDocument() {
    if (const Document* document = session_.document()) {
        connect(document, &Document::projectChanged, this, &PlaceWarning::show);
    }
    show();
}

void PlaceWarning::show() {
    const Document* document = session_.document();
    QString warning;
    if (document && document->project().model) {
        const Project& project = document->project();
        const std::size_t last = project.immersions.size() - 1;
        warning = misplacement(project, project.immersions[std::min(session_.immersion(), last)]);
    }
    status_.setWarning(warning);
}

} // namespace dipwright
