// Prints the sheets of a result: on which printer, which of them, how often, with a look at the
// page in true size and true colour, and with everything that the printer would get wrong said
// beforehand.
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
class QSpinBox;

namespace dipwright {

class NoticeBar;
class PicturePanel;

class PrintDialog : public QDialog {
    Q_OBJECT

public:
    // `immersion`: the one that is chosen at first. `projectFile`: for the history; empty: none
    // yet.
    PrintDialog(const DipOutcome& outcome, std::size_t immersion, const QString& projectFile,
                QWidget* parent = nullptr);
    // Says something about the sheets above all else.
    void warn(const QString& sentence);

signals:
    void printed(const QString& sentence);

private:
    void tellVerdict();
    QWidget* makeChoices();
    QWidget* makeExceptions();
    QWidget* makePreview();
    void choosePaper(); // for all sheets
    void showSheet(std::size_t number);
    void startProof(const Sheet& sheet, const SheetPreview& page, int proofing);
    void saveFile();
    void findPrinters();
    void showPrinters(const QStringList& printers);
    void judge(); // whether it can be printed as chosen
    void print();
    void setBusy(bool busy, const QString& what);
    void showFailure(std::exception_ptr failure);
    PrintRequest request() const;
    std::vector<Sheet> chosenSheets() const;

    DipOutcome outcome_;
    PrintSource source_;
    std::vector<Sheet> sheets_; // as they are printed
    std::size_t shown_;         // the one looked at
    PicturePanel* preview_;
    QComboBox *printer_, *paper_, *orientation_, *proof_;
    QSpinBox* copies_;
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
    int judgement_ = 0; // number of the last one asked for
    int proofing_ = 0;
    JobRunner jobs_; // ends before what it reports to
};

} // namespace dipwright
