// Several projects, and copies of them, on one film or roll: chosen, laid out, looked at, written
// and printed. Projects are taken as they are saved.
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

    // Behind those that are there, each once.
    void add(const QStringList& projects);

signals:
    void printed(const QString& sentence);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void reject() override; // what runs is cancelled first

private:
    // A project that was run, and when its file was written then.
    struct Dipped {
        QDateTime written;
        std::shared_ptr<const JobResult> result;
    };
    struct Wanted {
        QString path;
        int copies = 1;
        Dipped dipped; // null: to be run
    };
    struct LaidOut {
        std::vector<Wanted> projects;
        std::shared_ptr<const PackedFilms> films;
        std::vector<SheetPreview> previews; // a film each
    };
    static LaidOut laidOut(std::vector<Wanted> projects, const PackSettings& settings,
                           const SolverRegistry& registry, const Progress& progress);

    QWidget* makeProjects();
    QWidget* makeFilm();
    QWidget* makePreview();
    QWidget* makeButtons();
    void askProjects();
    void removeChosen();
    void chooseFilm();
    void changed(); // lays out anew where that takes no dip
    void layOut();
    void take(LaidOut laid);
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
    QCheckBox* turn_;
    PicturePanel* preview_;
    QLabel* told_;
    QProgressBar* progress_;
    QPushButton *remove_ = nullptr, *layOut_ = nullptr, *export_ = nullptr, *print_ = nullptr;
    QHash<QString, Dipped> dipped_;
    LaidOut laid_;
    int asked_ = 0;  // number of the last layout asked for
    JobRunner jobs_; // ends before what it reports to
};

} // namespace dipwright
