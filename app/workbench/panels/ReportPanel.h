// The figures of the last run, as tables.
#pragma once

#include "panels/Units.h"
#include "pipeline/JobResult.h"

#include <QWidget>

class QLabel;
class QTextBrowser;

namespace dipwright {

class ReportPanel : public QWidget {
    Q_OBJECT

public:
    explicit ReportPanel(QWidget* parent = nullptr);

    void setResult(std::shared_ptr<const JobResult> result, LengthUnit unit); // null: none yet

private:
    QTextBrowser* text_;
    QLabel* hint_; // instead of the text, before the first run
};

} // namespace dipwright
