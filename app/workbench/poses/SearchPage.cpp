#include "workbench/poses/SearchPage.h"

#include "search/PoseCandidates.h"
#include "workbench/jobs/TimeLeft.h"
#include "workbench/poses/MeasurePlot.h"
#include "workbench/poses/OrientationMap.h"
#include "workbench/poses/PoseTable.h"
#include "workbench/poses/WeightFields.h"
#include "workbench/widgets/Icons.h"
#include "workbench/widgets/NumberBox.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>

namespace dipwright {

SearchPage::SearchPage(QWidget* parent)
    : QWidget(parent), immersions_(new QComboBox), simulated_(new NumberBox), seed_(new NumberBox),
      paths_(new QCheckBox), weights_(new WeightFields), start_(new QPushButton(tr("&Search"))),
      pause_(new QPushButton(tr("Pause"))), stop_(new QPushButton(tr("Stop"))),
      progress_(new QProgressBar), left_(new QLabel), note_(new QLabel), table_(new PoseTable),
      map_(new OrientationMap), plot_(new MeasurePlot), comparison_(new QLabel),
      apply_(new QPushButton(tr("&Use this pose"))),
      sideBySide_(new QPushButton(tr("Side &by side…"))) {
    setObjectName(QStringLiteral("searchPage"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(makeSettings());
    layout->addWidget(makeProgress());
    layout->addWidget(makeFound(), 1);
    connect(start_, &QPushButton::clicked, this, &SearchPage::startAsked);
    connect(stop_, &QPushButton::clicked, this, &SearchPage::stopAsked);
    connect(pause_, &QPushButton::clicked, this, [this] {
        const bool isPaused = state_ != State::Paused;
        setState(isPaused ? State::Paused : State::Searching);
        emit pauseAsked(isPaused);
    });
    connect(table_, &PoseTable::chosenChanged, this, &SearchPage::showChosen);
    connect(table_, &PoseTable::looked, this,
            [this](std::size_t rank) { emit lookAsked(result_.ranking[rank]); });
    connect(table_, &PoseTable::applied, this,
            [this](std::size_t rank) { emit applyAsked(result_.ranking[rank]); });
    connect(apply_, &QPushButton::clicked, this, [this] {
        if (const auto ranks = table_->chosen(); !ranks.empty()) {
            emit applyAsked(result_.ranking[ranks.front()]);
        }
    });
    connect(plot_, &MeasurePlot::picked, table_, &PoseTable::choose);
    connect(map_, &OrientationMap::picked, this, &SearchPage::sideAsked);
    connect(weights_, &WeightFields::changed, this, &SearchPage::aimsChanged);
    connect(weights_, &WeightFields::left, this, &SearchPage::aimsLeft);
    setState(State::Idle);
    clear();
}

QWidget* SearchPage::makeSettings() {
    const SearchSettings usual;
    immersions_->addItem(tr("One dip"), 1);
    immersions_->addItem(tr("Two dips, judged together"), 2);
    immersions_->setToolTip(
        tr("Whether one dip paints the part, or two dips from different sides."));
    immersions_->setAccessibleName(tr("Dips"));
    immersions_->setObjectName(QStringLiteral("searchedImmersions"));
    simulated_->setDecimals(0);
    simulated_->setRange(simulatedRange.least, simulatedRange.most);
    simulated_->setValue(usual.simulated);
    simulated_->setSuffix(tr(" poses"));
    simulated_->setObjectName(QStringLiteral("searchedPoses"));
    simulated_->setToolTip(
        tr("Number of poses that are simulated with a coarse film. They are chosen from %1 poses "
           "that are judged by the part's shape alone. The best simulated poses are refined.")
            .arg(usual.directions));
    seed_->setDecimals(0);
    seed_->setRange(seedRange.least, seedRange.most);
    seed_->setValue(usual.seed);
    seed_->setToolTip(
        tr("The same seed gives the same table. Another seed tries other directions."));
    auto* form = new QFormLayout;
    form->addRow(tr("Dips"), immersions_);
    form->addRow(tr("Simulate"), simulated_);
    form->addRow(tr("Seed"), seed_);
    paths_->setText(tr("Try paths"));
    paths_->setToolTip(
        tr("Also tries paths for the best poses: the part enters the water tilted and is "
           "levelled on the way down, goes down slanted, or, if a depth is set, rolls. So air "
           "can escape, and the film reaches further. Takes about twice as long."));
    paths_->setObjectName(QStringLiteral("searchedPaths"));
    form->addRow(paths_);
    auto* more = new QToolButton;
    more->setText(tr("Weights and limits"));
    more->setCheckable(true);
    more->setAutoRaise(true);
    more->setArrowType(Qt::RightArrow);
    more->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    more->setObjectName(QStringLiteral("weightsShown"));
    auto* scrolled = new QScrollArea;
    scrolled->setWidget(weights_);
    scrolled->setWidgetResizable(true);
    scrolled->setFrameShape(QFrame::NoFrame);
    scrolled->setMinimumHeight(180);
    scrolled->setMaximumHeight(weights_->sizeHint().height() + 4);
    scrolled->hide();
    connect(more, &QToolButton::toggled, this, [more, scrolled](bool shown) {
        scrolled->setVisible(shown);
        more->setArrowType(shown ? Qt::DownArrow : Qt::RightArrow);
    });
    settings_ = new QWidget;
    auto* layout = new QVBoxLayout(settings_);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(form);
    layout->addWidget(more);
    layout->addWidget(scrolled, 1);
    return settings_;
}

QWidget* SearchPage::makeProgress() {
    start_->setIcon(icon(QStringLiteral("optimise")));
    start_->setObjectName(QStringLiteral("startSearch"));
    pause_->setToolTip(
        tr("Leaves the processor to other programs. The search continues where it stopped."));
    pause_->setObjectName(QStringLiteral("pauseSearch"));
    stop_->setToolTip(tr("Ends the search and keeps the best poses found"));
    stop_->setObjectName(QStringLiteral("stopSearch"));
    progress_->setTextVisible(false);
    progress_->setAccessibleName(tr("Progress of the search"));
    auto* row = new QHBoxLayout;
    row->addWidget(start_);
    row->addWidget(pause_);
    row->addWidget(stop_);
    row->addWidget(progress_, 1);
    note_->setWordWrap(true);
    note_->setText(tr("The project has changed since this search. Search again."));
    note_->hide();
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(row);
    layout->addWidget(left_);
    layout->addWidget(note_);
    return page;
}

QWidget* SearchPage::makeFound() {
    comparison_->setWordWrap(true);
    comparison_->setObjectName(QStringLiteral("poseComparison"));
    apply_->setObjectName(QStringLiteral("takePose"));
    apply_->setToolTip(tr("Sets the dips of the project to the pose that is selected in the table. "
                          "Undo takes this back in one step."));
    sideBySide_->setObjectName(QStringLiteral("sideBySide"));
    sideBySide_->setToolTip(tr("Shows two selected poses side by side with linked cameras. If only "
                               "one pose is selected, shows it beside the project's own pose."));
    connect(sideBySide_, &QPushButton::clicked, this, &SearchPage::compareChosen);
    auto* pictures = new QHBoxLayout;
    pictures->addWidget(map_, 1);
    pictures->addWidget(plot_, 1);
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(table_, 2);
    layout->addWidget(comparison_);
    auto* actions = new QHBoxLayout;
    actions->addWidget(apply_, 1);
    actions->addWidget(sideBySide_, 1);
    layout->addLayout(actions);
    layout->addLayout(pictures, 1);
    return page;
}

SearchSettings SearchPage::settings() const {
    SearchSettings settings;
    settings.immersions = immersions_->currentData().toInt();
    settings.simulated = simulated_->wholeValue();
    settings.seed = seed_->wholeValue();
    settings.paths = paths_->isChecked();
    settings.aims = weights_->aims();
    return settings;
}

void SearchPage::setImmersions(int count) {
    immersions_->setCurrentIndex(count - 1);
}

void SearchPage::setAims(const PoseAims& aims) {
    weights_->show(aims);
}

void SearchPage::setState(State state) {
    const bool isIdle = state == State::Idle;
    if (isIdle != (state_ == State::Idle) && !isIdle) {
        searched_ = settings();
        isWaiting_ = false;
        doing_.clear();
        progress_->setRange(0, 1);
        progress_->setValue(0);
    }
    state_ = state;
    settings_->setEnabled(isIdle);
    start_->setEnabled(isIdle);
    pause_->setEnabled(!isIdle);
    pause_->setText(state == State::Paused ? tr("Resume") : tr("Pause"));
    stop_->setEnabled(!isIdle);
    progress_->setVisible(!isIdle);
    if (isIdle) {
        left_->clear();
    }
    left_->setVisible(!isIdle);
}

void SearchPage::setWaiting(bool waiting) {
    isWaiting_ = waiting;
    showDoing(doing_);
}

void SearchPage::setPreparing(const QString& doing) {
    if (progress_->value() <= 0) { // before the first dips
        showDoing(doing);
    }
}

void SearchPage::showDoing(const QString& doing) {
    doing_ = doing;
    left_->setText(isWaiting_ ? tr("Waiting until the dip of the project has finished") : doing);
}

void SearchPage::setProgress(int done, int wanted, bool isRefiningFilm,
                             std::optional<double> secondsLeft) {
    progress_->setRange(0, wanted);
    progress_->setValue(done);
    const QString doing = isRefiningFilm ? tr("Dipping the best pose with smaller cells")
                                         : tr("%1 of %2 dips").arg(done).arg(wanted);
    showDoing(secondsLeft ? QStringLiteral("%1, %2").arg(
                                doing, timeLeftText(steadySeconds(*secondsLeft, {})))
                          : doing);
}

void SearchPage::setResult(const SearchResult& result, const std::vector<QImage>& pictures) {
    result_ = result;
    table_->setResult(result, searched_, pictures);
    map_->setDirections(result.directions);
    plot_->setRanking(result.ranking);
    showChosen();
}

void SearchPage::clear() {
    setResult({}, {});
    note_->hide();
}

void SearchPage::setOutdated(bool outdated) {
    note_->setVisible(outdated && !result_.ranking.empty());
}

void SearchPage::showChosen() {
    const std::vector<std::size_t> ranks = table_->chosen();
    std::vector<Eigen::Vector3d> downs;
    for (const std::size_t rank : ranks) {
        for (const Immersion& immersion : result_.ranking[rank].immersions) {
            downs.push_back(downOf(immersion));
        }
    }
    map_->setChosen(std::move(downs));
    plot_->setChosen(ranks);
    apply_->setEnabled(ranks.size() == 1);
    sideBySide_->setEnabled(ranks.size() == 2 || (ranks.size() == 1 && result_.current));
    comparison_->setVisible(!result_.ranking.empty());
    if (ranks.size() != 2) {
        comparison_->setText(tr("Click a pose to see its film on the part, also during the search. "
                                "Undo brings back your own pose. Select two poses to compare "
                                "them."));
    } else {
        comparison_->setText(
            tr("Rank %1 compared with rank %2: %3")
                .arg(ranks[0] + 1)
                .arg(ranks[1] + 1)
                .arg(reasonText(differences(result_.ranking[ranks[0]], result_.ranking[ranks[1]],
                                            searched_, result_.equator))));
    }
}

ComparedState SearchPage::stateOf(const QString& title, const RankedPoses& poses) const {
    ComparedState state{title, {}, {}};
    state.project.immersions = poses.immersions;
    for (const Measure measure : allMeasures()) {
        if (!appliesToTwoDips(measure) || searched_.immersions == 2) {
            state.figures.push_back(
                {measureName(measure), poses.measures[measure],
                 [measure](double value) { return measureText(measure, value); },
                 isHigherBetter(measure)});
        }
    }
    return state;
}

void SearchPage::compareChosen() {
    const std::vector<std::size_t> ranks = table_->chosen();
    const auto rank = [&](std::size_t number) {
        return stateOf(tr("Rank %1").arg(ranks[number] + 1), result_.ranking[ranks[number]]);
    };
    if (ranks.size() == 2) {
        emit comparisonAsked({rank(0), rank(1)});
    } else if (ranks.size() == 1 && result_.current) {
        emit comparisonAsked({stateOf(tr("The project's own pose"), *result_.current), rank(0)});
    }
}

} // namespace dipwright
