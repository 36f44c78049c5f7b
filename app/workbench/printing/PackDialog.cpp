#include "workbench/printing/PackDialog.h"

#include "pipeline/DipCache.h"
#include "pipeline/JobVerdict.h"
#include "pipeline/Pipeline.h"
#include "printing/PrintReach.h"
#include "project/FilmSizes.h"
#include "project/ProjectStore.h"
#include "workbench/jobs/Messages.h"
#include "workbench/printing/PrintDialog.h"
#include "workbench/project/NewProjectDialog.h"
#include "workbench/widgets/DroppedFiles.h"
#include "workbench/widgets/NumberBox.h"
#include "workbench/widgets/PicturePanel.h"
#include "workbench/widgets/ReplaceQuestion.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace dipwright {

namespace {

enum Column { Name, Copies, Judged, Columns };

const QString rollFilm = QStringLiteral("roll"), customFilm = QStringLiteral("custom");

QDoubleSpinBox* lengthBox(const char* name, double least, double most, double value) {
    auto* box = new NumberBox;
    box->setObjectName(QLatin1String(name));
    box->setDecimals(1);
    box->setRange(least, most);
    box->setValue(value);
    box->setSuffix(PackDialog::tr(" mm"));
    box->setKeyboardTracking(false);
    return box;
}

QStringList projectsIn(const QMimeData& data) {
    QStringList paths;
    for (const QString& path : droppedFiles(data)) {
        if (path.endsWith(QLatin1String(".dipw"), Qt::CaseInsensitive)) {
            paths << path;
        }
    }
    return paths;
}

} // namespace

PackDialog::PackDialog(const SolverRegistry& registry, QWidget* parent)
    : QDialog(parent), registry_(registry), table_(new QTableWidget(0, Columns)),
      film_(new QComboBox), feed_(new QComboBox), shown_(new QComboBox),
      width_(lengthBox("packWidth", 50, mostFilmLength, 210)),
      length_(lengthBox("packLength", 50, mostFilmLength, 297)),
      spacing_(lengthBox("packSpacing", 0, 200, 3)),
      margin_(lengthBox("packMargin", leastPieceMargin, 200, leastPieceMargin)),
      turn_(new QCheckBox(tr("&Turn pieces to save film"))),
      whole_(new QCheckBox(tr("W&hole sheets with cut marks"))),
      preview_(new PicturePanel(tr("Film"), tr("Add projects and lay them out."))),
      told_(new QLabel), progress_(new QProgressBar) {
    setObjectName(QStringLiteral("packDialog"));
    setWindowTitle(tr("Several jobs on one film"));
    setAcceptDrops(true);
    told_->setObjectName(QStringLiteral("packTold"));
    told_->setWordWrap(true);
    told_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    told_->setMinimumHeight(80);
    progress_->setRange(0, 1000);
    progress_->hide();
    auto* left = new QVBoxLayout;
    left->addWidget(makeProjects(), 1);
    left->addWidget(makeFilm());
    left->addWidget(told_);
    left->addWidget(progress_);
    auto* both = new QHBoxLayout;
    both->addLayout(left, 3);
    both->addWidget(makePreview(), 4);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(both, 1);
    layout->addWidget(makeButtons());
    connect(&jobs_, &JobRunner::progressed, this, [this](double share, const QString& text) {
        progress_->setValue(int(share * 1000));
        if (!text.isEmpty()) {
            told_->setText(text);
        }
    });
    connect(&jobs_, &JobRunner::busy, this, [this] { enable(); });
    connect(&jobs_, &JobRunner::idle, this, [this] { enable(); });
    resize(980, 700);
    chooseFilm();
    tell({});
}

