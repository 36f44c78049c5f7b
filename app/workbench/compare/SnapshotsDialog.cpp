#include "workbench/compare/SnapshotsDialog.h"

#include "base/Error.h"
#include "workbench/compare/ProjectDifferences.h"

#include <QComboBox>
#include <QDateTime>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

namespace dipwright {

namespace {

QString titleOf(const Snapshot& snapshot) {
    const QDateTime taken = QDateTime::fromString(snapshot.taken, Qt::ISODate);
    return QStringLiteral("%1 · %2").arg(snapshot.name,
                                         QLocale().toString(taken, QLocale::ShortFormat));
}

} // namespace

SnapshotsDialog::SnapshotsDialog(Document& document, LengthUnit unit, QWidget* parent)
    : QDialog(parent), document_(document), unit_(unit), name_(new QLineEdit),
      list_(new QListWidget), against_(new QComboBox), table_(new QTableWidget(0, 3)),
      verdict_(new QLabel), take_(new QPushButton(tr("&Take snapshot"))),
      goBack_(new QPushButton(tr("R&estore"))), sideBySide_(new QPushButton(tr("&Side by side…"))),
      remove_(new QPushButton(tr("&Remove"))) {
    setObjectName(QStringLiteral("snapshots"));
    setWindowTitle(tr("Snapshots"));
    auto* columns = new QHBoxLayout;
    list_->setAccessibleName(tr("Snapshots, oldest first"));
    list_->setMaximumWidth(280);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    columns->addWidget(list_);
    columns->addWidget(makeComparison(), 1);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(makeTaking());
    layout->addLayout(columns, 1);
    layout->addWidget(makeButtons());
    connect(list_, &QListWidget::currentRowChanged, this, &SnapshotsDialog::compare);
    connect(&document, &Document::projectChanged, this, &SnapshotsDialog::showSnapshots);
    resize(820, 520);
    showSnapshots();
}

QWidget* SnapshotsDialog::makeTaking() {
    name_->setObjectName(QStringLiteral("snapshotName"));
    name_->setAccessibleName(tr("Name of the snapshot"));
    name_->setPlaceholderText(tr("Name of the snapshot"));
    name_->setToolTip(tr("The name under which the settings are saved in the project file"));
    take_->setObjectName(QStringLiteral("takeSnapshot"));
    connect(name_, &QLineEdit::textChanged, this,
            [this] { take_->setEnabled(!name_->text().trimmed().isEmpty()); });
    connect(take_, &QPushButton::clicked, this, [this] {
        takeSnapshot(document_, name_->text());
        name_->clear();
        list_->setCurrentRow(list_->count() - 1);
    });
    take_->setEnabled(false);
    auto* box = new QWidget;
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(name_, 1);
    row->addWidget(take_);
    return box;
}

QWidget* SnapshotsDialog::makeComparison() {
    against_->setObjectName(QStringLiteral("against"));
    against_->setAccessibleName(tr("Compared with"));
    against_->setToolTip(tr("Compared with"));
    connect(against_, &QComboBox::currentIndexChanged, this, &SnapshotsDialog::compare);
    table_->setAccessibleName(tr("Differences"));
    table_->setHorizontalHeaderLabels({tr("Setting"), tr("Snapshot"), tr("Current")});
    table_->verticalHeader()->hide();
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setTabKeyNavigation(false);
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    verdict_->setObjectName(QStringLiteral("difference"));
    verdict_->setWordWrap(true);
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(against_);
    column->addWidget(verdict_);
    column->addWidget(table_, 1);
    return box;
}

QWidget* SnapshotsDialog::makeButtons() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(sideBySide_, QDialogButtonBox::ActionRole);
    buttons->addButton(goBack_, QDialogButtonBox::ActionRole);
    sideBySide_->setObjectName(QStringLiteral("sideBySide"));
    sideBySide_->setToolTip(tr("Shows both versions side by side in linked views. Dips that have "
                               "no result yet are run first."));
    connect(sideBySide_, &QPushButton::clicked, this, &SnapshotsDialog::compareInView);
    buttons->addButton(remove_, QDialogButtonBox::ActionRole);
    goBack_->setObjectName(QStringLiteral("goBack"));
    goBack_->setToolTip(tr("Restores the settings of the snapshot. Model, photos and measured "
                           "parts stay. This can be undone."));
    remove_->setObjectName(QStringLiteral("removeSnapshot"));
    connect(goBack_, &QPushButton::clicked, this, [this] {
        try {
            restoreSnapshot(document_, std::size_t(list_->currentRow()));
        } catch (const Error& error) {
            verdict_->setText(error.sentence());
        }
    });
    connect(remove_, &QPushButton::clicked, this,
            [this] { removeSnapshot(document_, std::size_t(list_->currentRow())); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    return buttons;
}

void SnapshotsDialog::showSnapshots() {
    const QSignalBlocker quietList(list_), quietBox(against_);
    const int row = list_->currentRow(), other = against_->currentIndex();
    snapshots_ = snapshots(document_.project());
    list_->clear();
    against_->clear();
    against_->addItem(tr("Compared with the current project"));
    for (const Snapshot& snapshot : snapshots_) {
        auto* item = new QListWidgetItem(titleOf(snapshot), list_);
        item->setToolTip(item->text());
        against_->addItem(tr("Compared with %1").arg(titleOf(snapshot)));
    }
    list_->setCurrentRow(std::min(std::max(row, 0), list_->count() - 1));
    against_->setCurrentIndex(other > 0 && other < against_->count() ? other : 0);
    compare();
}

void SnapshotsDialog::addRow(const QString& setting, const QString& first, const QString& second) {
    const int row = table_->rowCount();
    table_->insertRow(row);
    for (const auto& [column, text] :
         {std::pair(0, setting), std::pair(1, first), std::pair(2, second)}) {
        auto* item = new QTableWidgetItem(text);
        item->setToolTip(text);
        table_->setItem(row, column, item);
    }
}

void SnapshotsDialog::showMeasures(const QJsonObject& first, const QJsonObject& second) {
    const std::vector<StateFigure> before = stateFigures(first, unit_);
    const std::vector<StateFigure> after = stateFigures(second, unit_);
    for (std::size_t row = 0; row < before.size(); ++row) {
        addRow(before[row].name, before[row].text(), after[row].text());
    }
}

// Compares the selected snapshot with the state selected in the box.
void SnapshotsDialog::compareInView() {
    const Snapshot& chosen = snapshots_[std::size_t(list_->currentRow())];
    const int other = against_->currentIndex();
    const Project& now = document_.project();
    try {
        ComparedState second{tr("Current"), now, {}};
        if (other > 0) {
            const Snapshot& snapshot = snapshots_[std::size_t(other - 1)];
            second = {snapshot.name, atSnapshot(now, snapshot), {}};
        }
        emit comparisonAsked({ComparedState{chosen.name, atSnapshot(now, chosen), {}}, second});
    } catch (const Error& error) {
        verdict_->setText(error.sentence());
    }
}

void SnapshotsDialog::compare() {
    const bool any = list_->currentRow() >= 0;
    goBack_->setEnabled(any);
    sideBySide_->setEnabled(any && document_.project().model);
    remove_->setEnabled(any);
    table_->setRowCount(0);
    verdict_->clear();
    if (!any) {
        verdict_->setText(
            tr("A snapshot saves the project's settings under a name in the project file."));
        return;
    }
    const Snapshot& chosen = snapshots_[std::size_t(list_->currentRow())];
    const int other = against_->currentIndex();
    const bool isNow = other <= 0;
    table_->setHorizontalHeaderLabels(
        {tr("Setting"), chosen.name,
         isNow ? tr("Current") : snapshots_[std::size_t(other - 1)].name});
    try {
        const Project first = atSnapshot(document_.project(), chosen);
        const Project second =
            isNow ? document_.project()
                  : atSnapshot(document_.project(), snapshots_[std::size_t(other - 1)]);
        const std::vector<ProjectDifference> found = projectDifferences(first, second, unit_);
        for (const ProjectDifference& difference : found) {
            addRow(difference.setting, difference.first, difference.second);
        }
        verdict_->setText(found.empty() ? tr("All settings are the same.")
                                        : tr("Settings that differ: %1").arg(found.size()));
        showMeasures(chosen.measures, isNow ? snapshotMeasures(document_)
                                            : snapshots_[std::size_t(other - 1)].measures);
    } catch (const Error& error) {
        verdict_->setText(error.sentence());
        goBack_->setEnabled(false);
        sideBySide_->setEnabled(false);
    }
}

} // namespace dipwright
