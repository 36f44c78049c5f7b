#include "workbench/queue/QueueDialog.h"

#include "base/NumberText.h"
#include "workbench/jobs/TimeLeft.h"
#include "workbench/project/NewProjectDialog.h"

#include <QApplication>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

enum Column { Name, State, Outcome, Took, Columns };

constexpr int detailsHeight = 110; // pixels

QString stateText(const QueuedProject& project) {
    switch (project.state) {
    case QueuedState::Waiting:
        return QueueDialog::tr("Waiting");
    case QueuedState::Running:
        return QueueDialog::tr("Running");
    case QueuedState::Done:
        return QueueDialog::tr("Done");
    case QueuedState::Failed:
        return QueueDialog::tr("Failed");
    case QueuedState::Cancelled:
        break;
    }
    return QueueDialog::tr("Cancelled");
}

QString timeText(double seconds) {
    const QLocale locale;
    return seconds < 90
               ? QueueDialog::tr("%1 s").arg(locale.toString(std::ceil(seconds), 'f', 0))
               : QueueDialog::tr("%1 min").arg(locale.toString(std::ceil(seconds / 60), 'f', 0));
}

bool hasEnded(const QueuedProject& project) {
    return project.state != QueuedState::Waiting && project.state != QueuedState::Running;
}

} // namespace

QueueDialog::QueueDialog(JobQueue& queue, QWidget* parent)
    : QDialog(parent), queue_(queue), table_(new QTableWidget(0, Columns)),
      details_(new QPlainTextEdit), folder_(new QLineEdit), sum_(new QLabel) {
    setObjectName(QStringLiteral("jobQueue"));
    setWindowTitle(tr("Job queue"));
    table_->setAccessibleName(tr("Projects in the queue"));
    table_->setHorizontalHeaderLabels({tr("Project"), tr("State"), tr("Result"), tr("Duration")});
    table_->verticalHeader()->hide();
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setSectionResizeMode(Outcome, QHeaderView::Stretch);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setTabKeyNavigation(false);
    table_->setWordWrap(false);
    details_->setObjectName(QStringLiteral("queueDetails"));
    details_->setAccessibleName(tr("Result of the selected project"));
    details_->setReadOnly(true);
    details_->setTabChangesFocus(true);
    details_->setFixedHeight(detailsHeight);
    sum_->setObjectName(QStringLiteral("queueSum"));
    sum_->setWordWrap(true);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    const auto button = [&](const char* name, const QString& text, auto what) {
        auto* made = buttons->addButton(text, QDialogButtonBox::ActionRole);
        made->setObjectName(QLatin1String(name));
        made->setAutoDefault(false);
        connect(made, &QPushButton::clicked, this, what);
        return made;
    };
    button("addToQueue", tr("&Add projects…"), [this] { addProjects(); });
    cancel_ = button("cancelQueued", tr("&Cancel selected"), [this] {
        for (const std::size_t row : chosenRows()) {
            queue_.cancel(row);
        }
    });
    cancelAll_ = button("cancelQueue", tr("Cancel a&ll"), [this] { queue_.cancelAll(); });
    remove_ = button("removeEnded", tr("&Remove finished"), [this] { queue_.removeEnded(); });
    open_ = button("openQueued", tr("&Open project"),
                   [this] { emit projectAsked(queue_.projects()[chosenRows().front()].project); });
    tank_ = button("tankQueued", tr("At the tan&k…"), [this] { emit tankAsked(tankJobs()); });
    tank_->setToolTip(tr("Opens the tank-side page with the steps of all finished projects"));
    connect(buttons, &QDialogButtonBox::rejected, this, &QueueDialog::reject);
    connect(table_, &QTableWidget::itemSelectionChanged, this, &QueueDialog::showChosen);
    connect(&queue, &JobQueue::changed, this, &QueueDialog::refresh);
    connect(&queue, &JobQueue::ended, this, [this] {
        refresh();
        QApplication::alert(this);
    });
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(makeFolderRow());
    layout->addWidget(table_, 1);
    layout->addWidget(details_);
    layout->addWidget(sum_);
    layout->addWidget(buttons);
    resize(860, 500);
    refresh();
}

QLayout* QueueDialog::makeFolderRow() {
    folder_->setObjectName(QStringLiteral("queueFolder"));
    folder_->setAccessibleName(tr("Folder for the results"));
    folder_->setText(QDir::toNativeSeparators(QDir::homePath()));
    folder_->setToolTip(tr("Each added project gets a subfolder with its name here."));
    auto* choose = new QPushButton(tr("C&hoose…"));
    connect(choose, &QPushButton::clicked, this, &QueueDialog::askFolder);
    auto* label = new QLabel(tr("Resul&ts folder"));
    label->setBuddy(folder_);
    auto* where = new QHBoxLayout;
    where->addWidget(label);
    where->addWidget(folder_, 1);
    where->addWidget(choose);
    return where;
}

