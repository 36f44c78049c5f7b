// The dialog that shows the numerical error of a project's sheets: figures and a map for each dip.
#pragma once

#include "pipeline/SheetNumericalError.h"
#include "workbench/widgets/Units.h"

#include <QDialog>

namespace dipwright {

// Returns a sentence that says whether the sheet is accurate enough.
QString numericalErrorSentence(const DipNumericalError& numericalError, LengthUnit unit);

class NumericalErrorDialog : public QDialog {
    Q_OBJECT

public:
    // `outdated`: the project has changed since the figures were computed.
    NumericalErrorDialog(const std::vector<DipNumericalError>& numericalError, bool outdated,
                         LengthUnit unit, QWidget* parent = nullptr);

signals:
    void saveAsked(const QString& folder); // asks to save all maps in `folder`

private:
    void askFolder();
};

} // namespace dipwright
