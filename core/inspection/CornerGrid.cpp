#include "inspection/CornerGrid.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

namespace dipwright {

namespace {

constexpr std::size_t leastCorners = 12;
constexpr int mostSeeds = 400; // number of first corners that are tried per picture
constexpr int mostReach = 80;  // columns and rows from the first corner

class Grower {
public:
    Grower(const cv::Mat& blurred, const std::vector<Saddle>& saddles)
        : blurred_(blurred), saddles_(saddles), used_(saddles.size(), false) {}

    // Grows grids from the strongest saddles that are in no grid yet.
    std::vector<CornerGrid> grids() {
        std::vector<CornerGrid> found;
        int seeds = 0;
        for (std::size_t seed = 0; seed < saddles_.size() && seeds < mostSeeds; ++seed) {
            if (used_[seed]) {
                continue;
            }
            ++seeds;
            place_.clear();
            waiting_.clear();
            if (plant(seed)) {
                grow();
            }
            if (place_.size() >= leastCorners) {
                found.push_back(taken());
            } else {
                for (const auto& [at, saddle] : place_) {
                    used_[saddle] = false;
                }
            }
        }
        return found;
    }

private:
    // Places the first corner and its four neighbours along its edges.
    bool plant(std::size_t seed) {
        put({0, 0}, seed);
        for (std::size_t edge = 0; edge < 2; ++edge) {
            const double angle = saddles_[seed].edges[edge];
            const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
            for (const int side : {1, -1}) {
                const auto next = nextAlong(seed, side * along);
                if (next) {
                    put(edge == 0 ? GridPlace(side, 0) : GridPlace(0, side), *next);
                }
            }
        }
        return place_.size() >= 4;
    }

    void grow() {
        // Repeats, because a newly placed corner can help its neighbours to find the next corners.
        for (std::size_t before = 0; before != place_.size();) {
            before = place_.size();
            for (const auto& [at, saddle] : place_) {
                waiting_.push_back(at);
            }
            while (!waiting_.empty()) {
                const GridPlace at = waiting_.front();
                waiting_.pop_front();
                for (const auto& [dx, dy] : {GridPlace{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                    growTo(at, dx, dy);
                }
            }
        }
    }

    void growTo(GridPlace from, int dx, int dy) {
        const GridPlace to{from.first + dx, from.second + dy};
        if (place_.contains(to) || std::max(std::abs(to.first), std::abs(to.second)) > mostReach) {
            return;
        }
        const auto step = expectedStep(from, dx, dy);
        if (!step) {
            return;
        }
        const Saddle& start = saddles_[place_.at(from)];
        const auto found = nearest(start.place + *step, 0.3 * step->norm());
        if (found && isEdgeBetween(start, saddles_[*found])) {
            put(to, *found);
        }
    }

    // Returns the previous step on the same line if it is known, otherwise the same step on a
    // neighbouring line.
    std::optional<Eigen::Vector2d> expectedStep(GridPlace from, int dx, int dy) const {
        const auto [i, j] = from;
        const auto stepFrom = [&](int column, int row) -> std::optional<Eigen::Vector2d> {
            const auto first = place_.find({column, row});
            const auto second = place_.find({column + dx, row + dy});
            if (first == place_.end() || second == place_.end()) {
                return std::nullopt;
            }
            return saddles_[second->second].place - saddles_[first->second].place;
        };
        for (const auto& [column, row] :
             {GridPlace{i - dx, j - dy}, {i + dy, j + dx}, {i - dy, j - dx}}) {
            if (const auto step = stepFrom(column, row)) {
                return step;
            }
        }
        return std::nullopt;
    }

    std::optional<std::size_t> nearest(const Eigen::Vector2d& place, double within) const {
        std::optional<std::size_t> best;
        for (std::size_t i = 0; i < saddles_.size(); ++i) {
            const double distance = (saddles_[i].place - place).norm();
            if (!used_[i] && distance < within) {
                within = distance;
                best = i;
            }
        }
        return best;
    }

    // Returns the nearest saddle that lies in a narrow cone and to which an edge runs.
    std::optional<std::size_t> nextAlong(std::size_t from, const Eigen::Vector2d& along) const {
        constexpr double cone = 0.25;   // sine of its half angle
        constexpr double leastStep = 8; // pixels
        std::vector<std::pair<double, std::size_t>> ahead;
        for (std::size_t i = 0; i < saddles_.size(); ++i) {
            const Eigen::Vector2d way = saddles_[i].place - saddles_[from].place;
            const double length = way.norm();
            const double aside = along.x() * way.y() - along.y() * way.x();
            if (!used_[i] && length > leastStep && way.dot(along) > 0 &&
                std::abs(aside) < cone * length) {
                ahead.emplace_back(length, i);
            }
        }
        constexpr std::size_t tried = 3;
        const auto last = ahead.begin() + std::ptrdiff_t(std::min(tried, ahead.size()));
        std::partial_sort(ahead.begin(), last, ahead.end());
        for (auto next = ahead.begin(); next != last; ++next) {
            if (isEdgeBetween(saddles_[from], saddles_[next->second])) {
                return next->second;
            }
        }
        return std::nullopt;
    }

    bool isEdgeBetween(const Saddle& from, const Saddle& to) const {
        return isEdge(blurred_, from.place, to.place, std::min(from.contrast, to.contrast));
    }

    void put(GridPlace at, std::size_t saddle) {
        place_[at] = saddle;
        used_[saddle] = true;
        waiting_.push_back(at);
    }

    CornerGrid taken() const {
        CornerGrid grid;
        for (const auto& [at, saddle] : place_) {
            grid.corners[at] = saddles_[saddle].place;
        }
        return grid;
    }

    const cv::Mat& blurred_;
    const std::vector<Saddle>& saddles_;
    std::vector<bool> used_;
    std::map<GridPlace, std::size_t> place_;
    std::deque<GridPlace> waiting_;
};

} // namespace

const Eigen::Vector2d* CornerGrid::at(int column, int row) const {
    const auto found = corners.find({column, row});
    return found == corners.end() ? nullptr : &found->second;
}

bool CornerGrid::hasSteps(GridPlace place) const {
    const auto [i, j] = place;
    return (at(i + 1, j) || at(i - 1, j)) && (at(i, j + 1) || at(i, j - 1));
}

GridSteps CornerGrid::steps(GridPlace place) const {
    const auto [i, j] = place;
    const Eigen::Vector2d& here = corners.at(place);
    const auto step = [&](const Eigen::Vector2d* before, const Eigen::Vector2d* after) {
        return before && after ? Eigen::Vector2d((*after - *before) / 2)
               : after         ? Eigen::Vector2d(*after - here)
                               : Eigen::Vector2d(here - *before);
    };
    return {step(at(i - 1, j), at(i + 1, j)), step(at(i, j - 1), at(i, j + 1))};
}

std::vector<CornerGrid> findGrids(const cv::Mat& blurred, const std::vector<Saddle>& saddles) {
    return Grower(blurred, saddles).grids();
}

} // namespace dipwright
