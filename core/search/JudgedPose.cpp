#include "search/JudgedPose.h"

#include "accuracy/verdict/BareZones.h"
#include "base/Error.h"
#include "dip/TrappedAir.h"
#include "geometry/BuriedSurface.h"
#include "geometry/SurfaceSamples.h"
#include "search/Objective.h"
#include "search/PlaceWeights.h"
#include "share/FadeOverlap.h"
#include "texture/PalePlaces.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <queue>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(PoseSearch)
};

constexpr double samplesOfBody = 6000;
constexpr double stretchUnits = 4096;
static_assert(largestStretch * stretchUnits <= 65535);
constexpr double stretchPercentile = 0.99; // percentile that is reported as the largest stretch
constexpr double gatheredBelow = 0.9;      // λ2 below which compressed film may fold
constexpr double markedWorth = 0.5;        // worth of marked film relative to unmarked film
constexpr double linkedSamples = 2; // samples within this many sample spacings are neighbours

std::uint16_t units(float stretch) {
    return std::uint16_t(std::clamp(std::lround(double(stretch) * stretchUnits), 1L, 65535L));
}

bool isMarked(const PaintedSample& sample, solver::PointMark mark) {
    return solver::has(sample.marks, mark);
}

// Returns how well the film paints a painted place. If two dips paint it, the larger value wins.
double worthOf(const JudgedPose& pose, std::size_t place) {
    const double quality = pose.qualities[place];
    return pose.samples[place].marks != 0 ? markedWorth * quality : quality;
}

double percentile(std::vector<std::uint16_t>& values, double share) {
    if (values.empty()) {
        return 1;
    }
    const auto nth = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
    std::nth_element(values.begin(), nth, values.end());
    return *nth / stretchUnits;
}

} // namespace

JudgedBody::JudgedBody(const SearchSubject& subject,
                       const std::array<double, zoneCount>& zoneWeights,
                       const SurfaceColours& appearance)
    : model_(subject.model), zoned_(markedZones(subject.model, subject.tolerance.marks)),
      bodies_(separateBodies(*subject.model)), tolerance_(subject.tolerance), ink_(subject.ink),
      area_(surfaceArea(model_->mesh)), openArea_(area_) {
    const std::vector<SurfacePoint> all = evenSamples(model_->mesh, area_ / samplesOfBody);
    linkReach_ = linkedSamples * std::sqrt(area_ / samplesOfBody);
    const std::vector<std::uint8_t> buried = buriedPlaces(model_->mesh, all);
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (buried[k] == 0) {
            samples_.push_back(all[k]);
        }
    }
    area_ *= double(samples_.size()) / double(all.size()); // times 1 if nothing is buried
    openArea_ = area_;
    if (subject.mask) {
        const auto unburied = double(samples_.size());
        std::erase_if(samples_, [&](const auto& place) { return subject.mask->covers(place); });
        if (samples_.empty()) {
            throw Error(
                Text::tr("The whole part is masked; unmask the surface to be printed before "
                         "you search for a pose"),
                subject.name);
        }
        openArea_ = area_ * double(samples_.size()) / unburied;
    }
    equator_ = std::sqrt(pi * area_);
    const std::vector<LinearColour> colours = appearance.at(samples_);
    weights_ = placeWeights(subject, zoneWeights, samples_, colours);
    for (const SurfacePoint& place : samples_) {
        zones_.push_back(zoned_ ? zoned_->at(place) : Zone::C);
    }
    linkNeighbours();
    for (const LinearColour& colour : colours) {
        bands_.push_back(float(neededOverlap(colour, subject.registrationError.value(), 0)));
        wanted_.push_back(ink_.toned(colour));
    }
}

void JudgedBody::linkNeighbours() {
    std::vector<std::vector<Link>> links(samples_.size());
    std::map<std::array<int, 3>, std::vector<std::uint32_t>> cells;
    std::vector<Eigen::Vector3f> places, normals;
    const auto cellOf = [&](const Eigen::Vector3f& place) {
        std::array<int, 3> cell{};
        for (int axis = 0; axis < 3; ++axis) {
            cell[std::size_t(axis)] = int(std::floor(double(place[axis]) / linkReach_));
        }
        return cell;
    };
    for (std::uint32_t index = 0; index < samples_.size(); ++index) {
        places.push_back(position(model_->mesh, samples_[index]));
        normals.push_back(triangleNormal(model_->mesh, samples_[index].triangle));
        const std::array<int, 3> cell = cellOf(places.back());
        for (int near = 0; near < 27; ++near) {
            const auto found = cells.find(
                {cell[0] + near % 3 - 1, cell[1] + near / 3 % 3 - 1, cell[2] + near / 9 - 1});
            if (found == cells.end()) {
                continue;
            }
            for (const std::uint32_t other : found->second) {
                const float length = (places[other] - places[index]).norm();
                if (double(length) <= linkReach_ &&
                    normals[other].dot(normals[index]) > 0) { // not across a thin wall
                    links[index].push_back({other, length});
                    links[other].push_back({index, length});
                }
            }
        }
        cells[cell].push_back(index);
    }
    for (const std::vector<Link>& each : links) {
        firstLinks_.push_back(links_.size());
        links_.insert(links_.end(), each.begin(), each.end());
    }
    firstLinks_.push_back(links_.size());
}

