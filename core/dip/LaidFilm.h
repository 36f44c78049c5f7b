// The film on the body at the end of its dip. Everything after the dip uses it: the reverse
// texture, maps, coverage and the proof. It is made once per dip. The appearance of the body is not
// part of it and is passed separately.
#pragma once

#include "dip/FilmContact.h"
#include "dip/PaintedStretch.h"
#include "dip/Pose.h"
#include "film/DippedFilm.h"
#include "settings/ProcessSettings.h"

#include <memory>
#include <mutex>
#include <optional>

namespace dipwright {

class FilmOnBody;

// A place on the flat film.
struct FilmPlace {
    Eigen::Vector2f rest = Eigen::Vector2f::Zero(); // in restPosition()'s frame, mm
    std::uint32_t triangle = 0;                     // the film triangle that contains it
};

// Immutable; any thread may read. Everything is computed once, mostly in the constructor. Not
// copied: it is passed on as std::shared_ptr<const LaidFilm>.
class LaidFilm {
public:
    // Takes a known contact; layFilm() finds the contact first. `film` is in the body's pose frame.
    LaidFilm(std::shared_ptr<const PosedBody> body, DippedFilm film, FilmContact contact);
    ~LaidFilm();
    LaidFilm(const LaidFilm&) = delete;
    LaidFilm& operator=(const LaidFilm&) = delete;

    const PosedBody& body() const { return *body_; }
    const DippedFilm& film() const { return film_; }
    const FilmContact& contact() const { return contact_; }
    // filmTriangles() of the grid.
    const std::vector<FilmTriangle>& triangles() const { return triangles_; }
    // Principal stretches of each film triangle, painted or not.
    const std::vector<PrincipalStretch>& stretches() const { return stretches_; }
    const PaintedStretch& painted() const { return painted_; }
    // Returns how far the film's area has grown at a place of a film triangle, given by barycentric
    // weights. Continuous: interpolates between the middles of the cells. Ink density uses this.
    float areaStretch(std::uint32_t triangle, const Eigen::Vector3f& weights) const;
    float areaStretch(const FilmPlace& place) const;
    // Prepares areaStretch(), which otherwise does this on first use because only ink needs it.
    void prepareAreas() const;
    // Returns the solver::PointMark bits of a film triangle: the bitwise or of the marks of its
    // corners that are on the body. Paint of marked film is uncertain: it depends on a law that was
    // never measured, or on film that did not converge.
    std::uint8_t marks(std::uint32_t triangle) const;

    // Returns the place on the flat film that paints `point` of the body; nothing if no film does.
    std::optional<FilmPlace> place(const SurfacePoint& point) const;
    // Returns the place of the flat film at `rest`, whether on the body or not; nothing outside the
    // film.
    std::optional<FilmPlace> flat(const Eigen::Vector2f& rest) const;
    // Returns the barycentric weights of a place in its film triangle, in the order of the corners.
    Eigen::Vector3f weights(const FilmPlace& place) const;
    // Returns the point of the body that a place of the film lies on, in the pose frame, mm;
    // nothing if the place is not on the body.
    std::optional<Eigen::Vector3f> onBody(const FilmPlace& place) const;

private:
    std::shared_ptr<const PosedBody> body_;
    DippedFilm film_;
    FilmContact contact_;
    std::vector<FilmTriangle> triangles_;
    std::vector<PrincipalStretch> stretches_;
    PaintedStretch painted_;
    mutable std::once_flag hasCellAreas_;
    mutable std::vector<float> cellAreas_; // paintedCellAreas()
    std::unique_ptr<const FilmOnBody> onBody_;
};

// Locates the film on the body after a dip with `process`. Uses all cores; deterministic.
std::shared_ptr<const LaidFilm> layFilm(std::shared_ptr<const PosedBody> body, DippedFilm film,
                                        const ProcessSettings& process);

// Whether the film's edge ended up on the body. The film was then too small, and it may overlap
// itself near the edge.
bool edgeIsOnBody(const LaidFilm& laid);

// Returns the bounding box of the flat film that paints, in restPosition()'s frame, mm; empty if no
// film paints.
Eigen::AlignedBox2f usedFilm(const LaidFilm& laid);
// Returns the area of usedFilm() as a share of the film's area, 0 … 1.
double usedShare(const LaidFilm& laid);

} // namespace dipwright
