// One dip as the search remembers it, and what dips together are worth. Private to this folder.
#pragma once

#include "dip/LaidFilm.h"
#include "search/SearchSettings.h"

#include <memory>

namespace dipwright {

// What a dip does to one of the places that a body is judged at; stretches in 1/4096, 0: unpainted.
struct PaintedSample {
    std::uint16_t larger = 0, smaller = 0;
    std::uint8_t marks = 0; // solver::PointMark bits
    bool operator==(const PaintedSample&) const = default;
};

struct JudgedPose {
    Immersion immersion;
    std::vector<PaintedSample> samples; // a place of the body each; empty: the dip failed
    double trappedAir = 0;              // share of the surface
    double filmUsed = 0;                // share of the sheet
};

// The places that the dips of a body are judged at. Immutable; any thread may ask.
class JudgedBody {
public:
    // Zones: those of `marks`, weighed by `zoneWeights`.
    JudgedBody(std::shared_ptr<const TexturedMesh> model, const std::vector<ZoneMark>& marks,
               const std::array<double, zoneCount>& zoneWeights);

    std::size_t places() const { return samples_.size(); }
    double equator() const { return equator_; } // mm: the girth of a ball with this surface

    JudgedPose judged(const LaidFilm& laid, const Immersion& immersion) const;
    // Of one or two dips together: each place counts for the one that paints it better.
    PoseMeasures measures(const std::vector<const JudgedPose*>& dips) const;

private:
    void linkNeighbours();
    double joinLength(const std::vector<std::uint8_t>& painters) const;

    std::shared_ptr<const TexturedMesh> model_;
    std::vector<SurfacePoint> samples_;
    std::vector<float> weights_;
    std::vector<std::array<std::uint32_t, 2>> links_; // samples within joinReach_ of each other
    double area_ = 0, joinReach_ = 0, equator_ = 0;
};

} // namespace dipwright
