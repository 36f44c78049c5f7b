// The figures of the last run, as tables.
#pragma once

#include "pipeline/JobResult.h"
#include "workbench/widgets/Units.h"

#include <QWidget>

class QLabel;
class QTextBrowser;

namespace dipwright {

class ReportPanel : public QWidget {
    Q_OBJECT

public:
    explicit ReportPanel(QWidget* parent = nullptr);

    void setResult(std::shared_ptr<const JobResult> result, LengthUnit unit); // null: none yet
    // Of how far colours may land off their places, a sentence a zone; empty where not told.
    void setTolerances(const QStringList& sentences);

signals:
    void smallerFilmTaken(); // the one that smallerFilm() finds for the result shown

private:
    void show();

    std::shared_ptr<const JobResult> result_;
    LengthUnit unit_ = LengthUnit::Millimetre;
    QStringList tolerances_;
    QTextBrowser* text_;
    QLabel* hint_; // instead of the text, before the first run
};

} // namespace dipwright
