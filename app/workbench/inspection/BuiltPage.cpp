#include "workbench/inspection/BuiltPage.h"

#include "accuracy/correction/SheetCorrection.h"
#include "base/NumberText.h"
#include "cost/CostText.h"
#include "traveller/TankTasks.h"
#include "workbench/widgets/NumberBox.h"
#include "workbench/widgets/PicturePanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

namespace dipwright {

namespace {

constexpr int pictureHeight = 1200; // pixels
constexpr int rows = 4;             // parts visible without scrolling

// Tells which dips of a part were as the job's dips are now.
QString alikeText(const BuiltPart& part, const QStringList& dips) {
    if (part.dips.isEmpty() || dips.isEmpty()) {
        return BuiltPage::tr("not known");
    }
    QStringList alike;
    for (int dip = 1; dip <= dips.size(); ++dip) {
        if (isDippedAlike(part, dip, dips).value_or(false)) {
            alike << QString::number(dip);
        }
    }
    if (alike.size() == dips.size()) {
        return BuiltPage::tr("yes");
    }
    return alike.isEmpty() ? BuiltPage::tr("no")
                           : BuiltPage::tr("only dip %1").arg(alike.join(QStringLiteral(", ")));
}

} // namespace

BuiltPage::BuiltPage(QWidget* parent)
    : QWidget(parent), parts_(new QTableWidget(0, 5)), times_(new QTableWidget(0, 4)),
      acceptedBy_(new QLineEdit), corrects_(new QCheckBox(tr("&Correct the next sheets"))),
      strength_(new NumberBox), dip_(new QComboBox), hint_(new QLabel), words_(new QLabel),
      legend_(new QLabel),
      picture_(new PicturePanel(tr("Repeating error and correction"),
                                tr("The repeating error of the parts is shown here."))) {
    parts_->setObjectName(QStringLiteral("builtParts"));
    parts_->setAccessibleName(tr("Measured parts of the job"));
    parts_->setHorizontalHeaderLabels(
        {tr("Date"), tr("Accepted by"), tr("Photos"), tr("Error"), tr("Dips as now")});
    parts_->horizontalHeaderItem(3)->setToolTip(
        tr("Root mean square of the part's error, measured on the sheet"));
    parts_->horizontalHeaderItem(4)->setToolTip(
        tr("Whether the part was dipped with the present pose, film, process and model. The next "
           "sheets are corrected without dips of which this is not so."));
    parts_->verticalHeader()->hide();
    parts_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    parts_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    parts_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    parts_->setSelectionMode(QAbstractItemView::NoSelection);
    parts_->setFixedHeight(parts_->horizontalHeader()->sizeHint().height() +
                           rows * parts_->verticalHeader()->defaultSectionSize() + 6);
    times_->setObjectName(QStringLiteral("tankTimes"));
    times_->setAccessibleName(tr("Times at the tank"));
    times_->setHorizontalHeaderLabels({tr("At the tank"), tr("Runs"), tr("Planned"), tr("Took")});
    times_->horizontalHeaderItem(3)->setToolTip(
        tr("Mean of all runs, and the shortest and longest run"));
    times_->verticalHeader()->hide();
    times_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    times_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    times_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    times_->setSelectionMode(QAbstractItemView::NoSelection);
    times_->setMinimumHeight(parts_->horizontalHeader()->sizeHint().height() +
                             2 * parts_->verticalHeader()->defaultSectionSize());
    times_->setMaximumHeight(parts_->height());
    hint_->setObjectName(QStringLiteral("builtHint"));
    hint_->setWordWrap(true);
    words_->setObjectName(QStringLiteral("builtWords"));
    words_->setWordWrap(true);
    legend_->setWordWrap(true);
    words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(parts_);
    layout->addWidget(times_);
    layout->addWidget(hint_);
    layout->addWidget(makeKeepBar());
    layout->addWidget(words_);
    layout->addWidget(picture_, 1);
    layout->addWidget(legend_);
    layout->addWidget(makeCorrectionBar());
    setBuilt({}, {}, width_, height_);
}

QWidget* BuiltPage::makeKeepBar() {
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    acceptedBy_->setObjectName(QStringLiteral("acceptedBy"));
    acceptedBy_->setMaxLength(100);
    acceptedBy_->setPlaceholderText(tr("Name of the person"));
    acceptedBy_->setAccessibleName(tr("Accepted by"));
    acceptedBy_->setToolTip(tr("Name of the person who accepts the part"));
    keep_ = new QPushButton(tr("&Keep part"));
    keep_->setObjectName(QStringLiteral("keepPart"));
    keep_->setToolTip(tr("Stores the measured error of this part with the job"));
    row->addWidget(new QLabel(tr("Accepted by")));
    row->addWidget(acceptedBy_, 1);
    row->addWidget(keep_);
    connect(acceptedBy_, &QLineEdit::textChanged, this, &BuiltPage::enable);
    connect(keep_, &QPushButton::clicked, this,
            [this] { emit keepAsked(acceptedBy_->text().trimmed()); });
    return bar;
}

QWidget* BuiltPage::makeCorrectionBar() {
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    corrects_->setObjectName(QStringLiteral("corrects"));
    corrects_->setToolTip(
        tr("Shifts the image on the next sheets so that it cancels the repeating error"));
    strength_->setObjectName(QStringLiteral("correctionStrength"));
    strength_->setAccessibleName(tr("Strength of the correction"));
    strength_->setToolTip(tr("How much of the repeating error the next sheets correct"));
    strength_->setRange(0, 100);
    strength_->setDecimals(0);
    strength_->setSingleStep(10);
    strength_->setSuffix(tr(" %"));
    strength_->setKeyboardTracking(false);
    dip_->setObjectName(QStringLiteral("correctionDip"));
    dip_->setAccessibleName(tr("Dip"));
    row->addWidget(corrects_);
    row->addWidget(strength_);
    row->addStretch();
    row->addWidget(dip_);
    connect(corrects_, &QCheckBox::clicked, this, &BuiltPage::correctsChosen);
    connect(strength_, &QDoubleSpinBox::valueChanged, this,
            [this](double percent) { emit strengthChosen(percent / 100); });
    connect(dip_, &QComboBox::currentIndexChanged, this, &BuiltPage::showPicture);
    return bar;
}

void BuiltPage::setBuilt(const AsBuilt& built, const QStringList& dips, Millimetres width,
                         Millimetres height) {
    built_ = built;
    width_ = width;
    height_ = height;
    corrects_->setChecked(built.corrects);
    const QSignalBlocker quiet(strength_);
    strength_->setValue(100 * built.strength);
    showParts(dips);
    showTimes();
    showPicture();
    enable();
}

void BuiltPage::setErrors(std::shared_ptr<const std::vector<RepeatingError>> errors) {
    errors_ = std::move(errors);
    const QSignalBlocker quiet(dip_);
    const int shown = std::max(0, dip_->currentIndex());
    dip_->clear();
    QStringList sentences;
    for (std::size_t i = 0; errors_ && i < errors_->size(); ++i) {
        dip_->addItem(tr("Dip %1").arg(i + 1));
        if (!(*errors_)[i].isNothing()) {
            sentences << repeatingSentence((*errors_)[i], int(i) + 1);
        }
    }
    dip_->setCurrentIndex(std::min(shown, dip_->count() - 1));
    dip_->setVisible(dip_->count() > 1);
    words_->setText(sentences.join(u'\n'));
    words_->setVisible(!sentences.isEmpty());
    showPicture();
}

void BuiltPage::showParts(const QStringList& dips) {
    parts_->setRowCount(int(built_.parts.size()));
    for (int row = 0; row < parts_->rowCount(); ++row) {
        const BuiltPart& part = built_.parts[std::size_t(row)];
        const QStringList hashes = part.photos.split(u' ', Qt::SkipEmptyParts);
        const QStringList texts{part.date, part.acceptedBy, QString::number(hashes.size()),
                                tr("%1 mm").arg(numberText(part.residual, 2)),
                                alikeText(part, dips)};
        for (int column = 0; column < texts.size(); ++column) {
            parts_->setItem(row, column, new QTableWidgetItem(texts[column]));
        }
        parts_->item(row, 2)->setToolTip(hashes.join(u'\n'));
    }
}

void BuiltPage::showTimes() {
    const std::vector<TankSummary> steps = tankSummaries(built_.times);
    times_->setVisible(!steps.empty());
    parts_->setVisible(steps.empty() || !built_.parts.empty());
    times_->setRowCount(int(steps.size()));
    for (int row = 0; row < times_->rowCount(); ++row) {
        const TankSummary& step = steps[std::size_t(row)];
        const QStringList texts{tr("Dip %1: %2").arg(step.dip).arg(tankStepTitle(step.step)),
                                QLocale().toString(step.runs),
                                step.planned ? durationText(*step.planned) : QString(),
                                tr("%1 (%2 to %3)")
                                    .arg(durationText(step.mean), durationText(step.shortest),
                                         durationText(step.longest))};
        for (int column = 0; column < texts.size(); ++column) {
            times_->setItem(row, column, new QTableWidgetItem(texts[column]));
        }
    }
}

void BuiltPage::showPicture() {
    const int dip = std::max(0, dip_->currentIndex());
    if (!errors_ || std::size_t(dip) >= errors_->size() ||
        (*errors_)[std::size_t(dip)].isNothing()) {
        picture_->clear();
        legend_->clear();
        return;
    }
    const QImage picture = correctionPicture((*errors_)[std::size_t(dip)], width_, height_,
                                             built_.strength, pictureHeight);
    picture_->setPicture(picture, QSizeF(picture.size()) / 5);
    legend_->setText(
        built_.corrects
            ? tr("The picture shows how the next sheets are corrected.")
            : tr("The correction is off. The picture shows how it would change the next sheets."));
}

void BuiltPage::setKeepable(bool keepable) {
    keepable_ = keepable;
    enable();
}

void BuiltPage::setBusy(bool busy) {
    busy_ = busy;
    enable();
}

void BuiltPage::enable() {
    hint_->setText(keepable_
                       ? tr("“Keep part” stores in the project: the error of this part, the "
                            "checksums of its photos and the name of the person who accepts it.")
                       : tr("To keep a part, first find its corners on the page “Dipped part”. The "
                            "places of the pairs must lie on the part itself, not on the print."));
    keep_->setEnabled(keepable_ && !busy_ && !acceptedBy_->text().trimmed().isEmpty());
    corrects_->setEnabled(!built_.parts.empty());
    strength_->setEnabled(!built_.parts.empty());
}

} // namespace dipwright
