// The dialog that shows a job's tolerances: the effect of each contributor, and whether the zones
// keep their limits.
#pragma once

#include "pipeline/JobResult.h"
#include "workbench/widgets/Units.h"

#include <QDialog>

namespace dipwright {

class ToleranceDialog : public QDialog {
    Q_OBJECT

public:
    // `outdated`: the project has changed since the tolerances were computed.
    ToleranceDialog(const JobResult& job, const JobTolerances& tolerances, bool outdated,
                    LengthUnit unit, QWidget* parent = nullptr);
};

} // namespace dipwright
