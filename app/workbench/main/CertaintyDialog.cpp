#include "main/CertaintyDialog.h"

#include "panels/PicturePanel.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>

namespace dipwright {

namespace {

constexpr double mapPixelsPerMillimetre = 8; // the map has no size of its own

// What stands in the table's columns.
using Figure = double SheetChange::*;
constexpr std::array<Figure, 4> figures{&SheetChange::median, &SheetChange::percentile95,
                                        &SheetChange::percentile99, &SheetChange::maximum};

QTableWidget* table(const ImmersionCertainty& certainty, LengthUnit unit) {
    auto* table = new QTableWidget(2, int(figures.size()));
    table->setObjectName(QStringLiteral("figures"));
    table->setAccessibleName(CertaintyDialog::tr("How far the sheet moves"));
    table->setHorizontalHeaderLabels({CertaintyDialog::tr("Median"), CertaintyDialog::tr("95 %"),
                                      CertaintyDialog::tr("99 %"), CertaintyDialog::tr("Most")});
    table->setVerticalHeaderLabels({CertaintyDialog::tr("With steps half as long"),
                                    CertaintyDialog::tr("With film cells half as wide")});
    int row = 0;
    for (const SheetChange* change : {&certainty.halfStep, &certainty.halfSpacing}) {
        for (int column = 0; column < int(figures.size()); ++column) {
            auto* item =
                new QTableWidgetItem(shownLength(change->*figures[std::size_t(column)], unit));
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            table->setItem(row, column, item);
        }
        ++row;
    }
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionMode(QAbstractItemView::ContiguousSelection);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->setFixedHeight(table->horizontalHeader()->sizeHint().height() +
                          2 * table->verticalHeader()->defaultSectionSize() +
                          2 * table->frameWidth());
    return table;
}

QWidget* page(const ImmersionCertainty& certainty, const QImage& map, LengthUnit unit) {
    const QStringList warnings = certaintyWarnings({certainty});
    auto* verdict = new QLabel(
        warnings.isEmpty()
            ? CertaintyDialog::tr("%1: this sheet is certain. 95 % of it moves by no more than "
                                  "%2 when it is computed more finely.")
                  .arg(certainty.immersion.name,
                       shownLength(std::max(certainty.halfStep.percentile95,
                                            certainty.halfSpacing.percentile95),
                                   unit))
            : warnings.front());
    verdict->setObjectName(QStringLiteral("verdict"));
    verdict->setWordWrap(true);
    verdict->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* picture = new PicturePanel(CertaintyDialog::tr("Certainty of the sheet"), {});
    picture->setPicture(map, QSizeF(map.size()) / mapPixelsPerMillimetre);
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->addWidget(verdict);
    layout->addWidget(table(certainty, unit));
    layout->addWidget(picture, 1);
    return page;
}

} // namespace

CertaintyDialog::CertaintyDialog(const CertaintyOutcome& outcome, LengthUnit unit, QWidget* parent)
    : QDialog(parent) {
    setObjectName(QStringLiteral("certaintyDialog"));
    setWindowTitle(tr("Certainty of the Sheets"));
    auto* tabs = new QTabWidget;
    tabs->setDocumentMode(true);
    for (std::size_t number = 0; number < outcome.immersions.size(); ++number) {
        tabs->addTab(page(outcome.immersions[number], outcome.maps[number], unit),
                     outcome.immersions[number].immersion.name);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QPushButton* save = buttons->addButton(tr("&Save Maps…"), QDialogButtonBox::ActionRole);
    connect(save, &QPushButton::clicked, this, &CertaintyDialog::askFolder);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(tabs, 1);
    layout->addWidget(buttons);
    resize(760, 720);
}

void CertaintyDialog::askFolder() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Save Maps to a Folder"));
    if (!folder.isEmpty()) {
        emit saveAsked(folder);
    }
}

} // namespace dipwright
