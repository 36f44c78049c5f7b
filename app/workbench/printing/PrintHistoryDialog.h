// What was printed, the newest first: found by the job number on a sheet, and its project opened.
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
    // Reads the history beside the user interface.
    PrintHistoryDialog(const PrintHistory& history, LengthUnit unit, QWidget* parent = nullptr);

signals:
    void projectAsked(const QString& path);

private:
    void showRecords(std::vector<PrintRecord> records);
    void showFound(); // of the records, what holds all words that are looked for
    void showChosen();
    void openChosen();
    const PrintRecord* chosen() const; // null: none

    LengthUnit unit_;
    std::vector<PrintRecord> records_;
    QLineEdit* search_;
    QTableWidget* table_;
    QLabel* facts_;
    QPushButton* open_;
    JobRunner jobs_; // ends before what it reports to
};

} // namespace dipwright
