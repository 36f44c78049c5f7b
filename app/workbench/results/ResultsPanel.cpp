#include "workbench/results/ResultsPanel.h"

#include "results/Results.h"
#include "workbench/accuracy/VerdictPanel.h"
#include "workbench/results/ReportPanel.h"
#include "workbench/results/ResultTabs.h"
#include "workbench/results/StretchPanel.h"
#include "workbench/widgets/PicturePanel.h"

#include <QAction>
#include <QPainter>

namespace dipwright {

namespace {

constexpr int leastWidth = 350;                // all panels fit into a window of 1024 pixels
constexpr double proofPixelsPerMillimetre = 8; // the proof has no given resolution
constexpr double sharesOpacity = 0.6;          // the sheet stays visible below

// Draws the shares of the two dips over the film on the page.
QImage sharedSheet(const SheetPreview& sheet, const JobResult& result, std::size_t immersion) {
    const double perMillimetre = sheet.page.width() / sheet.size.width();
    const QRectF film(sheet.film.topLeft() * perMillimetre, sheet.film.size() * perMillimetre);
    QImage page = sheet.page.convertToFormat(QImage::Format_RGB32);
    QPainter painter(&page);
    painter.setOpacity(sharesOpacity);
    painter.drawImage(film, sharePicture(*result.immersions[immersion].laid, *result.share,
                                         immersion, film.size().toSize()));
    return page;
}

QString sharesLegend(const JobResult& result) {
    QStringList lines;
    for (const ShareLine& line : shareLines(*result.share, {result.immersions[0].immersion.name,
                                                            result.immersions[1].immersion.name})) {
        // The colour of bare surface would be invisible on a bright window.
        const bool bare = line.colour == painterColour(Painter::None);
        lines.append(bare ? QStringLiteral("□ ") + line.text.toHtmlEscaped()
                          : QStringLiteral("<span style='color:%1'>■</span> %2")
                                .arg(line.colour.name(), line.text.toHtmlEscaped()));
    }
    return lines.join(QStringLiteral("<br>"));
}

} // namespace

ResultsPanel::ResultsPanel(QWidget* parent)
    : QTabWidget(parent), tabs_(new ResultTabs), numericalError_(new VerdictPanel),
      stretch_(new StretchPanel),
      texture_(new PicturePanel(tr("Reverse texture"),
                                tr("Run the dip to see the image for the film."))),
      proof_(new PicturePanel(tr("Proof"), tr("Run the dip to see the finished part."))),
      sheet_(
          new PicturePanel(tr("Sheet"), tr("Run the dip to see the page as it will be printed."))),
      report_(new ReportPanel) {
    setObjectName(QStringLiteral("results"));
    setTabBar(tabs_);
    setDocumentMode(true);
    setUsesScrollButtons(true);
    setMinimumWidth(leastWidth);
    sheet_->offerTrueSize();
    proofShares_ = offer(*proof_, tr("Shares of the dips"), QStringLiteral("proofShares"),
                         tr("Shows which areas each dip paints, from six sides and on both films"));
    sheetShares_ = offer(*sheet_, tr("Shares of the dips"), QStringLiteral("sheetShares"),
                         tr("Shows which areas each dip paints, over the sheet of this dip"));
    proofWithoutWhite_ = offer(*proof_, tr("Without white"), QStringLiteral("proofWithoutWhite"),
                               tr("Shows the ink on the part's own colour, without the white"));
    connect(proofShares_, &QAction::toggled, this, &ResultsPanel::showProof);
    connect(proofWithoutWhite_, &QAction::toggled, this, &ResultsPanel::showProof);
    connect(sheetShares_, &QAction::toggled, this, &ResultsPanel::showSheet);
    addTab(numericalError_, tr("Verdict"));
    addTab(stretch_, tr("Stretch"));
    addTab(texture_, tr("Texture"));
    addTab(proof_, tr("Proof"));
    addTab(sheet_, tr("Sheet"));
    addTab(report_, tr("Report"));
    setTabToolTip(0, tr("Whether to print the sheet, and which places to check first"));
    setTabToolTip(1, tr("How much the film has stretched, and where"));
    setTabToolTip(2, tr("The reverse texture: the image for the film"));
    setTabToolTip(3, tr("The finished part"));
    setTabToolTip(4, tr("The page as it will be printed"));
    setTabToolTip(5, tr("The figures of the last run"));

    connect(numericalError_, &VerdictPanel::placeChosen, this, &ResultsPanel::placeChosen);
    connect(numericalError_, &VerdictPanel::fieldChosen, this, &ResultsPanel::fieldChosen);
    connect(report_, &ReportPanel::placeChosen, this, &ResultsPanel::modelPlaceChosen);
    connect(stretch_, &StretchPanel::hovered, this, &ResultsPanel::hovered);
    connect(stretch_, &StretchPanel::hoverLeft, this, &ResultsPanel::hoverLeft);
    connect(&texture_->view(), &PictureView::hovered, this, [this](QPointF printed) {
        const FilmSettings& film = outcome_.result->project.film;
        hoverShare(printed.x() / film.width.value(), printed.y() / film.height.value());
    });
    connect(&sheet_->view(), &PictureView::hovered, this, [this](QPointF page) {
        const QRectF film = outcome_.sheets[immersion_].film;
        hoverShare((page.x() - film.x()) / film.width(), (page.y() - film.y()) / film.height());
    });
    for (PicturePanel* panel : {texture_, sheet_}) {
        connect(&panel->view(), &PictureView::hoverLeft, this, &ResultsPanel::hoverLeft);
    }
}

void ResultsPanel::hoverShare(double across, double down) {
    const solver::FilmGrid& grid = outcome_.readings[immersion_]->film().grid;
    emit hovered({float((across - 0.5) * grid.width), float((down - 0.5) * grid.depth)});
}

void ResultsPanel::showWarning(std::size_t number) {
    setCurrentWidget(report_);
    report_->showWarning(number);
}

void ResultsPanel::setOutcome(const DipOutcome& outcome, std::size_t immersion) {
    outcome_ = outcome;
    immersion_ = immersion;
    report_->setResult(outcome.result, outcome.warnings, outcome.inkOptions, unit_);
    numericalError_->setOutcome(outcome, immersion, unit_);
    if (immersion >= outcome.readings.size()) {
        stretch_->setReading(nullptr);
        for (PicturePanel* panel : {texture_, proof_, sheet_}) {
            panel->clear();
        }
        return;
    }
    stretch_->setReading(outcome.readings[immersion], outcome.fineness.isDraft());
    const FilmSettings& film = outcome.result->project.film;
    texture_->setPicture(outcome.result->immersions[immersion].texture->image,
                         {film.width.value(), film.height.value()});
    proofShares_->setVisible(!outcome.result->coverage.isNull());
    proofWithoutWhite_->setVisible(!outcome.result->proofWithoutWhite.isNull());
    sheetShares_->setVisible(outcome.result->share != nullptr);
    showProof();
    showSheet();
}

QAction* ResultsPanel::offer(PicturePanel& panel, const QString& text, const QString& name,
                             const QString& help) {
    auto* other = new QAction(text, this);
    other->setObjectName(name);
    other->setCheckable(true);
    other->setVisible(false);
    other->setToolTip(help);
    panel.addButton(other);
    return other;
}

void ResultsPanel::showProof() {
    const bool hasShares = outcome_.result && !outcome_.result->coverage.isNull();
    if (outcome_.result) {
        const JobResult& result = *outcome_.result;
        const bool isBare = proofWithoutWhite_->isChecked() && !result.proofWithoutWhite.isNull();
        const QImage& picture = hasShares && proofShares_->isChecked() ? result.coverage
                                : isBare                               ? result.proofWithoutWhite
                                                                       : result.proof;
        proof_->setPicture(picture, QSizeF(picture.size()) / proofPixelsPerMillimetre);
    }
}

void ResultsPanel::showSheet() {
    if (immersion_ >= outcome_.sheets.size()) {
        return;
    }
    const SheetPreview& sheet = outcome_.sheets[immersion_];
    const bool shared = outcome_.result->share && sheetShares_->isChecked();
    sheet_->setPicture(shared ? sharedSheet(sheet, *outcome_.result, immersion_) : sheet.page,
                       sheet.size);
    sheet_->setLegend(shared ? sharesLegend(*outcome_.result) : QString());
}

void ResultsPanel::setLengthUnit(LengthUnit unit) {
    unit_ = unit;
    report_->setResult(outcome_.result, outcome_.warnings, outcome_.inkOptions, unit);
    numericalError_->setOutcome(outcome_, immersion_, unit);
}

void ResultsPanel::setFreshness(const Freshness& freshness, bool isJobFresh) {
    const std::pair<QWidget*, bool> tabs[] = {
        {numericalError_, isJobFresh}, {stretch_, freshness.dip}, {texture_, freshness.texture},
        {proof_, freshness.texture},   {sheet_, freshness.sheet}, {report_, isJobFresh}};
    for (const auto& [panel, isFresh] : tabs) {
        tabs_->setOutdated(indexOf(panel), !isFresh);
    }
    numericalError_->setFresh(isJobFresh);
}

void ResultsPanel::setDraftEnd(DraftEnd end) {
    numericalError_->setDraftEnd(end);
}

void ResultsPanel::showReading(const std::optional<FilmReadoutPoint>& point) {
    stretch_->showReading(point);
    if (!point) {
        texture_->view().setCursorAt({});
        sheet_->view().setCursorAt({});
        return;
    }
    const solver::FilmGrid& grid = outcome_.readings[immersion_]->film().grid;
    const FilmSettings& film = outcome_.result->project.film;
    const QRectF page = outcome_.sheets[immersion_].film;
    const double across = double(point->rest.x()) / grid.width + 0.5;
    const double down = double(point->rest.y()) / grid.depth + 0.5;
    texture_->view().setCursorAt(QPointF(across * film.width.value(), down * film.height.value()));
    sheet_->view().setCursorAt(page.topLeft() +
                               QPointF(across * page.width(), down * page.height()));
}

void ResultsPanel::addTextureAction(QAction* action) {
    texture_->addButton(action);
}

void ResultsPanel::addSheetAction(QAction* action) {
    sheet_->addButton(action);
}

} // namespace dipwright
