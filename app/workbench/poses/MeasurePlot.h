// Plots poses by two of their measures and marks the poses that no other pose beats in both.
#pragma once

#include "search/PoseSearch.h"

#include <QWidget>

class QComboBox;

namespace dipwright {

class MeasurePlot : public QWidget {
    Q_OBJECT

public:
    explicit MeasurePlot(QWidget* parent = nullptr);

    void setRanking(const std::vector<RankedPoses>& ranking);
    void setChosen(const std::vector<std::size_t>& ranks);

signals:
    void picked(std::size_t rank);

private:
    class Field;
    QComboBox* makeChoice(Measure measure, const QString& name);
    QString textOf(std::size_t rank) const;
    void draw();

    QComboBox* across_;
    QComboBox* up_;
    Field* field_;
    std::vector<RankedPoses> ranking_;
};

// Returns the ranks of the poses that no other pose beats, in the ranking's order. A pose beats
// another if it is better in one measure and not worse in the other.
std::vector<std::size_t> paretoOptimalRanks(const std::vector<RankedPoses>& ranking, Measure one,
                                            Measure other);

} // namespace dipwright
