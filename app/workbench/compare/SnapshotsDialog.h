// Named states of a project: taken, compared in settings and figures, gone back to.
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
    // Of a document that outlives it.
    SnapshotsDialog(Document& document, LengthUnit unit, QWidget* parent = nullptr);

signals:
    void comparisonAsked(const std::array<dipwright::ComparedState, 2>& states);

private:
    QWidget* makeTaking();
    QWidget* makeComparison();
    QWidget* makeButtons();
    void showSnapshots(); // anew
    void compare();       // the one chosen with what the box says
    void addRow(const QString& setting, const QString& first, const QString& second);
    void compareInView();
    void showMeasures(const QJsonObject& first, const QJsonObject& second);

    Document& document_;
    LengthUnit unit_;
    std::vector<Snapshot> snapshots_;
    QLineEdit* name_;
    QListWidget* list_;
    QComboBox* against_; // as it is now, then the snapshots
    QTableWidget* table_;
    QLabel* verdict_;
    QPushButton *take_, *goBack_, *sideBySide_, *remove_;
};

} // namespace dipwright