QWidget* PackDialog::makeProjects() {
    table_->setAccessibleName(tr("Projects on the film"));
    table_->setHorizontalHeaderLabels({tr("Project"), tr("Copies"), tr("Verdict")});
    table_->verticalHeader()->hide();
    table_->horizontalHeader()->setSectionResizeMode(Name, QHeaderView::Stretch);
    table_->horizontalHeader()->setSectionResizeMode(Judged, QHeaderView::ResizeToContents);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setTabKeyNavigation(false);
    table_->setMinimumHeight(140);
    table_->setToolTip(
        tr("You can drop project files here. The last saved version of each file is used."));
    connect(table_, &QTableWidget::itemSelectionChanged, this, &PackDialog::enable);
    auto* more = new QPushButton(tr("&Add projects…"));
    more->setObjectName(QStringLiteral("packAdd"));
    remove_ = new QPushButton(tr("&Remove"));
    remove_->setObjectName(QStringLiteral("packRemove"));
    connect(more, &QPushButton::clicked, this, &PackDialog::askProjects);
    connect(remove_, &QPushButton::clicked, this, &PackDialog::removeChosen);
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {more, remove_}) {
        button->setAutoDefault(false);
        buttons->addWidget(button);
    }
    buttons->addStretch();
    auto* box = new QWidget;
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(table_);
    layout->addLayout(buttons);
    return box;
}

QWidget* PackDialog::makeFilm() {
    film_->setAccessibleName(tr("Film"));
    film_->setToolTip(tr("The film or roll on which the pieces are placed."));
    width_->setToolTip(tr("Width of the film or roll."));
    spacing_->setToolTip(tr("Least distance between two pieces."));
    film_->setObjectName(QStringLiteral("packFilm"));
    for (const QString& name : filmSizeNames()) {
        film_->addItem(name, name);
    }
    film_->addItem(tr("Roll"), rollFilm);
    film_->addItem(tr("Custom"), customFilm);
    film_->setCurrentText(QStringLiteral("A4"));
    feed_->addItem(tr("Short edge first"), int(FeedDirection::ShortEdgeFirst));
    feed_->addItem(tr("Long edge first"), int(FeedDirection::LongEdgeFirst));
    feed_->setToolTip(tr("The edge that enters the printer first. Film swells more along its web. "
                         "A piece that swells unequally keeps its direction along the web."));
    margin_->setToolTip(tr(
        "Width of the bare film around the ink. Choose it wide: each job is computed for its whole "
        "film, and a piece that is cut close to the ink behaves differently near its edge."));
    turn_->setToolTip(
        tr("Turns pieces by 90°, but only if their film swells equally in both directions."));
    whole_->setObjectName(QStringLiteral("packWhole"));
    whole_->setToolTip(
        tr("Places whole sheets with their own marks, for an unattended series on a roll. Cut "
           "marks and the number of each copy stand in the gaps; 5 to 20 mm are usual. Otherwise "
           "only the printed parts are placed."));
    auto* box = new QWidget;
    auto* form = new QFormLayout(box);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(tr("&Film"), film_);
    form->addRow(tr("&Width"), width_);
    form->addRow(tr("&Length"), length_);
    form->addRow(tr("Fe&ed"), feed_);
    form->addRow(tr("&Spacing between pieces"), spacing_);
    form->addRow(tr("&Bare film"), margin_);
    form->addRow(turn_);
    form->addRow(whole_);
    connect(film_, &QComboBox::currentIndexChanged, this, &PackDialog::chooseFilm);
    connect(feed_, &QComboBox::currentIndexChanged, this, &PackDialog::changed);
    connect(turn_, &QCheckBox::toggled, this, &PackDialog::changed);
    connect(whole_, &QCheckBox::toggled, this, [this](bool isWhole) {
        margin_->setEnabled(!isWhole); // whole sheets have their own
        changed();
    });
    for (QDoubleSpinBox* length : {width_, length_, spacing_, margin_}) {
        connect(length, &QDoubleSpinBox::valueChanged, this, &PackDialog::changed);
    }
    return box;
}

QWidget* PackDialog::makePreview() {
    preview_->view().setMinimumSize(320, 380);
    preview_->offerTrueSize();
    shown_->setObjectName(QStringLiteral("packShown"));
    shown_->setAccessibleName(tr("Shown film"));
    shown_->setToolTip(tr("The film that the preview shows."));
    connect(shown_, &QComboBox::currentIndexChanged, this, &PackDialog::showFilm);
    auto* box = new QWidget;
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(preview_, 1);
    layout->addWidget(shown_);
    return box;
}

