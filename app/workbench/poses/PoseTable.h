// The poses that a search has found, the best first: how they look, what they measure, why.
#pragma once

#include "search/PoseSearch.h"

#include <QImage>
#include <QTableWidget>

namespace dipwright {

class PoseTable : public QTableWidget {
    Q_OBJECT

public:
    explicit PoseTable(QWidget* parent = nullptr);

    // Keeps what is chosen where its rank is still there. `pictures`: of each rank, from the front;
    // fewer: not yet.
    void setResult(const SearchResult& result, const SearchSettings& settings,
                   const std::vector<QImage>& pictures);
    std::vector<std::size_t> chosen() const; // ranks, the first chosen first
    void choose(std::size_t rank);

signals:
    void chosenChanged();
    void applied(std::size_t rank); // double click, or Return
};

} // namespace dipwright
