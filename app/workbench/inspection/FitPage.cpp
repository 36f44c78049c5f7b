#include "workbench/inspection/FitPage.h"

#include "base/NumberText.h"
#include "workbench/widgets/Icons.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace dipwright {

namespace {

// Makes the table as high as its rows, so that the page scrolls and not the table.
void fitHeight(QTableWidget& table) {
    int height = table.horizontalHeader()->sizeHint().height() + 2 * table.frameWidth();
    for (int row = 0; row < table.rowCount(); ++row) {
        height += table.rowHeight(row);
    }
    table.setFixedHeight(height);
}

QTableWidget* tableOf(const char* name, const QString& help) {
    auto* table = new QTableWidget;
    table->setObjectName(QLatin1String(name));
    table->setAccessibleName(help);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionMode(QAbstractItemView::NoSelection);
    table->verticalHeader()->hide();
    return table;
}

QTableWidgetItem* cell(const QString& text, bool isNumber) {
    auto* item = new QTableWidgetItem(text);
    item->setTextAlignment((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    return item;
}

} // namespace

FitPage::FitPage(QWidget* parent)
    : QWidget(parent), hint_(new QLabel), words_(new QLabel),
      quantities_(tableOf("fitQuantities", tr("Fitted quantities"))),
      correlations_(tableOf("fitCorrelations", tr("Correlations of the fitted quantities"))) {
    for (QLabel* label : {hint_, words_}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    hint_->setObjectName(QStringLiteral("fitHint"));
    words_->setObjectName(QStringLiteral("fitWords"));
    correlations_->setToolTip(tr("Near 1 or −1: the photos determine only a combination of the two "
                                 "quantities, not each quantity separately"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(hint_);
    layout->addWidget(makeButtons());
    layout->addWidget(quantities_);
    layout->addWidget(words_);
    layout->addWidget(correlations_);
    layout->addStretch(1);
    setFitted(nullptr, false);
}

QWidget* FitPage::makeButtons() {
    auto* bar = new QWidget;
    auto* rows = new QVBoxLayout(bar);
    rows->setContentsMargins(0, 0, 0, 0);
    fit_ = new QPushButton(icon(QStringLiteral("run")), tr("&Fit film and dip"));
    fit_->setObjectName(QStringLiteral("fitFilm"));
    fit_->setToolTip(tr("Changes the settings of film and dip and repeats the simulation until the "
                        "simulated image lies where the photos show it"));
    use_ = new QPushButton(tr("&Use in project"));
    use_->setObjectName(QStringLiteral("useFit"));
    use_->setToolTip(tr("Puts the fitted film, placement and depth into the project. The film then "
                        "counts as measured."));
    save_ = new QPushButton(tr("&Save to profile…"));
    save_->setObjectName(QStringLiteral("saveFit"));
    export_ = new QPushButton(tr("&Export…"));
    export_->setObjectName(QStringLiteral("exportFit"));
    const std::vector<QList<QPushButton*>> lines{{fit_}, {use_, save_, export_}};
    for (const QList<QPushButton*>& line : lines) {
        auto* row = new QHBoxLayout;
        for (QPushButton* button : line) {
            row->addWidget(button);
        }
        row->addStretch();
        rows->addLayout(row);
    }
    connect(fit_, &QPushButton::clicked, this, &FitPage::fitAsked);
    connect(use_, &QPushButton::clicked, this, &FitPage::useAsked);
    connect(save_, &QPushButton::clicked, this, &FitPage::saveAsked);
    connect(export_, &QPushButton::clicked, this, &FitPage::exportAsked);
    return bar;
}

void FitPage::setReady(bool ready, bool hasBody) {
    ready_ = ready;
    hasBody_ = hasBody;
    enable();
    say();
}

void FitPage::setFitted(std::shared_ptr<const FittedPart> fitted, bool isUsed) {
    fitted_ = std::move(fitted);
    isUsed_ = isUsed;
    refusal_.clear();
    showQuantities();
    showCorrelations();
    enable();
    say();
}

void FitPage::setRefusal(const QString& sentence) {
    setFitted(nullptr, false);
    refusal_ = sentence;
    say();
}

void FitPage::setBusy(bool busy) {
    busy_ = busy;
    enable();
}

void FitPage::showQuantities() {
    quantities_->clear();
    quantities_->setRowCount(0);
    quantities_->setVisible(fitted_ != nullptr);
    if (!fitted_) {
        return;
    }
    const auto& found = fitted_->fit.quantities;
    quantities_->setColumnCount(4);
    quantities_->setHorizontalHeaderLabels({{}, tr("Before"), tr("Fitted"), tr("95 % interval")});
    quantities_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    quantities_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    quantities_->setRowCount(int(found.size()));
    for (std::size_t i = 0; i < found.size(); ++i) {
        const QStringList texts = fitCells(found[i]);
        for (int column = 0; column < texts.size(); ++column) {
            quantities_->setItem(int(i), column, cell(texts[column], column > 0));
        }
        quantities_->item(int(i), 0)->setToolTip(texts[0]);
    }
    fitHeight(*quantities_);
}

void FitPage::showCorrelations() {
    correlations_->clear();
    correlations_->setRowCount(0);
    const int count = fitted_ ? int(fitted_->fit.quantities.size()) : 0;
    correlations_->setVisible(count > 1);
    if (count < 2) {
        return;
    }
    QStringList names{tr("Correlation")};
    for (int i = 1; i < count; ++i) { // the last column would be empty
        names << QString::number(i);
    }
    correlations_->setColumnCount(count);
    correlations_->setHorizontalHeaderLabels(names);
    correlations_->horizontalHeader()->setMinimumSectionSize(20);
    correlations_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    correlations_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    correlations_->setRowCount(count);
    for (int row = 0; row < count; ++row) {
        const QString name = fitCells(fitted_->fit.quantities[std::size_t(row)])[0];
        correlations_->setItem(row, 0,
                               cell(QStringLiteral("%1  %2").arg(row + 1).arg(name), false));
        for (int column = 0; column < row; ++column) {
            correlations_->setItem(
                row, column + 1, cell(numberText(fitted_->fit.correlation(row, column), 2), true));
        }
    }
    fitHeight(*correlations_);
}

void FitPage::enable() {
    fit_->setEnabled(ready_ && !busy_);
    use_->setEnabled(fitted_ && !isUsed_ && !busy_);
    save_->setEnabled(fitted_ && !busy_);
    export_->setEnabled(fitted_ && !busy_);
}

void FitPage::say() {
    if (isUsed_) {
        hint_->setText(tr("The project uses the film, placement and depth of this fit. To fit "
                          "again, find the corners again."));
    } else if (!ready_) {
        hint_->setText(tr(
            "First find the corners on the page “Dipped part”. Film and dip are fitted to them."));
    } else if (!hasBody_) {
        hint_->setText(tr("No pair is a place on the part itself, such as a corner or a hole. "
                          "Without such pairs, a shift or rotation of the whole image looks the "
                          "same as a movement of the camera."));
    } else {
        hint_->setText(
            tr("Fits placement, swell and relaxation, as far as the photos determine them."));
    }
    QStringList sentences;
    if (fitted_) { // without the sentences that the table shows
        sentences = fitSentences(fitted_->fit).mid(qsizetype(fitted_->fit.quantities.size()));
    } else if (!refusal_.isEmpty()) {
        sentences << refusal_;
    }
    words_->setText(sentences.join(u'\n'));
    words_->setVisible(!sentences.isEmpty());
}

} // namespace dipwright