QWidget* PackDialog::makeButtons() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    const auto button = [&](const char* name, const QString& text, auto what) {
        auto* made = buttons->addButton(text, QDialogButtonBox::ActionRole);
        made->setObjectName(QLatin1String(name));
        connect(made, &QPushButton::clicked, this, what);
        return made;
    };
    layOut_ = button("packLayOut", tr("La&y out"), &PackDialog::layOut);
    layOut_->setToolTip(
        tr("Simulates the projects that have no result yet, then lays out all pieces."));
    layOut_->setDefault(true);
    export_ = button("packExport", tr("E&xport…"), &PackDialog::exportFilms);
    export_->setToolTip(tr("Writes each film as PDF, PNG and TIFF at true size, and a list of the "
                           "pieces with their places."));
    print_ = button("packPrint", tr("&Print…"), &PackDialog::print);
    close_ = buttons->button(QDialogButtonBox::Close);
    closeText_ = close_->text();
    close_->setAutoDefault(false); // Return must not close
    connect(buttons, &QDialogButtonBox::rejected, this, &PackDialog::reject);
    return buttons;
}

void PackDialog::add(const QStringList& projects) {
    for (const QString& path : projects) {
        const int row = table_->rowCount();
        table_->insertRow(row);
        auto* name = new QTableWidgetItem(QFileInfo(path).completeBaseName());
        name->setData(Qt::UserRole, path);
        name->setToolTip(QDir::toNativeSeparators(path));
        table_->setItem(row, Name, name);
        auto* copies = new NumberBox;
        copies->setDecimals(0);
        copies->setRange(1, 999);
        copies->setKeyboardTracking(false);
        copies->setToolTip(tr("How many copies of the project are placed on the film."));
        copies->setAccessibleName(tr("Copies of %1").arg(name->text()));
        connect(copies, &NumberBox::valueChanged, this, &PackDialog::changed);
        table_->setCellWidget(row, Copies, copies);
        table_->setItem(row, Judged, new QTableWidgetItem);
    }
    changed();
}

void PackDialog::askProjects() {
    QFileDialog dialog(this, tr("Add projects"), {}, projectFileFilter());
    dialog.setFileMode(QFileDialog::ExistingFiles);
    if (dialog.exec() == QDialog::Accepted) {
        add(dialog.selectedFiles());
    }
}

void PackDialog::removeChosen() {
    for (int row = table_->rowCount() - 1; row >= 0; --row) {
        if (table_->item(row, Name)->isSelected()) {
            table_->removeRow(row);
        }
    }
    changed();
}

void PackDialog::dragEnterEvent(QDragEnterEvent* event) {
    if (!projectsIn(*event->mimeData()).isEmpty()) {
        event->acceptProposedAction();
    }
}

void PackDialog::dropEvent(QDropEvent* event) {
    add(projectsIn(*event->mimeData()));
    event->acceptProposedAction();
}

void PackDialog::chooseFilm() {
    const QString name = film_->currentData().toString();
    const bool isNamed = name != rollFilm && name != customFilm;
    const QSignalBlocker quiet(width_), still(length_);
    if (isNamed) {
        width_->setValue(filmSize(name).width());
        length_->setValue(filmSize(name).height());
    } else if (name == rollFilm) {
        width_->setValue(610);
        length_->setValue(2000);
    }
    width_->setEnabled(!isNamed);
    length_->setEnabled(!isNamed);
    length_->setToolTip(name == rollFilm
                            ? tr("The largest length. The roll is cut off after the last piece.")
                            : QString());
    feed_->setEnabled(name != rollFilm); // a roll always enters the printer along its length
    changed();
}

PackSettings PackDialog::settings() const {
    PackSettings settings;
    settings.film.size = {width_->value(), length_->value()};
    settings.film.isRoll = film_->currentData().toString() == rollFilm;
    settings.film.spacing = Millimetres(spacing_->value());
    settings.film.margin = Millimetres(margin_->value());
    settings.feed = FeedDirection(feed_->currentData().toInt());
    settings.film.wholeSheets = whole_->isChecked();
    settings.mayTurn = turn_->isChecked();
    return settings;
}

