// Computes what an order of parts costs and how long it takes, from what one dip takes and from the
// prices in the profiles. Pure values; nothing that is unknown is counted as 0
// (docs/files-and-commands.md, "Cost of an order").
#pragma once

#include "settings/Costs.h"

#include <QString>
#include <optional>
#include <vector>

namespace dipwright {

// The ink that one sheet takes. `laydown` in ml/m², `price` of a litre; 0: not given.
struct InkOfSheet {
    QString ink;
    double area = 0; // mm² of the film at full tint
    double laydown = 0, price = 0;
};

// What one dip takes. A time is none if it is not known.
struct DipCosts {
    std::vector<InkOfSheet> inks;
    std::optional<Seconds> soak, activator;
    Seconds motion{0}; // of the part: approach, dip, hold, lift
    std::optional<Seconds> flash, drying;
};

// An amount of film.
struct FilmAmount {
    double squareMetres = 0, rollMetres = 0, sheets = 0;
    bool haveSheetPrice = true; // the sheets have the size for which the price of a sheet is given
};

struct OrderToCost {
    int parts = 1; // good parts
    std::vector<DipCosts> dips;
    FilmAmount sheet; // of one sheet; every dip takes a sheet of its own
    // Film for all sheets of the order if several share a film (sheetsOf()); none: each sheet is a
    // film of its own.
    std::optional<FilmAmount> packed;
    bool areInksEstimated = false; // the sheet was not separated (sheet/prepress/Separation.h)
    FilmCosts film;
    WorkCosts work;
};

enum class CostKind { Film, Ink, Labour };
enum class CostUnit { SquareMetre, RollMetre, Sheet, Millilitre, Hour };

struct CostItem {
    CostKind kind = CostKind::Film;
    QString ink;                  // name of the ink
    std::optional<double> amount; // none: the laydown of the ink is not given
    CostUnit unit = CostUnit::SquareMetre;
    std::optional<double> price; // of one unit; of ink: of a litre
    std::optional<double> cost() const;
    bool operator==(const CostItem&) const = default;
};

enum class TimeKind { SetUp, Handling, Soak, Activator, Motion, Flash, Drying };

// A time of the whole order; none: not given. Flash and drying are the time of one rack, because
// racks dry side by side.
struct TimeItem {
    TimeKind kind = TimeKind::SetUp;
    std::optional<Seconds> time;
    bool isWork() const { return kind < TimeKind::Flash; }
    bool operator==(const TimeItem&) const = default;
};

struct OrderCost {
    int parts = 1;
    double racks = 1; // racks to dip for these good parts, with the scrap, on average
    int sheets = 1;   // to print, rounded up
    std::vector<CostItem> items;
    std::vector<TimeItem> times;
    Seconds work{0};    // in which somebody works; the known times
    Seconds elapsed{0}; // from the set-up until the last part is dry; the known times
    double known = 0;   // sum of the known costs
    bool areInksEstimated = false;
    QString currency;

    bool isComplete() const; // every item has its cost
    bool hasPrices() const;  // at least one item has its cost
    bool operator==(const OrderCost&) const = default;
};

// Racks to dip for the good parts of an order, with the scrap, rounded up. Each takes one sheet for
// each dip.
int racksOf(int parts, const WorkCosts& work);

// Racks, with the scrap, multiply film, ink and work. One tank: first, all racks do dip 1, then all
// do dip 2, each as soon as it is dry. Racks dry side by side.
OrderCost costOf(const OrderToCost& order);

} // namespace dipwright
