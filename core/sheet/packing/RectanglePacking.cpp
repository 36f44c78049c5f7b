#include "sheet/packing/RectanglePacking.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>
#include <tuple>

namespace dipwright {
namespace {

using Bins = std::vector<std::vector<PackPlace>>;

bool isWithin(QSize size, QSize room) {
    return size.width() <= room.width() && size.height() <= room.height();
}

// A bin that stores its free room as overlapping rectangles, each as large as possible.
class Bin {
public:
    explicit Bin(QSize size) : free_{QRect({0, 0}, size)} {}

    std::optional<PackPlace> place(const PackItem& item) {
        std::optional<PackPlace> best;
        for (const bool turned : {false, true}) {
            const QSize size = turned ? item.size.transposed() : item.size;
            if (item.turning == (turned ? Turning::Never : Turning::Always)) {
                continue;
            }
            for (const QRect& room : free_) {
                const QRect box(room.topLeft(), size);
                if (isWithin(size, room.size()) && (!best || isBefore(box, best->box))) {
                    best = PackPlace{0, box, turned};
                }
            }
        }
        if (best) {
            take(best->box);
        }
        return best;
    }

private:
    static bool isBefore(const QRect& a, const QRect& b) {
        return std::tuple(a.bottom(), a.left()) < std::tuple(b.bottom(), b.left());
    }

    void take(const QRect& box) {
        std::vector<QRect> kept, cut;
        for (const QRect& room : free_) {
            if (!room.intersects(box)) {
                kept.push_back(room);
                continue;
            }
            const QRect rests[]{
                {room.topLeft(), QPoint(room.right(), box.top() - 1)},
                {QPoint(room.left(), box.bottom() + 1), room.bottomRight()},
                {room.topLeft(), QPoint(box.left() - 1, room.bottom())},
                {QPoint(box.right() + 1, room.top()), room.bottomRight()},
            };
            std::copy_if(std::begin(rests), std::end(rests), std::back_inserter(cut),
                         [](const QRect& rest) { return rest.isValid(); });
        }
        for (std::size_t i = 0; i < cut.size(); ++i) {
            const auto holds = [&](const QRect& other) { return other.contains(cut[i]); };
            const auto at = cut.begin() + std::ptrdiff_t(i);
            const bool isHeld = std::any_of(kept.begin(), kept.end(), holds) ||
                                std::any_of(at + 1, cut.end(), holds) ||
                                std::any_of(cut.begin(), at, [&](const QRect& earlier) {
                                    return earlier != cut[i] && earlier.contains(cut[i]);
                                });
            if (!isHeld) {
                kept.push_back(cut[i]);
            }
        }
        free_ = std::move(kept);
    }

    std::vector<QRect> free_;
};

Bins packedInOrder(const std::vector<PackItem>& items, QSize bin, std::vector<std::size_t> order) {
    Bins bins;
    while (!order.empty()) {
        Bin room(bin);
        std::vector<std::size_t> left;
        bins.emplace_back();
        for (const std::size_t item : order) {
            if (std::optional<PackPlace> place = room.place(items[item])) {
                place->item = item;
                bins.back().push_back(*place);
            } else {
                left.push_back(item);
            }
        }
        order = std::move(left);
    }
    return bins;
}

int usedHeight(const std::vector<PackPlace>& places) {
    int height = 0;
    for (const PackPlace& place : places) {
        height = std::max(height, place.box.bottom() + 1);
    }
    return height;
}

} // namespace

bool fits(const PackItem& item, QSize bin) {
    return (item.turning != Turning::Always && isWithin(item.size, bin)) ||
           (item.turning != Turning::Never && isWithin(item.size.transposed(), bin));
}

std::vector<std::vector<PackPlace>> packed(const std::vector<PackItem>& items, QSize bin) {
    const std::function<std::tuple<int, int>(QSize)> keys[]{
        [](QSize size) { return std::tuple(size.height(), size.width()); },
        [](QSize size) { return std::tuple(size.width(), size.height()); },
        [](QSize size) {
            return std::tuple(std::max(size.width(), size.height()),
                              std::min(size.width(), size.height()));
        },
    };
    Bins best;
    for (const auto& key : keys) {
        std::vector<std::size_t> order(items.size());
        std::iota(order.begin(), order.end(), std::size_t(0));
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return key(items[a].size) > key(items[b].size);
        });
        Bins bins = packedInOrder(items, bin, std::move(order));
        if (best.empty() || bins.size() < best.size() ||
            (bins.size() == best.size() && usedHeight(bins.back()) < usedHeight(best.back()))) {
            best = std::move(bins);
        }
    }
    return best;
}

} // namespace dipwright
