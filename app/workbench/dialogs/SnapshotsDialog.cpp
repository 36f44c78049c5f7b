#include "dialogs/SnapshotsDialog.h"

#include "base/Error.h"
#include "panels/ProjectDifferences.h"

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
      verdict_(new QLabel), take_(new QPushButton(tr("&Take Snapshot"))),
      goBack_(new QPushButton(tr("&Go Back to It"))), remove_(new QPushButton(tr("&Remove"))) {
    setObjectName(QStringLiteral("snapshots"));
    setWindowTitle(tr("Snapshots"));
    auto* columns = new QHBoxLayout;
    list_->setAccessibleName(tr("Snapshots, the oldest first"));
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
    name_->setToolTip(tr("Under which the project's settings are kept in its file"));
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
    table_->setAccessibleName(tr("What differs"));
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
    buttons->addButton(goBack_, QDialogButtonBox::ActionRole);
    buttons->addButton(remove_, QDialogButtonBox::ActionRole);
    goBack_->setObjectName(QStringLiteral("goBack"));
    goBack_->setToolTip(tr("The settings become those of the snapshot: a step that can be undone. "
                           "Model, photos and parts stay."));
    remove_->setObjectName(QStringLiteral("removeSnapshot"));
    connect(goBack_, &QPushButton::clicked, this, [this] {
        try {
            goBackTo(document_, std::size_t(list_->currentRow()));
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
    against_->addItem(tr("Compared with the project as it is now"));
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
    const auto row = [&](const QString& name, const char* key, const auto& text) {
        const auto of = [&](const QJsonObject& measures) {
            const QJsonValue value = measures.value(QLatin1String(key));
            return value.isDouble() ? QString(text(value.toDouble())) : tr("no result");
        };
        addRow(name, of(first), of(second));
    };
    row(tr("Body painted altogether"), "painted",
        [](double share) { return tr("%1 %").arg(QLocale().toString(100 * share, 'f', 1)); });
    row(tr("Largest stretch of 95 % of the film on the body"), "stretch",
        [](double stretch) { return QLocale().toString(stretch, 'f', 3); });
    row(tr("Area that is not certain"), "uncertain_mm2",
        [this](double area) { return shownArea(area, unit_); });
}

void SnapshotsDialog::compare() {
    const bool any = list_->currentRow() >= 0;
    goBack_->setEnabled(any);
    remove_->setEnabled(any);
    table_->setRowCount(0);
    verdict_->clear();
    if (!any) {
        verdict_->setText(tr("A snapshot keeps the project's settings under a name, in its file."));
        return;
    }
    const Snapshot& chosen = snapshots_[std::size_t(list_->currentRow())];
    const int other = against_->currentIndex();
    const bool isNow = other <= 0;
    table_->setHorizontalHeaderLabels(
        {tr("Setting"), chosen.name, isNow ? tr("Now") : snapshots_[std::size_t(other - 1)].name});
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
    }
}

} // namespace dipwright
