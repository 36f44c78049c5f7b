// Lists past prints, newest first. The user can find a print by the job number on its sheet and
// open its project.
#pragma once

#include "printing/PrintHistory.h"
#include "workbench/document/Preferences.h"
#include "workbench/jobs/JobRunner.h"

#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace dipwright {

class PrintHistoryDialog : public QDialog {
    Q_OBJECT

public:
    // Reads the history on a worker thread.
    PrintHistoryDialog(const PrintHistory& history, LengthUnit unit, QWidget* parent = nullptr);

signals:
    void projectAsked(const QString& path);

private:
    void showRecords(std::vector<PrintRecord> records);
    void showFound(); // the records that contain all search words
    void showChosen();
    void openChosen();
    const PrintRecord* chosen() const; // null: none

    LengthUnit unit_;
    std::vector<PrintRecord> records_;
    QLineEdit* search_;
    QTableWidget* table_;
    QLabel* facts_;
    QPushButton* open_;
    JobRunner jobs_; // destroyed first: jobs report to the members above
};

} // namespace dipwright