void QueueDialog::propose(const QString& project) {
    if (!project.isEmpty() && queue_.projects().empty()) {
        folder_->setText(QDir::toNativeSeparators(QFileInfo(project).path()));
    }
}

void QueueDialog::addProjects() {
    QFileDialog dialog(this, tr("Add projects"), QDir::fromNativeSeparators(folder_->text()),
                       projectFileFilter());
    dialog.setFileMode(QFileDialog::ExistingFiles);
    if (dialog.exec() == QDialog::Accepted) {
        queue_.add(dialog.selectedFiles(), QDir::fromNativeSeparators(folder_->text()));
    }
}

void QueueDialog::askFolder() {
    const QString folder = QFileDialog::getExistingDirectory(
        this, tr("Folder for the results"), QDir::fromNativeSeparators(folder_->text()));
    if (!folder.isEmpty()) {
        folder_->setText(QDir::toNativeSeparators(folder));
    }
}

std::vector<std::size_t> QueueDialog::chosenRows() const {
    std::vector<std::size_t> rows;
    for (const QModelIndex& row : table_->selectionModel()->selectedRows()) {
        rows.push_back(std::size_t(row.row()));
    }
    return rows;
}

std::vector<TankJob> QueueDialog::tankJobs() const {
    std::vector<TankJob> jobs;
    for (const QueuedProject& project : queue_.projects()) {
        if (project.tank) {
            jobs.push_back(*project.tank);
        }
    }
    return jobs;
}

void QueueDialog::refresh() {
    const std::vector<QueuedProject>& projects = queue_.projects();
    table_->setRowCount(int(projects.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const QueuedProject& project = projects[std::size_t(row)];
        const QString state = project.state == QueuedState::Running
                                  ? tr("%1 %").arg(numberText(std::floor(100 * project.share), 0))
                                  : stateText(project);
        const std::array<QString, Columns> texts{
            QFileInfo(project.project).completeBaseName(), state, project.text,
            hasEnded(project) && project.seconds > 0 ? timeText(project.seconds) : QString()};
        for (int column = 0; column < Columns; ++column) {
            QTableWidgetItem* item = table_->item(row, column);
            if (!item) {
                item = new QTableWidgetItem;
                table_->setItem(row, column, item);
            }
            const QString& text = texts[std::size_t(column)];
            item->setText(QString(text).replace(u'\n', u' '));
            item->setToolTip(column == Name ? tr("%1\nResults: %2")
                                                  .arg(QDir::toNativeSeparators(project.project),
                                                       QDir::toNativeSeparators(project.folder))
                                            : text);
            if (column == Took) {
                item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            }
        }
    }
    showChosen();
}

void QueueDialog::showChosen() {
    const std::vector<QueuedProject>& projects = queue_.projects();
    const std::vector<std::size_t> rows = chosenRows();
    const auto ended = std::count_if(projects.begin(), projects.end(), hasEnded);
    cancel_->setEnabled(std::any_of(rows.begin(), rows.end(), [&](std::size_t row) {
        return row < projects.size() && !hasEnded(projects[row]);
    }));
    cancelAll_->setEnabled(ended < std::ptrdiff_t(projects.size()));
    remove_->setEnabled(ended > 0);
    tank_->setEnabled(!tankJobs().empty());
    const bool isOne = rows.size() == 1 && rows.front() < projects.size();
    open_->setEnabled(isOne);
    const QString details = isOne ? projects[rows.front()].text : QString();
    if (details != details_->toPlainText()) { // keeps the place that the user reads
        details_->setPlainText(details);
    }
    details_->setVisible(!details.isEmpty());
    if (projects.empty()) {
        sum_->setText(tr("Add projects. They run one after the other, each in its last saved "
                         "version. The results are written to the results folder."));
        return;
    }
    QString sum = tr("%1 of %2 finished").arg(ended).arg(projects.size());
    if (const auto left = queue_.secondsLeft(); left && queue_.isBusy()) {
        sum += QStringLiteral(", ") + timeLeftText(steadySeconds(*left, {}));
    }
    sum_->setText(sum);
}

void QueueDialog::reject() {
    if (queue_.isBusy()) {
        QMessageBox question(QMessageBox::Question, tr("Job queue"),
                             tr("Projects are still running. Stop them?"), QMessageBox::Cancel,
                             this);
        question.setObjectName(QStringLiteral("stopQuestion"));
        question.setInformativeText(tr("Finished results are kept."));
        QPushButton* stop = question.addButton(tr("&Stop"), QMessageBox::DestructiveRole);
        question.setDefaultButton(QMessageBox::Cancel);
        question.exec();
        if (question.clickedButton() != stop) {
            return;
        }
        queue_.cancelAll();
    }
    QDialog::reject();
}

} // namespace dipwright
