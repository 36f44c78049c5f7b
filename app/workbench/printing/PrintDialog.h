// Prints the sheets of a result. The user chooses printer, sheets and copies, and sees the page at
// true size and in true colour. Every problem is reported before anything is sent.
#pragma once

#include "printing/PrintService.h"
#include "workbench/dip/DipJob.h"
#include "workbench/jobs/JobRunner.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace dipwright {

class NoticeBar;
class NumberBox;
class PicturePanel;

class PrintDialog : public QDialog {
    Q_OBJECT

public:
    // `immersion`: the dip whose sheet is shown first. `projectFile`: for the print history; empty:
    // not saved yet.
    // `judged`: the results whose verdicts are shown, if the sheets come from several jobs.
    PrintDialog(const DipOutcome& outcome, std::size_t immersion, const QString& projectFile,
                QWidget* parent = nullptr,
                const std::vector<std::shared_ptr<const JobResult>>& judged = {});
    // Shows a warning about the sheets at the top.
    void warn(const QString& sentence);

signals:
    void printed(const QString& sentence);

private:
    void showVerdicts(const std::vector<std::shared_ptr<const JobResult>>& judged);
    QWidget* makeChoices(bool isOfSeveralJobs);
    QWidget* makeExceptions();
    QWidget* makePreview();
    void choosePaper(); // applies to all sheets
    void showSheet(std::size_t number);
    void startProof(const Sheet& sheet, const SheetPreview& page, int proofing);
    void saveFile();
    void findPrinters();
    void showPrinters(const QStringList& printers);
    void judge(); // checks whether the job can be printed as chosen
    void print();
    void setBusy(bool busy, const QString& what);
    void showFailure(std::exception_ptr failure);
    PrintRequest request() const;
    std::vector<Sheet> chosenSheets() const;

    DipOutcome outcome_;
    PrintSource source_;
    std::vector<Sheet> sheets_; // as they will be printed
    std::size_t shown_;         // index of the shown sheet
    PicturePanel* preview_;
    QComboBox *printer_, *paper_, *orientation_, *proof_;
    NumberBox* copies_;
    std::vector<QCheckBox*> immersions_;
    QCheckBox* tile_;
    QCheckBox* grey_;
    QCheckBox* clipped_;
    QCheckBox* otherPaper_;
    NoticeBar* notice_;
    QLabel *verdict_, *gamut_;
    QProgressBar* progress_;
    QPushButton *print_, *save_;
    bool printing_ = false;
    bool isKnownAsExpired_ = false; // the verdict shown already says that the film has expired
    int judgement_ = 0;             // number of the latest check
    int proofing_ = 0;
    JobRunner jobs_; // destroyed first: jobs report to the members above
};

} // namespace dipwright
