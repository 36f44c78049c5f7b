// The queue of projects: filled, watched and cancelled. It stays when the windows are closed, until
// it is closed itself.
#pragma once

#include "workbench/queue/JobQueue.h"

#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace dipwright {

class QueueDialog : public QDialog {
    Q_OBJECT

public:
    explicit QueueDialog(JobQueue& queue, QWidget* parent = nullptr);

    // With what is to be in it first, such as the project that is open.
    void propose(const QString& project);

signals:
    void projectAsked(const QString& path);

protected:
    void reject() override; // asks before what runs is cancelled

private:
    QLayout* makeFolderRow();
    void addProjects();
    void askFolder();
    void refresh();
    void showChosen();
    std::vector<std::size_t> chosenRows() const;

    JobQueue& queue_;
    QTableWidget* table_;
    QLineEdit* folder_;
    QLabel* sum_;
    QPushButton *cancel_, *cancelAll_, *open_, *remove_;
};

} // namespace dipwright