std::vector<PackDialog::Wanted> PackDialog::wanted() const {
    std::vector<Wanted> projects;
    for (int row = 0; row < table_->rowCount(); ++row) {
        Wanted project;
        project.path = table_->item(row, Name)->data(Qt::UserRole).toString();
        project.copies = qobject_cast<NumberBox*>(table_->cellWidget(row, Copies))->wholeValue();
        const Dipped dipped = dipped_.value(project.path);
        if (dipped.written == QFileInfo(project.path).lastModified()) {
            project.dipped = dipped;
        }
        projects.push_back(project);
    }
    return projects;
}

void PackDialog::changed() {
    laid_ = {};
    shown_->clear();
    preview_->clear();
    showVerdicts();
    const std::vector<Wanted> projects = wanted();
    if (!projects.empty() && std::all_of(projects.begin(), projects.end(), [](const auto& one) {
            return one.dipped.result != nullptr;
        })) {
        layOut();
    } else {
        jobs_.cancelAll();
        ++asked_;
        tell({});
    }
}

PackDialog::LaidOut PackDialog::laidOut(std::vector<Wanted> projects, const PackSettings& settings,
                                        const SolverRegistry& registry, const Progress& progress) {
    // Returns the number of the first project with the same file as project `number`.
    const auto firstOf = [&](std::size_t number) {
        const auto same = [&](const auto& one) { return one.path == projects[number].path; };
        return std::size_t(std::find_if(projects.begin(), projects.end(), same) - projects.begin());
    };
    std::vector<ProjectToPack> read;
    for (std::size_t i = 0; i < projects.size(); ++i) {
        Wanted& project = projects[i];
        if (!project.dipped.result) {
            project.dipped.written = QFileInfo(project.path).lastModified();
        }
        read.push_back({project.dipped.result ? project.dipped.result->project
                        : firstOf(i) < i      ? read[firstOf(i)].project
                                              : loadProject(project.path),
                        project.copies});
    }
    checkProjects(read);
    std::vector<PieceToPack> pieces;
    const auto count = double(projects.size());
    for (std::size_t i = 0; i < projects.size(); ++i) {
        Wanted& project = projects[i];
        if (!project.dipped.result) {
            const Progress part =
                progress.part(0.9 * double(i) / count, 0.9 * double(i + 1) / count);
            const auto run = [&] {
                const Project& job = read[i].project;
                const auto kept =
                    usableDips(job, registry, project.path, part.silent(), [](const Error&) {});
                return std::make_shared<const JobResult>(
                    runJob(job, registry, {}, kept.get(), part));
            };
            project.dipped.result = firstOf(i) < i ? projects[firstOf(i)].dipped.result : run();
        }
        for (PieceToPack& piece : piecesOf(*project.dipped.result, project.copies, settings)) {
            pieces.push_back(std::move(piece));
        }
    }
    LaidOut laid;
    PackSettings reached = settings;
    reached.film =
        withinReach(reached.film, {}, projects.front().dipped.result->project.profiles.printer);
    laid.projects = std::move(projects);
    laid.films = std::make_shared<const PackedFilms>(packedFilms(std::move(pieces), reached));
    for (std::size_t number = 0; number < laid.films->plan.films.size(); ++number) {
        progress.cancelToken.throwIfCancelled();
        laid.previews.push_back(sheetPreview(sheetOf(*laid.films, number)));
    }
    return laid;
}

void PackDialog::layOut() {
    jobs_.cancelAll();
    const int asked = ++asked_;
    jobs_.start(std::make_unique<ValueJob<LaidOut>>(
        tr("Laying out"),
        [projects = wanted(), settings = settings(), &registry = registry_](
            const Progress& progress) { return laidOut(projects, settings, registry, progress); },
        [this, asked](LaidOut laid) {
            for (const Wanted& project : laid.projects) {
                dipped_.insert(project.path, project.dipped);
            }
            if (asked == asked_) {
                take(std::move(laid));
            }
        },
        [this, asked](std::exception_ptr failure) {
            if (asked == asked_) {
                showFailure(failure);
            }
        }));
}

void PackDialog::take(LaidOut laid) {
    laid_ = std::move(laid);
    const QStringList lines = filmsText(*laid_.films);
    shown_->clear();
    shown_->addItems(lines);
    showVerdicts();
    QString told = tr("Films: %1. They are printed at true size.").arg(lines.size());
    for (const QString& warning : filmsWarnings(*laid_.films)) {
        told += u' ' + warning + u'.';
    }
    for (const QString& lost : lostInFiles(*laid_.films)) {
        told += u' ' + tr("In exported files: %1.").arg(lost);
    }
    tell(told);
}

