#include "workbench/compare/CompareWindow.h"

#include "workbench/appearance/ViewTheme.h"
#include "workbench/jobs/Messages.h"
#include "workbench/widgets/Theme.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace dipwright {

namespace {

constexpr int progressSteps = 1000;
// The second camera's position until the second camera follows the first. This position must not
// move the first camera.
constexpr ViewCamera waiting{{0, 0, 500}, {0, 0, 0}, {0, 1, 0}, 100, false};

} // namespace

CompareWindow::CompareWindow(const std::array<ComparedState, 2>& states,
                             const std::shared_ptr<const JobResult>& kept,
                             const SolverRegistry& registry, const Preferences& preferences,
                             QWidget* parent)
    : QDialog(parent), unit_(preferences.unit), look_(new QComboBox), immersion_(new QComboBox),
      scale_(new QLabel), figures_(new QTableWidget(0, 4)), doing_(new QLabel),
      progress_(new QProgressBar) {
    setObjectName(QStringLiteral("compareWindow"));
    setWindowTitle(tr("Side by side"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(makeChoices(
        std::min(states[0].project.immersions.size(), states[1].project.immersions.size())));
    layout->addWidget(makeSides(states), 3);
    layout->addWidget(figures_, 1);
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
        tr("What both views show: the lines of the film, its stretch, or the painted area"));
    look_->addItem(tr("Film on the part"), int(ComparedLook::Film));
    look_->addItem(tr("Stretch of the film"), int(ComparedLook::Stretch));
    look_->addItem(tr("Coverage"), int(ComparedLook::Coverage));
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
        auto* title = new QLabel(states[side].title);
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
        column->addWidget(views_[side], 1);
        row->addLayout(column, 1);
    }
    return box;
}

QWidget* CompareWindow::makeEnd() {
    figures_->setObjectName(QStringLiteral("comparedFigures"));
    figures_->setAccessibleName(tr("Values of both states"));
    figures_->verticalHeader()->hide();
    figures_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    figures_->setSelectionMode(QAbstractItemView::NoSelection);
    figures_->setTabKeyNavigation(false);
    figures_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    figures_->setMinimumHeight(110);
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
    for (const auto& side : sides_) {
        side->show(look, scale);
    }
    scale_->setVisible(look == ComparedLook::Stretch);
    showScale(scale);
    if (sides_[0]->reading() && sides_[1]->reading()) {
        doing_->clear();
    }
    showFigures();
}

void CompareWindow::showScale(const HeatScale& scale) {
    const auto colour = [&](double share) {
        return QColor(scale.colour(scale.low + share * (scale.high - scale.low))).name();
    };
    QString bar;
    constexpr int steps = 24;
    for (int step = 0; step < steps; ++step) {
        bar += QStringLiteral("<span style=\"background:%1\">&nbsp;</span>")
                   .arg(colour(double(step) / (steps - 1)));
    }
    scale_->setText(QStringLiteral("%1&nbsp;%2&nbsp;%3")
                        .arg(QLocale().toString(scale.low, 'f', 2), bar,
                             QLocale().toString(scale.high, 'f', 2)));
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
