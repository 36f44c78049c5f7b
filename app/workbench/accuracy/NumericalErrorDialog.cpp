#include "workbench/accuracy/NumericalErrorDialog.h"

#include "base/NumberText.h"
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
        return NumericalErrorDialog::tr("%1 %").arg(numberText(100 * share, 1));
    };
    return {shownDistance(change.distance.mean, unit),
            shownDistance(change.distance.percentile95, unit),
            shownDistance(change.distance.maximum, unit), percent(change.painted),
            percent(change.paintedOnce)};
}

QTableWidget* table(const DipNumericalError& numericalError, LengthUnit unit) {
    const QStringList columns{
        NumericalErrorDialog::tr("Mean"), NumericalErrorDialog::tr("95th percentile"),
        NumericalErrorDialog::tr("Maximum"), NumericalErrorDialog::tr("Painted in both"),
        NumericalErrorDialog::tr("Painted in one")};
    auto* table = new QTableWidget(2, int(columns.size()));
    table->setObjectName(QStringLiteral("figures"));
    table->setAccessibleName(NumericalErrorDialog::tr(
        "How far the image on the sheet moves with half the step or half the cell width"));
    table->setHorizontalHeaderLabels(columns);
    table->horizontalHeaderItem(3)->setToolTip(NumericalErrorDialog::tr(
        "Share of the part's surface that is painted in both computations"));
    table->horizontalHeaderItem(4)->setToolTip(NumericalErrorDialog::tr(
        "Share of the part's surface that is painted in only one of the two computations"));
    table->setVerticalHeaderLabels({NumericalErrorDialog::tr("With half the step"),
                                    NumericalErrorDialog::tr("With half the cell width")});
    int row = 0;
    for (const SheetChange* change : {&numericalError.halfStep, &numericalError.halfSpacing}) {
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

QWidget* page(const DipNumericalError& numericalError, LengthUnit unit) {
    QLabel* verdict = sentence(numericalErrorSentence(numericalError, unit));
    verdict->setObjectName(QStringLiteral("verdict"));
    auto* picture = new PicturePanel(NumericalErrorDialog::tr("Numerical error of the sheet"), {});
    const QImage map = mapOf(numericalError, unit);
    picture->setPicture(map, QSizeF(map.size()) / mapPixelsPerMillimetre);
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->addWidget(verdict);
    layout->addWidget(table(numericalError, unit));
    layout->addWidget(picture, 1);
    return page;
}

} // namespace

QString numericalErrorSentence(const DipNumericalError& numericalError, LengthUnit unit) {
    const QString& name = numericalError.immersion.name;
    if (numericalError.halfSpacing.painted == 0) {
        return NumericalErrorDialog::tr(
                   "%1: the dip paints nothing, so there is nothing to compare.")
            .arg(name);
    }
    const QString distance =
        shownDistance(std::max(numericalError.halfStep.distance.percentile95,
                               numericalError.halfSpacing.distance.percentile95),
                      unit);
    return isAccurateEnough(numericalError)
               ? NumericalErrorDialog::tr(
                     "%1: this sheet is accurate enough. For 95 % of it, the numerical error "
                     "is at most %2.")
                     .arg(name, distance)
               : NumericalErrorDialog::tr(
                     "%1: this sheet is not accurate enough. For 95 % of it, the numerical "
                     "error is up to %2. Use smaller film cells or more points, or turn the part.")
                     .arg(name, distance);
}

NumericalErrorDialog::NumericalErrorDialog(const std::vector<DipNumericalError>& numericalError,
                                           bool outdated, LengthUnit unit, QWidget* parent)
    : QDialog(parent) {
    setObjectName(QStringLiteral("certaintyDialog"));
    setWindowTitle(tr("Numerical error of the sheets"));
    auto* tabs = new QTabWidget;
    tabs->setDocumentMode(true);
    for (const DipNumericalError& one : numericalError) {
        tabs->addTab(page(one, unit), one.immersion.name);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QPushButton* save = buttons->addButton(tr("&Save maps…"), QDialogButtonBox::ActionRole);
    connect(save, &QPushButton::clicked, this, &NumericalErrorDialog::askFolder);
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

void NumericalErrorDialog::askFolder() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Save maps to a folder"));
    if (!folder.isEmpty()) {
        emit saveAsked(folder);
    }
}

} // namespace dipwright
