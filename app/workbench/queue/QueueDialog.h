// The window of the job queue: add, watch and cancel projects. It stays open when the main windows
// close.
#pragma once

#include "workbench/queue/JobQueue.h"

#include <QDialog>

class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QTableWidget;

namespace dipwright {

class QueueDialog : public QDialog {
    Q_OBJECT

public:
    explicit QueueDialog(JobQueue& queue, QWidget* parent = nullptr);

    // Proposes the folder of `project` for the results if the queue is empty. `project` may be
    // empty.
    void propose(const QString& project);

signals:
    void projectAsked(const QString& path);
    void tankAsked(const std::vector<TankJob>& jobs); // the finished projects, in order

protected:
    void reject() override; // asks before it cancels a running project

private:
    QLayout* makeFolderRow();
    void addProjects();
    void askFolder();
    void refresh();
    void showChosen();
    std::vector<std::size_t> chosenRows() const;
    std::vector<TankJob> tankJobs() const;

    JobQueue& queue_;
    QTableWidget* table_;
    QPlainTextEdit* details_; // the whole result of the selected project
    QLineEdit* folder_;
    QLabel* sum_;
    QPushButton *cancel_, *cancelAll_, *open_, *remove_, *tank_;
};

} // namespace dipwright
