// Finds what can be done where ink does not suffice on stretched film, and computes what each
// option gives (docs/ink-limits.md).
#pragma once

#include "base/Progress.h"
#include "pipeline/JobResult.h"

namespace dipwright {

// Asked for if the ink of a job falls short on at least this area of the part, mm².
inline constexpr double leastShortArea = 2;

// How well the ink of all dips together shows the texture. Densities are optical densities of the
// light or ink in which most is missing; what exceeds the ink limit on unstretched
// film counts as the limit.
struct InkReach {
    double shortShare = 0; // of the painted surface: visibly too pale, 0 … 1
    double missing95 = 0;  // 95th percentile of the missing density where ink is short now
    double mostMissing = 0;
    // How much of the texture's contrast shows where ink is short now: the ratio of the standard
    // deviations of the lightness L*. NaN where the texture has no contrast there.
    double contrast = 1;
    // Mean difference to the texture's own colours over the painted surface, CIE ΔE 1976. Takes
    // the part's own colour and white into account.
    double colourError = 0;
};

enum class InkRemedy { LighterTexture, WhiteBeneath, SecondPass, OtherPose };
QString remedyKey(InkRemedy remedy); // "lighter_texture"
// The project's field that the option sets: "ink.densest"; empty for OtherPose.
QString remedyField(InkRemedy remedy);

struct InkOption {
    InkRemedy remedy = InkRemedy::LighterTexture;
    // LighterTexture: InkSettings::densest. SecondPass: InkSettings::passes. OtherPose: the area
    // stretch up to which ink suffices on 95 % of the surface where it is short now.
    double value = 0;
    std::optional<InkReach> reach; // none for OtherPose, which a search must find
};

struct InkOptions {
    double paintedArea = 0; // mm² of all dips
    InkReach now;
    std::vector<InkOption> options; // that apply to the project, in the order of InkRemedy
};

// Computes the options, from the texture and the stretch at about a million places of each film. If
// the printer's inks are compensated separately, the densities are those of its inks, within its
// total area coverage, and colours are compared with the printer's own on unstretched film. Returns
// none if the sheets show no texture or are not compensated, or if ink is short on less than
// leastShortArea. Uses all cores; deterministic. Throws Cancelled.
std::optional<InkOptions> inkOptions(const JobResult& result, const Progress& progress);

// Changes the project as the option says. OtherPose gives stretch more weight in the project's pose
// search.
void take(Project& project, const InkOption& option);

// Returns sentences for the user: what the option does; what it gives in figures, relative to
// `options.now`.
QString remedyText(const InkOption& option);
QString reachText(const InkReach& reach);
QString optionText(const InkOption& option);

} // namespace dipwright
