// How certain a project's sheets are, and where they are not: the figures and the map of each
// immersion.
#pragma once

#include "panels/Units.h"
#include "pipeline/SheetCertainty.h"

#include <QDialog>

class QTabWidget;

namespace dipwright {

// What the dialog shows, made beside the user interface.
struct CertaintyOutcome {
    std::vector<ImmersionCertainty> immersions;
    std::vector<QImage> maps; // an immersion each
};

class CertaintyDialog : public QDialog {
    Q_OBJECT

public:
    // `outcome` holds one immersion or more.
    CertaintyDialog(const CertaintyOutcome& outcome, LengthUnit unit, QWidget* parent = nullptr);

signals:
    void saveAsked(const QString& folder); // all maps

private:
    void askFolder();
};

} // namespace dipwright
