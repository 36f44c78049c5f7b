// Stores the measurements of one dip of a search, and combines the measurements of two dips.
// Private to this folder.
#pragma once

#include "accuracy/verdict/Verdict.h"
#include "dip/LaidFilm.h"
#include "search/SearchSubject.h"
#include "settings/SearchSettings.h"

#include <memory>

namespace dipwright {

// The film at one sampled place of the body. Stretches are in units of 1/4096; 0 means unpainted.
struct PaintedSample {
    std::uint16_t larger = 0, smaller = 0;
    std::uint8_t marks = 0; // solver::PointMark bits
    bool operator==(const PaintedSample&) const = default;
};

struct JudgedPose {
    Immersion immersion;
    std::vector<PaintedSample> samples; // one per sampled place; empty if the dip failed
    std::vector<float> depths; // mm along the surface from each place to the end of the paint
    double trappedAir = 0;     // share of the surface that is in trapped air
    double filmUsed = 0;       // share of the film's area that paints
    QString tankFaults;        // sentences on limits of the tank that the dip exceeds
    // The verdict on the dip, but not on its ink. Only poses that were dipped with the job's own
    // film are judged.
    Verdict verdict;
};

// The places of a body at which its dips are measured. Immutable; any thread may use it.
class JudgedBody {
public:
    // `zoneWeights` holds the weight of each zone. Throws Error if the whole body is masked.
    JudgedBody(const SearchSubject& subject, const std::array<double, zoneCount>& zoneWeights);

    std::size_t places() const { return samples_.size(); }
    double equator() const { return equator_; } // mm: circumference of a ball of equal surface

    // Measures one dip.
    JudgedPose judged(const LaidFilm& laid, const Immersion& immersion) const;
    // Computes JudgedPose::depths. The depths are infinite if the dip paints everything.
    std::vector<float> depths(const std::vector<PaintedSample>& samples) const;
    // Measures one or two dips together, in this order. Each place counts for the dip that paints
    // it better.
    PoseMeasures measures(const std::vector<const JudgedPose*>& dips) const;

private:
    struct Link {
        std::uint32_t sample = 0;
        float length = 0; // mm
    };

    void linkNeighbours();
    bool isNarrow(std::size_t sample, const std::vector<const JudgedPose*>& dips) const;
    void measureSeam(const std::vector<std::uint8_t>& painters,
                     const std::vector<const JudgedPose*>& dips, PoseMeasures& measures) const;

    std::shared_ptr<const TexturedMesh> model_;
    std::vector<SurfacePoint> samples_;
    std::vector<float> weights_;
    std::vector<std::vector<Link>> links_; // from each sample to the samples within linkReach_
    // Per place: the overlap that it needs with unstretched film, mm.
    std::vector<float> bands_;
    double area_ = 0, openArea_ = 0, linkReach_ = 0, equator_ = 0;
};

} // namespace dipwright
