// Gives the values of one dipped film at any place: for the 3D view, the stretch map and the sheet.
// Built on the worker thread, then constant.
#pragma once

#include "workbench/dip/DrapedFilm.h"

#include <optional>

namespace dipwright {

// Stretch of the dipped film relative to the floating film. Length is the mean over a point's
// constraints.
enum class FilmQuantity { Length, Area, Larger, Smaller };
inline constexpr std::size_t filmQuantityCount = 4;

struct FilmReadoutPoint {
    // Place on the floating film, see restPosition().
    Eigen::Vector2f rest = Eigen::Vector2f::Zero();
    Eigen::Vector3f place = Eigen::Vector3f::Zero(); // pose frame, mm
    std::array<float, filmQuantityCount> values{};
    PrincipalStretch stretch; // of the triangle at this place
    bool onPart = false;      // the triangle paints the part, or all its corners adhere to it
    SurfacePoint body;        // invalid where the film does not lie on the body
    // Normal of the body at this place, pose frame.
    Eigen::Vector3f outward = Eigen::Vector3f::Zero();
};

class FilmReadout {
public:
    explicit FilmReadout(std::shared_ptr<const LaidFilm> laid);

    const DippedFilm& film() const { return laid_->film(); }
    // The film as it is drawn.
    const DrapedFilm& draped() const { return draped_; }
    // One value for each film point.
    const std::vector<float>& values(FilmQuantity quantity) const {
        return values_[std::size_t(quantity)];
    }
    // Values of the points that paint the body; values of all points if no point paints it.
    const std::vector<float>& paintedValues(FilmQuantity quantity) const {
        return painted_[std::size_t(quantity)];
    }
    // The report's figures for the film that paints. Counts each constraint or triangle once.
    const Distribution& spread(FilmQuantity quantity) const {
        return spreads_[std::size_t(quantity)];
    }
    // Reads the film at a place on the flat film, mm; nullopt outside the film.
    std::optional<FilmReadoutPoint> at(const Eigen::Vector2f& rest) const;
    // Reads the film where a ray in the pose frame first meets it; nullopt if the ray misses the
    // film.
    std::optional<FilmReadoutPoint> at(const Eigen::Vector3f& origin,
                                       const Eigen::Vector3f& direction) const;

private:
    FilmReadoutPoint at(const SurfacePoint& onFilm) const;

    std::shared_ptr<const LaidFilm> laid_;
    TriangleMesh mesh_; // the dipped film
    DrapedFilm draped_;
    std::unique_ptr<SurfaceQuery> query_;
    std::array<std::vector<float>, filmQuantityCount> values_, painted_;
    std::array<Distribution, filmQuantityCount> spreads_;
};

} // namespace dipwright
