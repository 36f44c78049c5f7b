// The page of the pose search: settings, progress and found poses.
#pragma once

#include "search/PoseSearch.h"
#include "workbench/results/StateFigures.h"

#include <QImage>
#include <QWidget>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QCheckBox;

namespace dipwright {

class MeasurePlot;
class NumberBox;
class OrientationMap;
class PoseTable;
class WeightFields;

class SearchPage : public QWidget {
    Q_OBJECT

public:
    explicit SearchPage(QWidget* parent = nullptr);

    SearchSettings settings() const;
    void setImmersions(int count); // the proposed number of dips
    void setAims(const PoseAims& aims);
    enum class State { Idle, Searching, Paused };
    void setState(State state);
    // Shows whether the search waits for the project's own dip.
    void setWaiting(bool waiting);
    // Shows what the search does before its first dips.
    void setPreparing(const QString& doing);
    void setProgress(int done, int wanted, bool isRefiningFilm, std::optional<double> secondsLeft);
    // `pictures`: front views by rank; may be shorter while they are being drawn.
    void setResult(const SearchResult& result, const std::vector<QImage>& pictures);
    void clear();
    void setOutdated(bool outdated); // the project has changed since the search

signals:
    void startAsked();
    void aimsChanged(const QString& what); // the user changed settings().aims
    void aimsLeft();                       // the focus went elsewhere
    void pauseAsked(bool paused);
    void stopAsked();
    void lookAsked(const RankedPoses& poses); // the user clicked a pose
    void applyAsked(const RankedPoses& poses);
    // The states have no projects yet.
    void comparisonAsked(const std::array<dipwright::ComparedState, 2>& states);
    void sideAsked(const Eigen::Vector3d& down); // from the map

private:
    QWidget* makeSettings();
    QWidget* makeProgress();
    QWidget* makeFound();
    void showChosen();
    void showDoing(const QString& doing);
    ComparedState stateOf(const QString& title, const RankedPoses& poses) const;
    void compareChosen();

    QComboBox* immersions_;
    NumberBox* simulated_;
    NumberBox* seed_;
    QCheckBox* paths_;
    WeightFields* weights_;
    QWidget* settings_;
    QPushButton* start_;
    QPushButton* pause_;
    QPushButton* stop_;
    QProgressBar* progress_;
    QLabel* left_;
    QLabel* note_;
    PoseTable* table_;
    OrientationMap* map_;
    MeasurePlot* plot_;
    QLabel* comparison_;
    QPushButton* apply_;
    QPushButton* sideBySide_;
    SearchResult result_;
    SearchSettings searched_; // the settings of the result
    State state_ = State::Idle;
    bool isWaiting_ = false;
    QString doing_; // what left_ shows unless the search waits
};

} // namespace dipwright
