// One dip as the search remembers it, and what dips together are worth. Private to this folder.
#pragma once

#include "dip/LaidFilm.h"
#include "search/SearchSubject.h"
#include "settings/SearchSettings.h"

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
    std::vector<float> depths; // mm along the body from each place to where the dip's paint ends
    double trappedAir = 0;     // share of the surface
    double filmUsed = 0;       // share of the sheet
};

// The places that the dips of a body are judged at. Immutable; any thread may ask.
class JudgedBody {
public:
    // Its zones are weighed by `zoneWeights`.
    JudgedBody(const SearchSubject& subject, const std::array<double, zoneCount>& zoneWeights);

    std::size_t places() const { return samples_.size(); }
    double equator() const { return equator_; } // mm: the girth of a ball with this surface

    JudgedPose judged(const LaidFilm& laid, const Immersion& immersion) const;
    // As JudgedPose has them. Infinite where the dip paints everything.
    std::vector<float> depths(const std::vector<PaintedSample>& samples) const;
    // Of one or two dips together, in this order: each place counts for the one that paints it
    // better.
    PoseMeasures measures(const std::vector<const JudgedPose*>& dips) const;

private:
    struct Link {
        std::uint32_t sample = 0;
        float length = 0; // mm
    };

    void linkNeighbours();
    bool isNarrow(std::size_t sample, const std::vector<const JudgedPose*>& dips) const;
    void measureJoin(const std::vector<std::uint8_t>& painters,
                     const std::vector<const JudgedPose*>& dips, PoseMeasures& measures) const;

    std::shared_ptr<const TexturedMesh> model_;
    std::vector<SurfacePoint> samples_;
    std::vector<float> weights_;
    std::vector<std::vector<Link>> links_; // from each sample to those within joinReach_
    std::vector<float> bands_; // mm: the overlap that each place takes, of film not drawn out
    double area_ = 0, joinReach_ = 0, equator_ = 0;
};

} // namespace dipwright
