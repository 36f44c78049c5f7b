// What the user weighs when poses are searched, and how much is tried (docs/pose-search.md).
#pragma once

#include "settings/ToleranceSettings.h"

#include <QString>

#include <array>
#include <optional>

namespace dipwright {

// What a pose, or a pair of them, is judged by. Shares are 0 … 1.
enum class Measure : std::uint8_t {
    Quality,    // printQuality() over the body, by the weight of its zones; 0 where none is painted
    Coverage,   // share of the surface that is painted
    Stretch,    // λ1 that all but a hundredth of what is painted keeps below
    Certain,    // share of what is painted that lies on film without marks (dip/FilmMarks.h)
    Wrinkled,   // share of what is painted where the film is pushed together (gatheredBelow)
    Torn,       // share of what is painted that lies on film that tore
    TrappedAir, // share of the surface that film cannot reach because air is caught there
    Join,       // mm of the line between two dips' shares; 0 of one dip
    Narrow,     // share of it where both dips reach less than the films need to fade; likewise
    FilmUsed,   // share of the sheet within the box round what paints; of two dips the mean
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
// Larger stretches are not told apart from it.
inline constexpr double largestStretch = 15.99;

QString measureKey(Measure measure);  // "quality", "trapped_air": on the command line
QString measureName(Measure measure); // for the user: "Quality", "Trapped air"
// "93.1 %", "1.84", "≥ 16", "212 mm"
QString measureText(Measure measure, double value);
bool isMoreBetter(Measure measure);
bool isOfTwoDips(Measure measure); // counts for pairs only
double mostLimit(Measure measure); // that one may be given, from 0 on
QString zoneKey(std::size_t zone); // "zone_a"

// What the settings may be, ends included.
struct SettingRange {
    int least, most;
};
inline constexpr SettingRange directionsRange{6, 20'000}, simulatedRange{6, 2000},
    refinedRange{0, 50}, finerRange{1, 100}, confirmedRange{0, 20}, seedRange{0, 1'000'000};
inline constexpr double mostWeight = 100, mostZoneWeight = 1000; // from 0 on

// What is wanted of a pose; a project keeps it (project/Project.h).
struct PoseAims {
    // Up to mostWeight each, not all of them 0 (docs/pose-search.md, "The objective").
    PerMeasure<double> weights{{1, 0.5, 0.1, 0.5, 0.1, 0.5, 0.5, 0.1, 0.2, 0.05}};
    std::array<double, zoneCount> zoneWeights{4, 2,
                                              1}; // of a place's quality, up to mostZoneWeight
    // The least that is wanted of a measure of which more is better, the most of any other. What
    // does not keep them comes after all that does.
    PerMeasure<std::optional<double>> limits;
    bool operator==(const PoseAims&) const = default;
};

struct SearchSettings {
    int immersions = 1;    // 1 or 2
    int directions = 2000; // judged by their geometry
    int simulated = 96;    // of those, each by one coarse dip
    int refined = 6;       // of the best, in angle, turn and offset
    int finer = 12;        // of the best, with finer film, which ranks them
    int confirmed = 3;     // of the best, with the film and the field of the job
    int seed = 1;          // of the directions
    PoseAims aims;
    bool operator==(const SearchSettings&) const = default;
};

// Throws Error that names the setting and its limits.
void requireValid(const SearchSettings& settings);
// Sets the weight or the limit of a measure, or the weight of zone A, B or C, by key; without a
// value no limit. Throws Error where there is no such key or the value is out of range.
void setWeight(PoseAims& aims, const QString& key, double value);
void setLimit(PoseAims& aims, const QString& key, std::optional<double> value);

} // namespace dipwright