void PackDialog::showVerdicts() {
    for (int row = 0; row < table_->rowCount(); ++row) {
        QTableWidgetItem& cell = *table_->item(row, Judged);
        const bool isLaidOut = std::size_t(row) < laid_.projects.size();
        const QStringList lines =
            isLaidOut ? warningLines(*laid_.projects[std::size_t(row)].dipped.result, millimetres)
                      : QStringList{{}};
        cell.setText(lines.first());
        cell.setToolTip(lines.join(u'\n'));
    }
}

std::vector<std::shared_ptr<const JobResult>> PackDialog::results() const {
    std::vector<std::shared_ptr<const JobResult>> all;
    for (const Wanted& project : laid_.projects) {
        if (std::find(all.begin(), all.end(), project.dipped.result) == all.end()) {
            all.push_back(project.dipped.result);
        }
    }
    return all;
}

void PackDialog::showFilm(int number) {
    if (number >= 0 && number < int(laid_.previews.size())) {
        const SheetPreview& film = laid_.previews[std::size_t(number)];
        preview_->setPicture(film.page, film.size);
    }
}

void PackDialog::exportFilms() {
    const QString title = tr("Export films to a folder");
    const QString folder = QFileDialog::getExistingDirectory(this, title);
    if (folder.isEmpty() || !mayReplace(folder, filmFiles(), title, this)) {
        return;
    }
    jobs_.start(std::make_unique<ValueJob<bool>>(
        tr("Writing the films"),
        [films = laid_.films, folder](const Progress& progress) {
            writeFilms(*films, folder, progress);
            return true;
        },
        [this, folder, films = laid_.films](bool) {
            QStringList told{tr("Wrote the films to %1").arg(QDir::toNativeSeparators(folder))};
            told << lostInFiles(*films);
            tell(told.join(QStringLiteral(". ")) +
                 (told.size() > 1 ? QStringLiteral(".") : QString()));
        },
        [this](std::exception_ptr failure) { showFailure(failure); }));
}

// Prints the films as the sheets of one result.
void PackDialog::print() {
    auto result = std::make_shared<JobResult>();
    const Wanted& first = laid_.projects.front();
    result->project.name = tr("Several jobs");
    result->project.profiles = first.dipped.result->project.profiles;
    result->project.film.width = Millimetres(laid_.previews.front().size.width());
    result->project.film.height = Millimetres(laid_.previews.front().size.height());
    for (std::size_t number = 0; number < laid_.previews.size(); ++number) {
        ImmersionResult film;
        film.immersion.name = tr("Film %1").arg(number + 1);
        film.sheet = sheetOf(*laid_.films, number);
        result->immersions.push_back(std::move(film));
    }
    DipOutcome outcome;
    outcome.result = std::move(result);
    auto* dialog = new PrintDialog(outcome, 0, first.path, this, results());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &PrintDialog::printed, this, &PackDialog::printed);
    dialog->open();
}

void PackDialog::tell(const QString& text) {
    told_->setText(
        !text.isEmpty() ? text
        : table_->rowCount() > 0
            ? tr("Press “Lay out”. Projects that have no result yet are simulated first.")
            : tr("Add projects or drop their files here."));
    enable();
}

void PackDialog::enable() {
    const bool isBusy = jobs_.isBusy();
    progress_->setVisible(isBusy);
    close_->setText(isBusy ? tr("Cancel") : closeText_);
    remove_->setEnabled(!table_->selectionModel()->selectedRows().isEmpty());
    layOut_->setEnabled(table_->rowCount() > 0 && !isBusy);
    export_->setEnabled(laid_.films != nullptr && !isBusy);
    print_->setEnabled(laid_.films != nullptr && !isBusy);
}

void PackDialog::showFailure(std::exception_ptr failure) {
    tell(sentenceOf(failure));
}

void PackDialog::reject() {
    if (jobs_.isBusy()) {
        ++asked_;
        jobs_.cancelAll();
        tell(tr("Cancelled."));
        return;
    }
    QDialog::reject();
}

} // namespace dipwright
