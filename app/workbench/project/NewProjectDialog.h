// Asks for what a new project needs: model, size, film and number of dips.
#pragma once

#include "import/trusted/ImportModel.h"
#include "workbench/document/Preferences.h"
#include "workbench/jobs/JobRunner.h"

#include <QDialog>
#include <QTimer>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QRadioButton;

namespace dipwright {

struct Project;

class NewProjectDialog : public QDialog {
    Q_OBJECT

public:
    NewProjectDialog(const QString& model, const Preferences& preferences,
                     QWidget* parent = nullptr);

    QString model() const;
    ImportOptions importOptions() const;
    bool runsAtOnce() const { return runs_; } // whether the user chose “Create and run”
    // Returns a function that applies film, preset and dips to a project. It outlives the dialog.
    std::function<void(Project&)> completion() const;

    void accept() override; // waits until the model is read

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    enum class Reading { Pending, Done };
    QWidget* makeFileRow(QLineEdit* line, const QString& title, const QString& filter);
    QWidget* makeSizeRow();
    void updateButtons();
    void readSizes();
    void takeSizes(const BoundingBox& box);
    bool proposeTexture(const ImportedModel& imported); // true: the model is read again
    void enableCreate(bool enabled);
    void endReading(const QString& failure);
    void showExtent();
    void showHint(const QString& text);

    LengthUnit lengthUnit_;
    QString printerProfile_;
    QLineEdit* model_;
    QLineEdit* texture_;
    QRadioButton* byUnit_;
    QComboBox* unit_;
    QRadioButton* byEdge_;
    QDoubleSpinBox* edge_;
    QComboBox* film_; // the size
    QComboBox* filmProfile_;
    QComboBox* template_;
    QLabel* extent_;
    QPushButton *create_, *createAndRun_;
    QTimer delay_;                         // runs while a name is typed
    std::optional<Eigen::Vector3d> sizes_; // of the model in the file's unit, once it was read
    Reading reading_ = Reading::Done;
    bool isAccepting_ = false; // Create was pressed before the model was read
    QString failure_;          // why the model cannot be read; empty: no failure
    bool namesUnit_ = false;   // the file names its unit: its sizes are in mm
    bool guesses_ = true;      // guesses the unit until the user chooses
    bool runs_ = false;
    QString proposed_; // model whose texture was proposed, or where the user has chosen one
    JobRunner jobs_;
};

QString modelFileFilter();
QString pictureFileFilter();
QString projectFileFilter();
QStringList pictureFilePatterns();

} // namespace dipwright
