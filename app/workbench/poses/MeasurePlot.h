// Poses by two of their measures, and which of them no other beats in both.
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

// Of poses that are as good in two measures as any other is: none beats them in one without being
// worse in the other. In the ranking's order.
std::vector<std::size_t> unbeaten(const std::vector<RankedPoses>& ranking, Measure one,
                                  Measure other);

} // namespace dipwright
