#include "panels/ResultsPanel.h"

#include "panels/CertaintyPanel.h"
#include "panels/PicturePanel.h"
#include "panels/ReportPanel.h"
#include "panels/StretchPanel.h"

#include <QAction>

namespace dipwright {

namespace {

constexpr int leastWidth = 390;                // all tabs can be seen, marked as stale too
constexpr double proofPixelsPerMillimetre = 8; // the proof has no size of its own

} // namespace

ResultsPanel::ResultsPanel(QWidget* parent)
    : QTabWidget(parent), certainty_(new CertaintyPanel), stretch_(new StretchPanel),
      texture_(new PicturePanel(tr("Reverse texture"),
                                tr("Run the dip to see the image that goes on the film."))),
      proof_(new PicturePanel(tr("Proof"), tr("Run the dip to see the body as it will come out."))),
      sheet_(new PicturePanel(tr("Sheet"), tr("Run the dip to see the page as it prints."))),
      report_(new ReportPanel) {
    setObjectName(QStringLiteral("results"));
    setDocumentMode(true);
    setUsesScrollButtons(true);
    setMinimumWidth(leastWidth);
    sheet_->offerTrueSize();
    shares_ = new QAction(tr("Who Paints What"), this);
    shares_->setObjectName(QStringLiteral("proofShares"));
    shares_->setCheckable(true);
    shares_->setVisible(false);
    shares_->setToolTip(tr("The shares of the two dips, from six sides and on both films"));
    proof_->addButton(shares_);
    connect(shares_, &QAction::toggled, this, &ResultsPanel::showProof);
    addTab(certainty_, tr("Verdict"));
    addTab(stretch_, tr("Stretch"));
    addTab(texture_, tr("Texture"));
    addTab(proof_, tr("Proof"));
    addTab(sheet_, tr("Sheet"));
    addTab(report_, tr("Report"));
    setTabToolTip(0, tr("Whether to print the sheet, and where to look first"));
    setTabToolTip(1, tr("How much the film has stretched, and where"));
    setTabToolTip(2, tr("The reverse texture: the image that goes on the film"));
    setTabToolTip(3, tr("The body as it will come out"));
    setTabToolTip(4, tr("The page as it prints"));
    setTabToolTip(5, tr("The figures of the last run"));

    connect(certainty_, &CertaintyPanel::placeChosen, this, &ResultsPanel::placeChosen);
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

void ResultsPanel::setOutcome(const DipOutcome& outcome, std::size_t immersion) {
    outcome_ = outcome;
    immersion_ = immersion;
    report_->setResult(outcome.result, unit_);
    certainty_->setOutcome(outcome, immersion, unit_);
    if (immersion >= outcome.readings.size()) {
        stretch_->setReading(nullptr);
        for (PicturePanel* panel : {texture_, proof_, sheet_}) {
            panel->clear();
        }
        return;
    }
    stretch_->setReading(outcome.readings[immersion]);
    const FilmSettings& film = outcome.result->project.film;
    texture_->setPicture(outcome.result->immersions[immersion].texture->image,
                         {film.width.value(), film.height.value()});
    shares_->setVisible(!outcome.result->coverage.isNull());
    showProof();
    const SheetPreview& sheet = outcome.sheets[immersion];
    sheet_->setPicture(sheet.page, sheet.size);
}

void ResultsPanel::showProof() {
    const bool hasShares = outcome_.result && !outcome_.result->coverage.isNull();
    if (outcome_.result) {
        const QImage& picture =
            hasShares && shares_->isChecked() ? outcome_.result->coverage : outcome_.result->proof;
        proof_->setPicture(picture, QSizeF(picture.size()) / proofPixelsPerMillimetre);
    }
}

void ResultsPanel::setLengthUnit(LengthUnit unit) {
    unit_ = unit;
    report_->setResult(outcome_.result, unit);
    certainty_->setOutcome(outcome_, immersion_, unit);
}

void ResultsPanel::setFreshness(const Freshness& freshness) {
    const QString mark = QStringLiteral(" •");
    const std::array<bool, 5> fresh{freshness.dip, freshness.dip, freshness.texture,
                                    freshness.texture, freshness.sheet};
    for (int tab = 0; tab < int(fresh.size()); ++tab) {
        QString text = tabText(tab);
        text.remove(mark);
        setTabText(tab, fresh[std::size_t(tab)] ? text : text + mark);
    }
}

void ResultsPanel::showReading(const std::optional<FilmReadingPoint>& point) {
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
