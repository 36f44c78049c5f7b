// The dialog that makes a list of files from a job's result: sheets, traveller, cradles and others.
// The lists (output sets) are kept with the project.
#pragma once

#include "outputs/MakeOutputs.h"
#include "workbench/document/Document.h"
#include "workbench/jobs/JobRunner.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTreeWidget;

namespace dipwright {

class NoticeBar;

class OutputsDialog : public QDialog {
    Q_OBJECT

public:
    // `document` must outlive the dialog. `result`: what the outputs are made from.
    OutputsDialog(Document& document, std::shared_ptr<const JobResult> result,
                  QWidget* parent = nullptr);

signals:
    void made(const QString& sentence);

private:
    QWidget* makeSets();
    QWidget* makeFolder();
    QWidget* makeOptions();
    QWidget* makeButtons();
    void showSets(const QString& name); // fills the box, and selects the set with this name
    void tickSet();                     // ticks the outputs of the selected set
    void saveSet();
    void removeSet();
    void chooseFolder();
    void showStates(); // looks up the states of all outputs in the folder
    void show(const std::vector<OutputStatus>& states);
    void make();
    void finish(const std::vector<OutputStatus>& states);
    void setBusy(bool busy, const QString& what);
    void enable();
    void showFailure(const std::exception_ptr& failure);
    std::vector<Output> ticked() const;
    QString folder() const;

    Document& document_;
    std::shared_ptr<const JobResult> result_;
    NoticeBar* notice_;
    QComboBox* set_;
    QTreeWidget* list_; // one row for each of allOutputs
    QLineEdit* folder_;
    QCheckBox *overwrite_, *clip_;
    QLabel* words_;
    QProgressBar* progress_;
    QPushButton *save_, *remove_, *choose_, *make_, *close_;
    bool making_ = false;
    int lookup_ = 0; // number of the latest look-up of states
    JobRunner jobs_; // destroyed first: jobs report to the members above
};

} // namespace dipwright
