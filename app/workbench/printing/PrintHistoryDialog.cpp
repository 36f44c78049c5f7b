#include "workbench/printing/PrintHistoryDialog.h"

#include "base/NumberText.h"
#include "workbench/widgets/Units.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QStringList>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace dipwright {

namespace {

enum Column { When, Job, ProjectName, Dip, Printer, Medium, Copies, Fate, Columns };

QString sizeText(QSizeF size, LengthUnit unit) {
    const auto side = [unit](double millimetres) {
        return roundedText(millimetres * shownPerStored(Unit::Length, unit), 4);
    };
    return QStringLiteral("%1 × %2%3")
        .arg(side(size.width()), side(size.height()), unitSuffix(Unit::Length, unit));
}

// Returns a record's cells in the order of the columns.
QStringList cells(const PrintRecord& record, LengthUnit unit) {
    return {QLocale().toString(record.when, QLocale::ShortFormat),
            record.job,
            record.project,
            record.immersion,
            record.file.isEmpty() ? record.printer : QFileInfo(record.file).fileName(),
            sizeText(record.mediumSize, unit),
            QLocale().toString(record.copies),
            outcomeText(record)};
}

bool holdsAll(const QString& text, const QStringList& words) {
    return std::all_of(words.begin(), words.end(), [&text](const QString& word) {
        return text.contains(word, Qt::CaseInsensitive);
    });
}

// Returns the facts that do not fit into the table, one on each line.
QString factsText(const PrintRecord& record) {
    QStringList lines{outcomeText(record)};
    const auto add = [&lines](const QString& sentence, const QString& fact) {
        if (!fact.isEmpty()) {
            lines.append(sentence.arg(fact));
        }
    };
    add(PrintHistoryDialog::tr("Project file: %1"),
        QDir::toNativeSeparators(record.source.projectFile));
    add(PrintHistoryDialog::tr("Written to: %1"), QDir::toNativeSeparators(record.file));
    add(PrintHistoryDialog::tr("Film: %1"), record.source.film);
    add(PrintHistoryDialog::tr("Printer profile: %1"), record.profile);
    add(PrintHistoryDialog::tr("Paper name in the printer: %1"), record.mediumName);
    if (record.source.projectFile.isEmpty()) {
        lines.append(PrintHistoryDialog::tr("The project had not been saved when it was printed."));
    } else if (!QFileInfo::exists(record.source.projectFile)) {
        lines.append(PrintHistoryDialog::tr("The project file no longer exists."));
    }
    return lines.join(QLatin1Char('\n'));
}

} // namespace

PrintHistoryDialog::PrintHistoryDialog(const PrintHistory& history, LengthUnit unit,
                                       QWidget* parent)
    : QDialog(parent), unit_(unit), search_(new QLineEdit), table_(new QTableWidget(0, Columns)),
      facts_(new QLabel) {
    setObjectName(QStringLiteral("printHistory"));
    setWindowTitle(tr("Print history"));
    search_->setObjectName(QStringLiteral("search"));
    search_->setAccessibleName(tr("Search"));
    search_->setPlaceholderText(tr("Job number on the sheet, project, printer …"));
    search_->setToolTip(
        tr("Shows the prints that contain all words typed here. Parts of words are enough."));
    search_->setClearButtonEnabled(true);
    connect(search_, &QLineEdit::textChanged, this, &PrintHistoryDialog::showFound);
    table_->setAccessibleName(tr("Prints, newest first"));
    table_->setHorizontalHeaderLabels({tr("Time"), tr("Job"), tr("Project"), tr("Dip"),
                                       tr("Printer or file"), tr("Paper"), tr("Copies"),
                                       tr("Outcome")});
    table_->verticalHeader()->hide();
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    for (const int column : {ProjectName, Fate}) { // elided; the facts below show them whole
        table_->horizontalHeader()->setSectionResizeMode(column, QHeaderView::Stretch);
    }
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setTabKeyNavigation(false);
    table_->setWordWrap(false);
    connect(table_, &QTableWidget::itemSelectionChanged, this, &PrintHistoryDialog::showChosen);
    connect(table_, &QTableWidget::cellActivated, this, &PrintHistoryDialog::openChosen);
    facts_->setObjectName(QStringLiteral("facts"));
    facts_->setWordWrap(true);
    facts_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    facts_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    open_ = buttons->addButton(tr("&Open project"), QDialogButtonBox::ActionRole);
    open_->setObjectName(QStringLiteral("openProject"));
    connect(open_, &QPushButton::clicked, this, &PrintHistoryDialog::openChosen);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(search_);
    layout->addWidget(table_, 1);
    layout->addWidget(facts_);
    layout->addWidget(buttons);
    resize(960, 560);
    showChosen();
    jobs_.start(std::make_unique<ValueJob<std::vector<PrintRecord>>>(
        tr("Reading the print history"), [history](const Progress&) { return history.records(); },
        [this](std::vector<PrintRecord> records) { showRecords(std::move(records)); },
        [](std::exception_ptr) {})); // reading never throws
}

void PrintHistoryDialog::showRecords(std::vector<PrintRecord> records) {
    records_ = std::move(records);
    table_->setRowCount(int(records_.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const PrintRecord& record = records_[std::size_t(row)];
        const QStringList texts = cells(record, unit_);
        for (int column = 0; column < Columns; ++column) {
            auto* item = new QTableWidgetItem(texts[column]);
            item->setToolTip(texts[column]);
            if (column == Copies || column == Medium) {
                item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            }
            table_->setItem(row, column, item);
        }
    }
    showFound();
}

void PrintHistoryDialog::showFound() {
    static const QRegularExpression spaces(QStringLiteral("\\s+"));
    const QStringList words = search_->text().split(spaces, Qt::SkipEmptyParts);
    int first = -1;
    for (int row = 0; row < table_->rowCount(); ++row) {
        const PrintRecord& record = records_[std::size_t(row)];
        const bool found = holdsAll(cells(record, unit_).join(QLatin1Char('\n')) +
                                        QLatin1Char('\n') + factsText(record),
                                    words);
        table_->setRowHidden(row, !found);
        first = found && first < 0 ? row : first;
    }
    if (first >= 0) {
        table_->selectRow(first);
    } else {
        table_->clearSelection();
    }
    showChosen();
}

const PrintRecord* PrintHistoryDialog::chosen() const {
    const QModelIndexList rows = table_->selectionModel()->selectedRows();
    return rows.isEmpty() ? nullptr : &records_[std::size_t(rows.front().row())];
}

void PrintHistoryDialog::showChosen() {
    const PrintRecord* record = chosen();
    open_->setEnabled(record && QFileInfo::exists(record->source.projectFile));
    facts_->setText(record             ? factsText(*record)
                    : jobs_.isBusy()   ? tr("Reading the print history …")
                    : records_.empty() ? tr("Nothing has been printed yet.")
                                       : tr("No print contains these words."));
}

void PrintHistoryDialog::openChosen() {
    if (open_->isEnabled()) {
        emit projectAsked(chosen()->source.projectFile);
        accept();
    }
}

} // namespace dipwright
