// Stores the measurements of one dip of a search, and combines the measurements of two dips.
// Private to this folder.
#pragma once

#include "accuracy/tolerance/Zones.h"
#include "accuracy/verdict/Verdict.h"
#include "dip/LaidFilm.h"
#include "search/JobFilms.h"
#include "search/PredictedSheet.h"
#include "search/SearchSubject.h"
#include "settings/SearchSettings.h"
#include "texture/Ink.h"
#include "texture/SurfaceColours.h"

#include <memory>
#include <optional>
#include <span>

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
    // Per sampled place: the place on the flat film that paints it, mm.
    std::vector<Eigen::Vector2f> rests;
    // From `samples`, by JudgedBody::complete(): the print quality of each place, 0 if unpainted,
    // and mm along the surface from each place to the end of the paint, infinite if there is none.
    std::vector<double> qualities;
    std::vector<float> depths;
    double painted = 0;    // share of the sampled places that it paints; by complete(), too
    double trappedAir = 0; // share of the surface that is in trapped air
    double filmUsed = 0;   // share of the film's area that paints
    std::vector<TankFault> tankFaults; // limits of the tank that the dip exceeds
    double cell = 0;                   // the film's smallest cell, mm
    PredictedSheet predicted;          // of the job, by coarser dips
    // Which of these a dip has depends on its resolution (DipDetail).
    double jobCell = 0; // smallest cell of the film with which the job would begin, mm; 0: none
    // On everything but the ink and torn film. If the job would repeat the dip with smaller cells,
    // this is the verdict to be expected then.
    Verdict verdict;
    // Per sampled place: whether it will be too pale; empty: not known.
    std::vector<std::uint8_t> pale;
    // neededDoublings() of the verdict on the job's first dip; none if the numerical error is not
    // known.
    std::optional<double> doublings;
    std::shared_ptr<const JobFilms> films; // null unless the dip has the job's film

    // Whether the job would repeat the dip with smaller cells.
    bool isRepeated() const { return films && films->next; }
};

// The places of a body at which its dips are measured. Immutable; any thread may use it.
class JudgedBody {
public:
    // `zoneWeights` holds the weight of each zone. `appearance`: the colours of the subject's
    // model. Throws Error if the whole body is masked.
    JudgedBody(const SearchSubject& subject, const std::array<double, zoneCount>& zoneWeights,
               const SurfaceColours& appearance);

    std::size_t places() const { return samples_.size(); }
    double equator() const { return equator_; } // mm: circumference of a ball of equal surface
    JudgedSurface surface(const SurfaceMask* mask) const {
        return {zoned_.get(), mask, bodies_.get()};
    }

    // Measures one dip.
    JudgedPose judged(const LaidFilm& laid, const Immersion& immersion) const;
    // Returns JudgedPose::pale: whether the film stretches more at a place than ink can make up
    // for.
    std::vector<std::uint8_t> pale(const LaidFilm& laid) const;
    // Predicts the sheet of the job from two dips in one pose.
    PredictedSheet predicted(const JudgedPose& coarse, const JudgedPose& finer) const;
    // Computes everything that follows from `samples`.
    void complete(JudgedPose& pose) const;
    // Measures one or two dips together, in this order. Each place counts for the dip that paints
    // it better.
    PoseMeasures measures(const std::vector<const JudgedPose*>& dips) const;
    // Judges as the job does what no dip paints: of the whole body if there are two dips, and of
    // each marked zone. `measures`: the result of measures(dips).
    Verdict unpainted(const std::vector<const JudgedPose*>& dips, const PoseMeasures& measures,
                      const VerdictSettings& limits) const;
    // Returns, for each of one or two dips, the share of its painted places that will be too pale.
    // A place counts only for the dip that paints it better. A dip needs JudgedPose::pale.
    std::vector<double> paleShares(const std::vector<const JudgedPose*>& dips) const;

private:
    struct Link {
        std::uint32_t sample = 0;
        float length = 0; // mm
    };

    void linkNeighbours();
    std::span<const Link> linksOf(std::size_t sample) const {
        return std::span(links_).subspan(firstLinks_[sample],
                                         firstLinks_[sample + 1] - firstLinks_[sample]);
    }
    // Returns the number of the dip that paints each place, 1 or 2; 0 if none does.
    std::vector<std::uint8_t> painters(const std::vector<const JudgedPose*>& dips) const;
    std::vector<float> depths(const std::vector<PaintedSample>& samples) const;
    bool isNarrow(std::size_t sample, const std::vector<const JudgedPose*>& dips) const;
    void measureSeam(const std::vector<std::uint8_t>& painters,
                     const std::vector<const JudgedPose*>& dips, PoseMeasures& measures) const;

    std::shared_ptr<const TexturedMesh> model_;
    std::vector<SurfacePoint> samples_;
    std::vector<float> weights_;
    std::shared_ptr<const ZonedBody> zoned_;       // null if no zones are marked
    std::shared_ptr<const SeparateBodies> bodies_; // null: one body
    std::vector<Zone> zones_;                      // per place
    ToleranceSettings tolerance_;
    InkCompensation ink_;
    std::vector<LinearColour> wanted_; // per place: the colour that the body should show
    // From each sample to the samples within linkReach_; the links of a sample follow each other.
    std::vector<Link> links_;
    std::vector<std::size_t> firstLinks_; // per sample, and the number of links
    // Per place: the overlap that it needs with unstretched film, mm.
    std::vector<float> bands_;
    double area_ = 0, openArea_ = 0, linkReach_ = 0, equator_ = 0;
};

} // namespace dipwright
