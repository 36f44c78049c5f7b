// The dialog that takes, compares and restores snapshots of a project.
#pragma once

#include "workbench/document/SnapshotEdits.h"
#include "workbench/results/StateFigures.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QTableWidget;

namespace dipwright {

class SnapshotsDialog : public QDialog {
    Q_OBJECT

public:
    // `document` must outlive the dialog.
    SnapshotsDialog(Document& document, LengthUnit unit, QWidget* parent = nullptr);

signals:
    void comparisonAsked(const std::array<dipwright::ComparedState, 2>& states);

private:
    QWidget* makeTaking();
    QWidget* makeComparison();
    QWidget* makeButtons();
    void showSnapshots(); // fills the lists
    void compare();       // compares the selected snapshot with the state selected in the box
    void addRow(const QString& setting, const QString& first, const QString& second);
    void compareInView();
    void showMeasures(const QJsonObject& first, const QJsonObject& second);

    Document& document_;
    LengthUnit unit_;
    std::vector<Snapshot> snapshots_;
    QLineEdit* name_;
    QListWidget* list_;
    QComboBox* against_; // lists the current project, then the snapshots
    QTableWidget* table_;
    QLabel* verdict_;
    QPushButton *take_, *goBack_, *sideBySide_, *remove_;
};

} // namespace dipwright
