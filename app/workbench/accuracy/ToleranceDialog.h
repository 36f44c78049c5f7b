// How far the colours of a job may land off their places, by what, and whether its zones keep their
// limits.
#pragma once

#include "pipeline/JobResult.h"
#include "workbench/widgets/Units.h"

#include <QDialog>

namespace dipwright {

class ToleranceDialog : public QDialog {
    Q_OBJECT

public:
    // `outdated`: the project has been changed since.
    ToleranceDialog(const JobResult& job, const JobTolerances& tolerances, bool outdated,
                    LengthUnit unit, QWidget* parent = nullptr);
};

} // namespace dipwright