void JudgedBody::complete(JudgedPose& pose) const {
    pose.qualities.clear();
    pose.painted = 0;
    for (const PaintedSample& sample : pose.samples) {
        pose.painted += sample.larger == 0 ? 0 : 1 / double(pose.samples.size());
        pose.qualities.push_back(sample.larger == 0 ? 0
                                                    : printQuality(sample.larger / stretchUnits,
                                                                   sample.smaller / stretchUnits));
    }
    pose.depths = depths(pose.samples);
}

// Uses Dijkstra's algorithm along the links. Paint ends halfway between a painted and a bare place.
std::vector<float> JudgedBody::depths(const std::vector<PaintedSample>& samples) const {
    std::vector<float> depths(samples.size(), std::numeric_limits<float>::infinity());
    using Entry = std::pair<float, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    const auto arrive = [&](std::uint32_t sample, float depth) {
        if (depth < depths[sample]) {
            depths[sample] = depth;
            front.emplace(depth, sample);
        }
    };
    for (std::size_t sample = 0; sample < samples.size(); ++sample) {
        if (samples[sample].larger == 0) {
            depths[sample] = 0;
            for (const Link& link : linksOf(sample)) {
                if (samples[link.sample].larger != 0) {
                    arrive(link.sample, link.length / 2);
                }
            }
        }
    }
    while (!front.empty()) {
        const auto [depth, sample] = front.top();
        front.pop();
        if (depth > depths[sample]) {
            continue;
        }
        for (const Link& link : linksOf(sample)) {
            arrive(link.sample, depth + link.length);
        }
    }
    return depths;
}

// Whether the dips overlap too little at the seam to hide a placement error of the second film.
bool JudgedBody::isNarrow(std::size_t sample, const std::vector<const JudgedPose*>& dips) const {
    const PaintedSample& last = dips.back()->samples[sample];
    const double stretch = std::sqrt(double(last.larger) * last.smaller) / stretchUnits;
    return double(dips[0]->depths[sample] + dips[1]->depths[sample]) <
           double(bands_[sample]) * std::max(stretch, 1.0);
}

// With n places per mm², each linked to all places within r, a line crosses 2/3·n²·r³ links per mm
// (Cauchy and Crofton; docs/pose-search.md, "The seam").
void JudgedBody::measureSeam(const std::vector<std::uint8_t>& painters,
                             const std::vector<const JudgedPose*>& dips,
                             PoseMeasures& measures) const {
    std::size_t crossings = 0, narrow = 0;
    for (std::size_t sample = 0; sample < samples_.size(); ++sample) {
        if (painters[sample] != 1) {
            continue;
        }
        for (const Link& link : linksOf(sample)) {
            if (painters[link.sample] == 2) {
                ++crossings;
                narrow += isNarrow(sample, dips) || isNarrow(link.sample, dips);
            }
        }
    }
    const double density = double(samples_.size()) / openArea_;
    measures[Measure::Join] =
        double(crossings) / (2.0 / 3 * density * density * std::pow(linkReach_, 3));
    measures[Measure::Narrow] = double(narrow) / double(std::max<std::size_t>(crossings, 1));
}

JudgedPose JudgedBody::judged(const LaidFilm& laid, const Immersion& immersion) const {
    JudgedPose pose;
    pose.immersion = immersion;
    pose.samples.resize(samples_.size());
    pose.rests.resize(samples_.size(), Eigen::Vector2f::Zero());
    for (std::size_t index = 0; index < samples_.size(); ++index) {
        if (const std::optional<FilmPlace> place = laid.place(samples_[index])) {
            const PrincipalStretch& stretch = laid.stretches()[place->triangle];
            pose.samples[index] = {units(stretch.larger), units(stretch.smaller),
                                   laid.marks(place->triangle)};
            pose.rests[index] = place->rest;
        }
    }
    complete(pose);
    pose.trappedAir = trappedAir(laid.body()).area / area_;
    pose.filmUsed = usedShare(laid);
    pose.cell = laid.film().grid.leastSpacing();
    return pose;
}

std::vector<std::uint8_t> JudgedBody::pale(const LaidFilm& laid) const {
    return palePlaces(laid, samples_, wanted_, ink_);
}

