// The user's settings for the pose search: the goals, and the number of poses that are tried
// (docs/pose-search.md).
#pragma once

#include "settings/ToleranceSettings.h"

#include <QString>

#include <array>
#include <optional>

namespace dipwright {

// The measures by which a pose, or a pair of poses, is judged. Shares are 0 … 1.
enum class Measure : std::uint8_t {
    Quality,    // printQuality() over the body, weighted by zone; 0 where nothing is painted
    Coverage,   // painted share of the surface
    Stretch,    // 99th percentile of λ1 on the painted area
    Certain,    // share of the painted area on film without marks (dip/FilmMarks.h)
    Wrinkled,   // share of the painted area where film is pushed together (gatheredBelow)
    Torn,       // share of the painted area on torn film
    TrappedAir, // share of the surface that trapped air keeps from the film
    Join,       // length of the seam between two dips, mm; 0 for one dip
    Narrow,   // share of the seam whose overlap is too narrow for both films to fade; 0 for one dip
    FilmUsed, // share of the sheet inside the bounding box of the film that paints; for two dips,
              // the mean of both
};
inline constexpr std::size_t measureCount = 10;
const std::array<Measure, measureCount>& allMeasures();

template <typename Value>
struct PerMeasure {
    std::array<Value, measureCount> values{};
    Value& operator[](Measure measure) { return values[std::size_t(measure)]; }
    const Value& operator[](Measure measure) const { return values[std::size_t(measure)]; }
    bool operator==(const PerMeasure&) const = default;
};
using PoseMeasures = PerMeasure<double>;
// Any larger stretch is treated as this one.
inline constexpr double largestStretch = 15.99;

QString measureKey(Measure measure);  // "quality", "trapped_air": name on the command line
QString measureName(Measure measure); // name for the user: "Quality", "Trapped air"
// Value with its unit, in the default locale: "93.1 %", "1.84", "≥ 16", "212 mm".
QString measureText(Measure measure, double value);
bool isHigherBetter(Measure measure);
bool appliesToTwoDips(Measure measure); // applies to pairs only
double mostLimit(Measure measure);      // a limit may be from 0 to this value
QString zoneKey(std::size_t zone);      // "zone_a"

// Allowed values of a setting, ends included.
struct SettingRange {
    int least, most;
};
inline constexpr SettingRange directionsRange{6, 20'000}, simulatedRange{6, 2000},
    refinedRange{0, 50}, finerRange{1, 100}, confirmedRange{0, 20}, seedRange{0, 1'000'000};
// The largest weights; the smallest is 0.
inline constexpr double mostWeight = 100, mostZoneWeight = 1000;

// The goals for a pose, which a project stores (project/Project.h).
struct PoseAims {
    // Each is 0 to mostWeight, and not all are 0 (docs/pose-search.md, "The objective").
    PerMeasure<double> weights{{1, 0.5, 0.1, 0.5, 0.1, 0.5, 0.5, 0.1, 0.2, 0.05}};
    // Weight of the quality in each zone, 0 to mostZoneWeight.
    std::array<double, zoneCount> zoneWeights{4, 2, 1};
    // A lower limit if more of the measure is better, otherwise an upper limit. Poses that break a
    // limit rank after all others.
    PerMeasure<std::optional<double>> limits;
    bool operator==(const PoseAims&) const = default;
};

struct SearchSettings {
    int immersions = 1;    // 1 or 2
    int directions = 2000; // number of directions that are judged by geometry alone
    int simulated = 64;    // number of these that are simulated by one coarse dip each
    int refined = 4;       // number of the best that are tilted
    int finer = 12; // number of the best that are simulated with finer film; these dips rank them
    int confirmed = 3;  // number of the best that are simulated with the film and field of the job
    int seed = 1;       // for the random directions
    bool paths = false; // whether the best poses are also tried with paths (settings/DipPath.h)
    PoseAims aims;
    bool operator==(const SearchSettings&) const = default;
};

// Throws Error that names the setting and its limits.
void requireValid(const SearchSettings& settings);
// Sets the weight of a measure or of zone A, B or C by its key. Throws Error if the key is unknown
// or the value out of range.
void setWeight(PoseAims& aims, const QString& key, double value);
// Sets the limit of a measure by its key; no value removes the limit. Throws Error as setWeight()
// does.
void setLimit(PoseAims& aims, const QString& key, std::optional<double> value);

} // namespace dipwright
