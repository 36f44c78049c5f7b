#include "workbench/accuracy/CertaintyDialog.h"

#include "workbench/widgets/PicturePanel.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace dipwright {

namespace {

constexpr double mapPixelsPerMillimetre = 8; // sets the map's size on the screen

QString shownDistance(double millimetres, LengthUnit unit) {
    return shownLength(millimetres, unit, 1);
}

QStringList figures(const SheetChange& change, LengthUnit unit) {
    const auto percent = [](double share) {
        return CertaintyDialog::tr("%1 %").arg(QLocale().toString(100 * share, 'f', 1));
    };
    return {shownDistance(change.distance.mean, unit),
            shownDistance(change.distance.percentile95, unit),
            shownDistance(change.distance.maximum, unit), percent(change.painted),
            percent(change.paintedOnce)};
}

QTableWidget* table(const ImmersionCertainty& certainty, LengthUnit unit) {
    const QStringList columns{
        CertaintyDialog::tr("Mean"), CertaintyDialog::tr("95 %"), CertaintyDialog::tr("Maximum"),
        CertaintyDialog::tr("Painted in both"), CertaintyDialog::tr("Painted in one")};
    auto* table = new QTableWidget(2, int(columns.size()));
    table->setObjectName(QStringLiteral("figures"));
    table->setAccessibleName(CertaintyDialog::tr("How far the sheet moves"));
    table->setHorizontalHeaderLabels(columns);
    table->horizontalHeaderItem(3)->setToolTip(
        CertaintyDialog::tr("Share of the part's surface that is painted in both computations"));
    table->horizontalHeaderItem(4)->setToolTip(CertaintyDialog::tr(
        "Share of the part's surface that is painted in only one of the two computations"));
    table->setVerticalHeaderLabels({CertaintyDialog::tr("With half the step"),
                                    CertaintyDialog::tr("With half the cell width")});
    int row = 0;
    for (const SheetChange* change : {&certainty.halfStep, &certainty.halfSpacing}) {
        const QStringList texts = figures(*change, unit);
        for (int column = 0; column < texts.size(); ++column) {
            auto* item = new QTableWidgetItem(texts[column]);
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

QLabel* sentence(const QString& text) {
    auto* label = new QLabel(text);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

QWidget* page(const ImmersionCertainty& certainty, LengthUnit unit) {
    QLabel* verdict = sentence(numericalErrorSentence(certainty, unit));
    verdict->setObjectName(QStringLiteral("verdict"));
    auto* picture = new PicturePanel(CertaintyDialog::tr("Numerical error of the sheet"), {});
    const QImage map = mapOf(certainty, unit);
    picture->setPicture(map, QSizeF(map.size()) / mapPixelsPerMillimetre);
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->addWidget(verdict);
    layout->addWidget(table(certainty, unit));
    layout->addWidget(picture, 1);
    return page;
}

} // namespace

QString numericalErrorSentence(const ImmersionCertainty& certainty, LengthUnit unit) {
    const QString& name = certainty.immersion.name;
    if (certainty.halfSpacing.painted == 0) {
        return CertaintyDialog::tr("%1: the dip paints nothing, so there is nothing to compare.")
            .arg(name);
    }
    const QString distance = shownDistance(std::max(certainty.halfStep.distance.percentile95,
                                                    certainty.halfSpacing.distance.percentile95),
                                           unit);
    return isCertain(certainty)
               ? CertaintyDialog::tr("%1: this sheet is accurate enough. 95 % of it is within %2 "
                                     "(numerical error).")
                     .arg(name, distance)
               : CertaintyDialog::tr("%1: this sheet is not accurate enough. 95 % of it is only "
                                     "within %2 (numerical error). Use smaller film cells or more "
                                     "points, turn the part, or dip it twice.")
                     .arg(name, distance);
}

CertaintyDialog::CertaintyDialog(const std::vector<ImmersionCertainty>& certainty, bool outdated,
                                 LengthUnit unit, QWidget* parent)
    : QDialog(parent) {
    setObjectName(QStringLiteral("certaintyDialog"));
    setWindowTitle(tr("Numerical error of the sheets"));
    auto* tabs = new QTabWidget;
    tabs->setDocumentMode(true);
    for (const ImmersionCertainty& one : certainty) {
        tabs->addTab(page(one, unit), one.immersion.name);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QPushButton* save = buttons->addButton(tr("&Save maps…"), QDialogButtonBox::ActionRole);
    connect(save, &QPushButton::clicked, this, &CertaintyDialog::askFolder);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    if (outdated) {
        layout->addWidget(
            sentence(tr("The project has changed since these figures were computed.")));
    }
    layout->addWidget(tabs, 1);
    layout->addWidget(buttons);
    resize(860, 720);
}

void CertaintyDialog::askFolder() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Save maps to a folder"));
    if (!folder.isEmpty()) {
        emit saveAsked(folder);
    }
}

} // namespace dipwright
