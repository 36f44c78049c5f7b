#include "workbench/compare/CompareWindow.h"

#include "base/NumberText.h"
#include "workbench/appearance/ViewTheme.h"
#include "workbench/jobs/Messages.h"
#include "workbench/widgets/PicturePanel.h"
#include "workbench/widgets/Theme.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QStackedWidget>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace dipwright {

namespace {

constexpr int progressSteps = 1000;
constexpr double mapPixelsPerMillimetre = 8; // sets the map's size on the screen
// The second camera's position until the second camera follows the first. This position must not
// move the first camera.
constexpr ViewCamera waiting{{0, 0, 500}, {0, 0, 0}, {0, 1, 0}, 100, false};

void makeReadable(QTableWidget& table) {
    table.verticalHeader()->hide();
    table.setEditTriggers(QAbstractItemView::NoEditTriggers);
    table.setTabKeyNavigation(false);
    table.horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table.setMinimumHeight(110);
}

QString shownPercent(double share) {
    return CompareWindow::tr("%1 %").arg(numberText(100 * share, 1));
}

} // namespace

CompareWindow::CompareWindow(const std::array<ComparedState, 2>& states,
                             const std::shared_ptr<const JobResult>& kept,
                             const SolverRegistry& registry, const Preferences& preferences,
                             QWidget* parent)
    : QDialog(parent), unit_(preferences.unit), look_(new QComboBox), immersion_(new QComboBox),
      scale_(new QLabel), secondSide_(new QStackedWidget),
      map_(new PicturePanel(tr("Difference on the sheet"), {})), figures_(new QTableWidget(0, 4)),
      differences_(new QTableWidget(0, 5)), note_(new QLabel), doing_(new QLabel),
      progress_(new QProgressBar) {
    setObjectName(QStringLiteral("compareWindow"));
    setWindowTitle(tr("Side by side"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(makeChoices(
        std::min(states[0].project.immersions.size(), states[1].project.immersions.size())));
    layout->addWidget(makeSides(states), 3);
    layout->addWidget(note_);
    layout->addWidget(makeTables(), 1);
    layout->addWidget(makeEnd());
    for (std::size_t side = 0; side < 2; ++side) {
        views_[side]->setNavigation(preferences.navigation == NavigationChoice::Trackball
                                        ? Navigation::Trackball
                                        : Navigation::Turntable);
        sides_[side] = std::make_unique<ComparedSide>(states[side], kept, jobs_, registry,
                                                      *views_[side], nullptr);
        connect(&sides_[side]->session(), &DipSession::finished, this,
                [this, isFirst = true]() mutable {
                    showSides();
                    if (std::exchange(isFirst, false)) { // refined films follow
                        views_[0]->fit();                // the bodies are lower now
                    }
                });
        connect(&sides_[side]->session(), &DipSession::stopped, this,
                [this](const std::exception_ptr& why) {
                    if (why) {
                        doing_->setText(sentenceOf(why));
                    }
                });
        connect(views_[side], &DipView::cameraMoved, views_[1 - side], &DipView::setCamera);
    }
    colourViews();
    resize(QSize(1100, 720).boundedTo(screen()->availableSize()));
    showSides();
    views_[1]->setCamera(waiting); // after the new body has moved the camera
    views_[0]->fit();
    for (const auto& side : sides_) {
        side->run();
    }
}

CompareWindow::~CompareWindow() = default;

QWidget* CompareWindow::makeChoices(std::size_t immersions) {
    look_->setObjectName(QStringLiteral("comparedLook"));
    look_->setAccessibleName(tr("What is shown"));
    look_->setToolTip(
        tr("What both views show: the lines of the film, its stretch, the painted area, or how far "
           "the image differs between the two states, on the part and on the second sheet"));
    look_->addItem(tr("Film on the part"), int(ComparedLook::Film));
    look_->addItem(tr("Stretch of the film"), int(ComparedLook::Stretch));
    look_->addItem(tr("Coverage"), int(ComparedLook::Coverage));
    look_->addItem(tr("Difference of the sheets"), int(ComparedLook::Difference));
    connect(look_, &QComboBox::currentIndexChanged, this, &CompareWindow::showSides);
    immersion_->setObjectName(QStringLiteral("comparedImmersion"));
    immersion_->setAccessibleName(tr("Dip"));
    immersion_->setToolTip(tr("The dip that is shown"));
    for (std::size_t number = 0; number < immersions; ++number) {
        immersion_->addItem(tr("Dip %1").arg(number + 1));
    }
    immersion_->setVisible(immersions > 1);
    connect(immersion_, &QComboBox::currentIndexChanged, this, [this](int number) {
        for (const auto& side : sides_) {
            side->lookAt(std::size_t(number));
        }
        showSides();
    });
    auto* fit = new QPushButton(tr("&Fit"));
    fit->setToolTip(tr("Fit both parts into their views"));
    fit->setAutoDefault(false);
    connect(fit, &QPushButton::clicked, this, [this] { views_[0]->fit(); });
    auto* box = new QWidget;
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(look_);
    row->addWidget(immersion_);
    row->addWidget(fit);
    row->addStretch(1);
    scale_->setTextFormat(Qt::RichText); // holds only numbers and colours
    row->addWidget(scale_);
    return box;
}

QWidget* CompareWindow::makeSides(const std::array<ComparedState, 2>& states) {
    auto* box = new QWidget;
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    for (std::size_t side = 0; side < 2; ++side) {
        QLabel* title = titles_[side] = new QLabel(states[side].title);
        title->setAlignment(Qt::AlignCenter);
        QFont font = title->font();
        font.setBold(true);
        title->setFont(font);
        views_[side] = new DipView;
        views_[side]->setObjectName(side == 0 ? QStringLiteral("firstView")
                                              : QStringLiteral("secondView"));
        views_[side]->setAccessibleName(states[side].title);
        auto* column = new QVBoxLayout;
        column->addWidget(title);
        column->addWidget(side == 0 ? static_cast<QWidget*>(views_[side]) : secondSide_, 1);
        row->addLayout(column, 1);
    }
    secondSide_->addWidget(views_[1]);
    secondSide_->addWidget(map_);
    note_->setObjectName(QStringLiteral("differenceNote"));
    note_->setWordWrap(true);
    return box;
}

QWidget* CompareWindow::makeTables() {
    figures_->setObjectName(QStringLiteral("comparedFigures"));
    figures_->setAccessibleName(tr("Values of both states"));
    figures_->setSelectionMode(QAbstractItemView::NoSelection);
    makeReadable(*figures_);
    differences_->setObjectName(QStringLiteral("comparedDifferences"));
    differences_->setAccessibleName(tr("Difference of each dip"));
    differences_->setToolTip(tr("Choose a dip to see the place where its sheets differ most"));
    differences_->setSelectionBehavior(QAbstractItemView::SelectRows);
    differences_->setSelectionMode(QAbstractItemView::SingleSelection);
    differences_->setHorizontalHeaderLabels({tr("Dip"), tr("95 % of the surface"), tr("Largest"),
                                             tr("Painted in both"), tr("Painted in one")});
    makeReadable(*differences_);
    connect(differences_, &QTableWidget::cellClicked, this, &CompareWindow::showFarthest);
    connect(differences_, &QTableWidget::cellActivated, this, &CompareWindow::showFarthest);
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(figures_);
    column->addWidget(differences_);
    return box;
}

QWidget* CompareWindow::makeEnd() {
    progress_->setRange(0, progressSteps);
    progress_->setTextVisible(false);
    progress_->setAccessibleName(tr("Progress"));
    progress_->setFixedWidth(200);
    doing_->setWordWrap(true);
    connect(&jobs_, &JobRunner::progressed, this, [this](double share, const QString& text) {
        progress_->setValue(int(share * progressSteps));
        doing_->setText(text);
    });
    connect(&jobs_, &JobRunner::busy, progress_, &QWidget::show);
    connect(&jobs_, &JobRunner::idle, progress_, &QWidget::hide);
    progress_->hide();
    auto* close = new QPushButton(tr("&Close"));
    close->setToolTip(tr("Close the comparison (Escape)"));
    close->setObjectName(QStringLiteral("closeComparison"));
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    auto* box = new QWidget;
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(doing_, 1);
    row->addWidget(progress_);
    row->addWidget(close);
    return box;
}

// Both sides share one scale, so that equal colours mean equal stretch.
void CompareWindow::showSides() {
    std::vector<float> values;
    for (const auto& side : sides_) {
        if (const auto reading = side->reading()) {
            const std::vector<float>& own = reading->paintedValues(FilmQuantity::Length);
            values.insert(values.end(), own.begin(), own.end());
        }
    }
    const HeatScale scale = values.empty() ? HeatScale{} : automaticScale({}, values);
    const auto look = ComparedLook(look_->currentData().toInt());
    wantDifference();
    const DipDifference* difference = shownDifference();
    if (difference) {
        sides_[0]->setDifference(difference->body);
    }
    const auto shown =
        look == ComparedLook::Difference && !difference ? ComparedLook::Coverage : look;
    sides_[0]->show(shown, scale);
    sides_[1]->show(shown == ComparedLook::Difference ? ComparedLook::Coverage : shown, scale);
    scale_->setVisible(shown == ComparedLook::Stretch || difference);
    const auto number = [](double value) { return numberText(value, 2); };
    showScale(scale, number(scale.low), number(scale.high));
    if (sides_[0]->reading() && sides_[1]->reading()) {
        doing_->clear();
    }
    showFigures();
    showDifference();
}

void CompareWindow::showScale(const HeatScale& scale, const QString& low, const QString& high) {
    const auto colour = [&](double share) {
        return QColor(scale.colour(scale.low + share * (scale.high - scale.low))).name();
    };
    QString bar;
    constexpr int steps = 24;
    for (int step = 0; step < steps; ++step) {
        bar += QStringLiteral("<span style=\"background:%1\">&nbsp;</span>")
                   .arg(colour(double(step) / (steps - 1)));
    }
    scale_->setText(QStringLiteral("%1&nbsp;%2&nbsp;%3").arg(low, bar, high));
}

ComparedResults CompareWindow::results() const {
    return {sides_[0]->session().outcome().result, sides_[1]->session().outcome().result};
}

// Starts a comparison if the user wants to see the difference of results that are not compared yet.
// Cancels it if the user looks at something else meanwhile.
void CompareWindow::wantDifference() {
    const ComparedResults now = results();
    if (ComparedLook(look_->currentData().toInt()) != ComparedLook::Difference) {
        comparison_.cancel();
        if (!difference_) {
            compared_ = {};
        }
    } else if (incomparableSentence(now).isEmpty() && compared_ != now) {
        comparison_.cancel();
        compared_ = now;
        difference_.reset();
        startDifference();
    }
}

void CompareWindow::startDifference() {
    comparison_ = jobs_.start(std::make_unique<ValueJob<std::vector<DipDifference>>>(
        tr("Comparing the sheets"),
        [results = compared_, unit = unit_](const Progress& progress) {
            return stateDifference(results, unit, progress);
        },
        [this](std::vector<DipDifference> difference) { takeDifference(std::move(difference)); },
        [this](const std::exception_ptr& why) { doing_->setText(sentenceOf(why)); }));
}

void CompareWindow::takeDifference(std::vector<DipDifference> difference) {
    difference_ = std::move(difference);
    showDifferenceTable();
    showSides();
}

const DipDifference* CompareWindow::shownDifference() const {
    const auto dip = std::size_t(immersion_->currentIndex());
    return ComparedLook(look_->currentData().toInt()) == ComparedLook::Difference && difference_ &&
                   dip < difference_->size()
               ? &(*difference_)[dip]
               : nullptr;
}

void CompareWindow::showDifference() {
    const bool isWanted = ComparedLook(look_->currentData().toInt()) == ComparedLook::Difference;
    const DipDifference* shown = shownDifference();
    views_[0]->setMarker({});
    secondSide_->setCurrentIndex(shown ? 1 : 0);
    figures_->setVisible(!shown);
    differences_->setVisible(shown);
    titles_[0]->setText(shown ? tr("Difference on the part") : sides_[0]->title());
    titles_[1]->setText(shown ? tr("Difference on the sheet of “%1”").arg(sides_[1]->title())
                              : sides_[1]->title());
    note_->setVisible(isWanted);
    const QString why = incomparableSentence(results());
    note_->setText(!why.isEmpty() ? why
                   : shown        ? tr("Distance between the places of the flat film that colour a "
                                              "place of the part. Choose a dip in the table to see the "
                                              "place where it is largest.")
                                  : tr("Comparing the sheets"));
    if (shown) {
        map_->setPicture(shown->map, QSizeF(shown->map.size()) / mapPixelsPerMillimetre);
        showScale(shown->scale, shownLength(0, unit_, 1), shownLength(shown->scale.high, unit_, 1));
    }
}

void CompareWindow::showDifferenceTable() {
    differences_->setRowCount(int(difference_->size()));
    for (int dip = 0; dip < differences_->rowCount(); ++dip) {
        const SheetChange& change = (*difference_)[std::size_t(dip)].sheets.change;
        int column = 0;
        for (const QString& text :
             {tr("Dip %1").arg(dip + 1), shownLength(change.distance.percentile95, unit_, 1),
              shownLength(change.distance.maximum, unit_, 1), shownPercent(change.painted),
              shownPercent(change.paintedOnce)}) {
            differences_->setItem(dip, column++, new QTableWidgetItem(text));
        }
    }
}

void CompareWindow::showFarthest(int dip) {
    immersion_->setCurrentIndex(dip);
    const DipDifference* shown = shownDifference();
    if (shown && shown->sheets.farthest.isValid()) {
        sides_[0]->lookAt(shown->farthest);
    }
}

void CompareWindow::showFigures() {
    const std::vector<StateFigure> first = sides_[0]->figures(unit_);
    const std::vector<StateFigure> second = sides_[1]->figures(unit_);
    figures_->setHorizontalHeaderLabels(
        {tr("Quantity"), sides_[0]->title(), sides_[1]->title(), tr("Difference")});
    const std::size_t rows = std::min(first.size(), second.size());
    figures_->setRowCount(int(rows));
    for (std::size_t row = 0; row < rows; ++row) {
        int column = 0;
        for (const QString& text : {first[row].name, first[row].text(), second[row].text(),
                                    differenceText(first[row], second[row])}) {
            auto* item = new QTableWidgetItem(text);
            item->setToolTip(text);
            figures_->setItem(int(row), column++, item);
        }
    }
}

void CompareWindow::colourViews() {
    for (DipView* view : views_) {
        view->setColours(viewColours(isDark()));
    }
}

void CompareWindow::changeEvent(QEvent* event) {
    QDialog::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && views_[1]) {
        colourViews();
    }
}

} // namespace dipwright
