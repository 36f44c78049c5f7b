// The page of the pose search: what counts, how far it is, what was found.
#pragma once

#include "search/PoseSearch.h"
#include "workbench/results/StateFigures.h"

#include <QImage>
#include <QWidget>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace dipwright {

class MeasurePlot;
class OrientationMap;
class PoseTable;
class WeightFields;

class SearchPage : public QWidget {
    Q_OBJECT

public:
    explicit SearchPage(QWidget* parent = nullptr);

    SearchSettings settings() const;
    void setImmersions(int count); // what is proposed
    void setAims(const PoseAims& aims);
    enum class State { Idle, Searching, Paused };
    void setState(State state);
    void setProgress(int done, int wanted, std::optional<double> secondsLeft);
    // `pictures`: of the ranks, from the front; fewer: not yet.
    void setResult(const SearchResult& result, const std::vector<QImage>& pictures);
    void clear();
    void setOutdated(bool outdated); // the project is not what was searched for any more

signals:
    void startAsked();
    void aimsChanged(const QString& what); // settings().aims, by the user
    void aimsLeft();                       // and has turned to something else
    void pauseAsked(bool paused);
    void stopAsked();
    void applyAsked(const RankedPoses& poses);
    void comparisonAsked(const std::array<dipwright::ComparedState, 2>& states); // without projects
    void sideAsked(const Eigen::Vector3d& down);                                 // of the map

private:
    QWidget* makeSettings();
    QWidget* makeProgress();
    QWidget* makeFound();
    void showChosen();
    ComparedState stateOf(const QString& title, const RankedPoses& poses) const;
    void compareChosen();

    QComboBox* immersions_;
    QSpinBox* simulated_;
    QSpinBox* seed_;
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
    SearchSettings searched_; // that the result is of
    State state_ = State::Idle;
};

} // namespace dipwright
