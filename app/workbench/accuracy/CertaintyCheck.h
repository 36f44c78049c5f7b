// How certain a document's sheets are, computed on its project as it is when asked, run or not.
#pragma once

#include "pipeline/SheetCertainty.h"
#include "workbench/document/Document.h"
#include "workbench/jobs/JobRunner.h"
#include "workbench/jobs/Messages.h"

#include <QPointer>

namespace dipwright {

class CertaintyCheck : public QObject {
    Q_OBJECT

public:
    CertaintyCheck(JobRunner& jobs, const SolverRegistry& registry, Messages& messages,
                   QObject* parent = nullptr);

    void start(const Document& document);
    void cancel(); // a dip that is wanted meanwhile does not wait for it

signals:
    // `outdated`: the project has been changed since.
    void done(const std::vector<dipwright::ImmersionCertainty>& certainty, bool outdated);

private:
    JobRunner& jobs_;
    const SolverRegistry& registry_;
    Messages& messages_;
    CancelToken last_;
};

} // namespace dipwright
