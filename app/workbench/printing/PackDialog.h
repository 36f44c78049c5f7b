// Places several projects, and copies of them, on one film or roll: choose, lay out, preview,
// export and print. Uses the saved version of each project.
#pragma once

#include "pipeline/JobPacking.h"
#include "solver/SolverRegistry.h"
#include "workbench/dip/DipJob.h"
#include "workbench/jobs/JobRunner.h"

#include <QDateTime>
#include <QDialog>
#include <QHash>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace dipwright {

class PicturePanel;

class PackDialog : public QDialog {
    Q_OBJECT

public:
    explicit PackDialog(const SolverRegistry& registry, QWidget* parent = nullptr);

    // Adds projects after the others; skips those that are already there.
    void add(const QStringList& projects);

signals:
    void printed(const QString& sentence);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void reject() override; // cancels a running job first

private:
    // The result of a project, and the modification time that its file had when the job started.
    struct Dipped {
        QDateTime written;
        std::shared_ptr<const JobResult> result;
    };
    struct Wanted {
        QString path;
        int copies = 1;
        Dipped dipped; // without a result: not run yet
    };
    struct LaidOut {
        std::vector<Wanted> projects;
        std::shared_ptr<const PackedFilms> films;
        std::vector<SheetPreview> previews; // one for each film
    };
    // Returns the results of the laid out projects, each once.
    std::vector<std::shared_ptr<const JobResult>> results() const;
    static LaidOut laidOut(std::vector<Wanted> projects, const PackSettings& settings,
                           const SolverRegistry& registry, const Progress& progress);

    QWidget* makeProjects();
    QWidget* makeFilm();
    QWidget* makePreview();
    QWidget* makeButtons();
    void askProjects();
    void removeChosen();
    void chooseFilm();
    void changed(); // lays out again if all projects have a result
    void layOut();
    void take(LaidOut laid);
    void showVerdicts();
    void showFilm(int number);
    void exportFilms();
    void print();
    void tell(const QString& text);
    void enable();
    void showFailure(std::exception_ptr failure);
    std::vector<Wanted> wanted() const;
    PackSettings settings() const;

    const SolverRegistry& registry_;
    QTableWidget* table_;
    QComboBox *film_, *feed_, *shown_;
    QDoubleSpinBox *width_, *length_, *spacing_, *margin_;
    QCheckBox *turn_, *whole_;
    PicturePanel* preview_;
    QLabel* told_;
    QProgressBar* progress_;
    QPushButton *remove_ = nullptr, *layOut_ = nullptr, *export_ = nullptr, *print_ = nullptr;
    QPushButton* close_ = nullptr; // cancels while a job runs
    QString closeText_;
    QHash<QString, Dipped> dipped_;
    LaidOut laid_;
    int asked_ = 0;  // number of the latest layout request
    JobRunner jobs_; // destroyed first: jobs report to the members above
};

} // namespace dipwright
