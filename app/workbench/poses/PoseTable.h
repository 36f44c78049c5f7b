// Lists the poses that a search has found, best first: picture, measures and reasons.
#pragma once

#include "search/PoseSearch.h"

#include <QImage>
#include <QTableWidget>

namespace dipwright {

class PoseTable : public QTableWidget {
    Q_OBJECT

public:
    explicit PoseTable(QWidget* parent = nullptr);

    // The same poses stay selected, whatever their new ranks. `pictures`: front views by rank; may
    // be shorter while they are being drawn.
    void setResult(const SearchResult& result, const SearchSettings& settings,
                   const std::vector<QImage>& pictures);
    std::vector<std::size_t> chosen() const; // ranks, in order of selection
    void choose(std::size_t rank);

signals:
    void chosenChanged();
    void looked(std::size_t rank);  // a click without Shift or Ctrl
    void applied(std::size_t rank); // double-click, or Return

private:
    std::vector<std::vector<Immersion>> chosenPoses() const;
    void choosePoses(const std::vector<std::vector<Immersion>>& chosen); // those in the ranking

    std::vector<std::vector<Immersion>> poses_; // by rank
};

} // namespace dipwright
