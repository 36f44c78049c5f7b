// What can be read off one dipped film, point by point: made once on the worker thread, asked under
// the cursor by the view, the stretch map and the sheet.
#pragma once

#include "dip/LaidFilm.h"

#include <optional>

namespace dipwright {

// Ratios of dipped to floating film. Length: mean of a point's constraints.
enum class FilmQuantity { Length, Area, Larger, Smaller };
inline constexpr std::size_t filmQuantityCount = 4;

struct FilmReadoutPoint {
    Eigen::Vector2f rest = Eigen::Vector2f::Zero();  // on the floating film, see restPosition()
    Eigen::Vector3f place = Eigen::Vector3f::Zero(); // pose frame, mm
    std::array<float, filmQuantityCount> values{};
    PrincipalStretch stretch; // of the triangle there: these agree with each other
    bool adhered = false;
    SurfacePoint body;                                 // invalid where the film is not on it
    Eigen::Vector3f outward = Eigen::Vector3f::Zero(); // of the body's surface there, pose frame
};

class FilmReadout {
public:
    explicit FilmReadout(std::shared_ptr<const LaidFilm> laid);

    const DippedFilm& film() const { return laid_->film(); }
    // One value a film point.
    const std::vector<float>& values(FilmQuantity quantity) const {
        return values_[std::size_t(quantity)];
    }
    // Of the points that paint the body only; of all where none does.
    const std::vector<float>& paintedValues(FilmQuantity quantity) const {
        return painted_[std::size_t(quantity)];
    }
    // The report's figures: of what paints the body, each constraint or triangle counted once.
    const Distribution& spread(FilmQuantity quantity) const {
        return spreads_[std::size_t(quantity)];
    }
    // The film at a place of the flat film; nothing outside it.
    std::optional<FilmReadoutPoint> at(const Eigen::Vector2f& rest) const;
    // The film first met by a ray in the pose frame.
    std::optional<FilmReadoutPoint> at(const Eigen::Vector3f& origin,
                                       const Eigen::Vector3f& direction) const;

private:
    FilmReadoutPoint at(const SurfacePoint& onFilm) const;

    std::shared_ptr<const LaidFilm> laid_;
    TriangleMesh mesh_; // the dipped film
    std::unique_ptr<SurfaceQuery> query_;
    std::array<std::vector<float>, filmQuantityCount> values_, painted_;
    std::array<Distribution, filmQuantityCount> spreads_;
};

} // namespace dipwright
