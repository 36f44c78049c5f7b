// How certain a project's sheets are, and where they are not: the figures and the map of each
// immersion.
#pragma once

#include "pipeline/SheetCertainty.h"
#include "workbench/widgets/Units.h"

#include <QDialog>

namespace dipwright {

// Whether the sheet is certain, in a sentence.
QString certaintyVerdict(const ImmersionCertainty& certainty, LengthUnit unit);

class CertaintyDialog : public QDialog {
    Q_OBJECT

public:
    // `outdated`: the project has been changed since.
    CertaintyDialog(const std::vector<ImmersionCertainty>& certainty, bool outdated,
                    LengthUnit unit, QWidget* parent = nullptr);

signals:
    void saveAsked(const QString& folder); // all maps

private:
    void askFolder();
};

} // namespace dipwright
