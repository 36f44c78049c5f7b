#include "cost/OrderCost.h"

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

constexpr double perMillion = 1e-6, perThousand = 1e-3;
constexpr double secondsPerHour = 3600, secondsPerMinute = 60;

std::optional<double> given(double value) {
    return value > 0 ? std::optional(value) : std::nullopt;
}

int goodRacks(int parts, const WorkCosts& work) {
    return (parts + work.partsPerRack - 1) / work.partsPerRack;
}

double averageRacks(int parts, const WorkCosts& work) {
    return goodRacks(parts, work) / (1 - work.scrap);
}

CostItem filmItem(const OrderToCost& order, double sheets) {
    const FilmAmount& film = order.packed ? *order.packed : order.sheet;
    const double times = order.packed ? 1 : sheets;
    switch (order.film.unit) {
    case FilmPriceUnit::SquareMetre:
        return {
            CostKind::Film, {}, times * film.squareMetres, CostUnit::SquareMetre, order.film.price};
    case FilmPriceUnit::RollMetre:
        return {CostKind::Film, {}, times * film.rollMetres, CostUnit::RollMetre, order.film.price};
    case FilmPriceUnit::Sheet:
        break;
    }
    return {CostKind::Film,
            {},
            times * film.sheets,
            CostUnit::Sheet,
            film.haveSheetPrice ? order.film.price : std::nullopt};
}

// Returns one item for each ink that the dips take.
std::vector<CostItem> inkItems(const OrderToCost& order, double racks) {
    std::vector<InkOfSheet> inks;
    for (const DipCosts& dip : order.dips) {
        for (const InkOfSheet& ink : dip.inks) {
            const auto same = std::find_if(inks.begin(), inks.end(),
                                           [&](const auto& one) { return one.ink == ink.ink; });
            if (same == inks.end()) {
                inks.push_back(ink);
            } else {
                same->area += ink.area;
            }
        }
    }
    std::vector<CostItem> items;
    for (const InkOfSheet& ink : inks) {
        if (ink.area > 0) {
            const std::optional<double> laydown = given(ink.laydown);
            items.push_back(
                {CostKind::Ink, ink.ink,
                 laydown ? std::optional(racks * ink.area * perMillion * *laydown) : std::nullopt,
                 CostUnit::Millilitre, given(ink.price)});
        }
    }
    return items;
}

// Returns the sum over the dips, or none if a dip does not give its time.
template <typename TimeOf>
std::optional<Seconds> overDips(const OrderToCost& order, double racks, TimeOf timeOf) {
    Seconds sum(0);
    for (const DipCosts& dip : order.dips) {
        const std::optional<Seconds> time = timeOf(dip);
        if (!time) {
            return std::nullopt;
        }
        sum = sum + *time;
    }
    return sum * racks;
}

std::optional<Seconds> minutes(const std::optional<double>& count) {
    return count ? std::optional(Seconds(*count * secondsPerMinute)) : std::nullopt;
}

std::vector<TimeItem> timesOf(const OrderToCost& order, double racks) {
    const auto handling = minutes(order.work.handling);
    return {{TimeKind::SetUp, minutes(order.work.setUp)},
            {TimeKind::Handling, overDips(order, racks, [&](const auto&) { return handling; })},
            {TimeKind::Soak, overDips(order, racks, [](const auto& dip) { return dip.soak; })},
            {TimeKind::Activator,
             overDips(order, racks, [](const auto& dip) { return dip.activator; })},
            {TimeKind::Motion,
             overDips(order, racks, [](const auto& dip) { return std::optional(dip.motion); })},
            {TimeKind::Flash, overDips(order, 1, [](const auto& dip) { return dip.flash; })},
            {TimeKind::Drying, overDips(order, 1, [](const auto& dip) { return dip.drying; })}};
}

// Returns the time until the last rack is dry. The tank does one dip after the other.
Seconds elapsed(const OrderToCost& order, int racks) {
    const Seconds none(0);
    Seconds tankFree = minutes(order.work.setUp).value_or(none);
    std::vector<Seconds> dry(std::size_t(racks), none); // when each rack may be dipped
    for (const DipCosts& dip : order.dips) {
        const Seconds atTank = minutes(order.work.handling).value_or(none) +
                               dip.soak.value_or(none) + dip.activator.value_or(none) + dip.motion;
        const Seconds after = dip.flash.value_or(none) + dip.drying.value_or(none);
        for (Seconds& ready : dry) {
            tankFree = std::max(tankFree, ready) + atTank;
            ready = tankFree + after;
        }
    }
    return *std::max_element(dry.begin(), dry.end());
}

} // namespace

std::optional<double> CostItem::cost() const {
    if (!amount || !price) {
        return std::nullopt;
    }
    return *amount * *price * (unit == CostUnit::Millilitre ? perThousand : 1);
}

bool OrderCost::isComplete() const {
    return std::all_of(items.begin(), items.end(), [](const auto& item) { return item.cost(); });
}

bool OrderCost::hasPrices() const {
    return std::any_of(items.begin(), items.end(), [](const auto& item) { return item.cost(); });
}

int racksOf(int parts, const WorkCosts& work) {
    constexpr double rounding = 1e-9;
    return int(std::ceil(averageRacks(parts, work) - rounding));
}

OrderCost costOf(const OrderToCost& order) {
    OrderCost cost;
    cost.parts = order.parts;
    cost.racks = averageRacks(order.parts, order.work);
    cost.areInksEstimated = order.areInksEstimated;
    cost.currency = order.work.currency;
    const int racks = racksOf(order.parts, order.work);
    cost.sheets = racks * int(order.dips.size());
    cost.times = timesOf(order, cost.racks);
    for (const TimeItem& time : cost.times) {
        if (time.isWork()) {
            cost.work = cost.work + time.time.value_or(Seconds(0));
        }
    }
    cost.elapsed = elapsed(order, racks);
    cost.items = inkItems(order, cost.racks);
    cost.items.insert(cost.items.begin(), filmItem(order, cost.racks * double(order.dips.size())));
    cost.items.push_back({CostKind::Labour,
                          {},
                          cost.work.value() / secondsPerHour,
                          CostUnit::Hour,
                          order.work.labourRate});
    for (const CostItem& item : cost.items) {
        cost.known += item.cost().value_or(0);
    }
    return cost;
}

} // namespace dipwright