PredictedSheet JudgedBody::predicted(const JudgedPose& coarse, const JudgedPose& finer) const {
    if (finer.samples.empty()) { // the dip failed, as the job's is likely to
        return {Advice::DoNotPrint, 0};
    }
    std::vector<PlaceMove> moves;
    for (std::size_t place = 0; place < coarse.samples.size(); ++place) {
        const bool isBefore = coarse.samples[place].larger != 0;
        const bool isAfter = finer.samples[place].larger != 0;
        if (isBefore && isAfter) {
            moves.push_back({(finer.rests[place] - coarse.rests[place]).norm(), zones_[place]});
        }
    }
    return {std::max(finer.verdict.advice, Advice::Print),
            predictedDoublings(moves, {coarse.cell, finer.cell, finer.jobCell}, tolerance_)};
}

std::vector<std::uint8_t> JudgedBody::painters(const std::vector<const JudgedPose*>& dips) const {
    std::vector<std::uint8_t> painters(samples_.size(), 0);
    for (std::size_t index = 0; index < samples_.size(); ++index) {
        double worth = -1;
        for (std::size_t dip = 0; dip < dips.size(); ++dip) {
            const JudgedPose& pose = *dips[dip];
            const bool isPainted = !pose.samples.empty() && pose.samples[index].larger != 0;
            const double own = isPainted ? worthOf(pose, index) : -1;
            if (own > worth) {
                worth = own;
                painters[index] = std::uint8_t(dip + 1);
            }
        }
    }
    return painters;
}

Verdict JudgedBody::unpainted(const std::vector<const JudgedPose*>& dips,
                              const PoseMeasures& measures, const VerdictSettings& limits) const {
    ReasonList reasons;
    if (dips.size() > 1) {
        reasons.addShare(VerdictReason::Kind::Unreached, 1 - measures[Measure::Coverage],
                         limits.unreached);
    }
    if (!zoned_ && !bodies_) {
        return std::move(reasons).verdict();
    }
    const std::vector<std::uint8_t> painted = painters(dips);
    if (zoned_) {
        addBareZoneReasons(reasons, zones_, painted, limits.zoneBare);
    }
    if (bodies_) {
        addBareBodyReasons(reasons, *bodies_, samples_, painted, limits.leastPainted);
    }
    return std::move(reasons).verdict();
}

std::vector<double> JudgedBody::paleShares(const std::vector<const JudgedPose*>& dips) const {
    const std::vector<std::uint8_t> painters = this->painters(dips);
    std::vector<double> shares;
    for (std::size_t dip = 0; dip < dips.size(); ++dip) {
        std::size_t painted = 0, pale = 0;
        for (std::size_t index = 0; index < dips[dip]->pale.size(); ++index) {
            painted += dips[dip]->samples[index].larger != 0;
            pale += painters[index] == dip + 1 && dips[dip]->pale[index] != 0;
        }
        shares.push_back(double(pale) / double(std::max<std::size_t>(painted, 1)));
    }
    return shares;
}

PoseMeasures JudgedBody::measures(const std::vector<const JudgedPose*>& dips) const {
    const std::vector<std::uint8_t> painters = this->painters(dips);
    std::vector<std::uint16_t> stretches;
    stretches.reserve(samples_.size());
    double quality = 0, weights = 0;
    std::size_t certain = 0, wrinkled = 0, torn = 0;
    for (std::size_t index = 0; index < samples_.size(); ++index) {
        weights += double(weights_[index]);
        if (painters[index] != 0) {
            const JudgedPose& best = *dips[painters[index] - 1u];
            const PaintedSample& sample = best.samples[index];
            quality += double(weights_[index]) * best.qualities[index];
            stretches.push_back(sample.larger);
            certain += sample.marks == 0;
            wrinkled += sample.smaller < gatheredBelow * stretchUnits;
            torn += isMarked(sample, solver::PointMark::Torn);
        }
    }
    const auto painted = double(std::max<std::size_t>(stretches.size(), 1));
    PoseMeasures measures;
    measures[Measure::Quality] = quality / std::max(weights, 1e-12);
    measures[Measure::Coverage] =
        double(stretches.size()) / double(std::max<std::size_t>(samples_.size(), 1));
    measures[Measure::Certain] = double(certain) / painted;
    measures[Measure::Wrinkled] = double(wrinkled) / painted;
    measures[Measure::Torn] = double(torn) / painted;
    measures[Measure::Stretch] = percentile(stretches, stretchPercentile);
    for (const JudgedPose* dip : dips) {
        measures[Measure::TrappedAir] += dip->trappedAir;
        measures[Measure::FilmUsed] += dip->filmUsed / double(dips.size());
    }
    measures[Measure::TrappedAir] = std::min(measures[Measure::TrappedAir], 1.0);
    if (dips.size() == 2) {
        measureSeam(painters, dips, measures);
    }
    return measures;
}

} // namespace dipwright
