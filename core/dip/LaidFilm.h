// A film at the end of its dip as it lies on the body: the one value that everything after the dip
// asks, be it the reverse texture, a map, the coverage or the proof. Made once a dip: what the body
// looks like is no part of it and is passed beside it.
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

// A place of the flat film.
struct FilmPlace {
    Eigen::Vector2f rest = Eigen::Vector2f::Zero(); // in restPosition()'s frame, mm
    std::uint32_t triangle = 0;                     // the film triangle it is in
};

// Immutable, everything in it computed once, most of it when it is made: any thread may read.
// Shared, not copied: it is handed on as std::shared_ptr<const LaidFilm>.
class LaidFilm {
public:
    // Of a contact that is known; layFilm() finds it. `film` is in the body's pose frame.
    LaidFilm(std::shared_ptr<const PosedBody> body, DippedFilm film, FilmContact contact);
    ~LaidFilm();
    LaidFilm(const LaidFilm&) = delete;
    LaidFilm& operator=(const LaidFilm&) = delete;

    const PosedBody& body() const { return *body_; }
    const DippedFilm& film() const { return film_; }
    const FilmContact& contact() const { return contact_; }
    // filmTriangles() of the grid.
    const std::vector<FilmTriangle>& triangles() const { return triangles_; }
    // A film triangle each, painted or not.
    const std::vector<PrincipalStretch>& stretches() const { return stretches_; }
    const PaintedStretch& painted() const { return painted_; }
    // paintedPointAreas(), computed when it is first asked for: only ink asks.
    const std::vector<float>& pointAreas() const;
    // The solver::PointMark bits of a film triangle: those of its corners that are on the body,
    // together. What it paints depends on a law without measurement behind it, or on film that
    // found no rest.
    std::uint8_t marks(std::uint32_t triangle) const;

    // The place on the flat film of the film that covers `point` of the body; nothing where none
    // does.
    std::optional<FilmPlace> place(const SurfacePoint& point) const;
    // The place of the flat film at `rest`, on the body or not; nothing beside the film.
    std::optional<FilmPlace> flat(const Eigen::Vector2f& rest) const;
    // A place's barycentric weights in its film triangle, in the order of the corners.
    Eigen::Vector3f weights(const FilmPlace& place) const;
    // Where the nearest of the body to a place lies, in the pose frame; nothing where it is not on
    // the body.
    std::optional<Eigen::Vector3f> onBody(const FilmPlace& place) const;

private:
    std::shared_ptr<const PosedBody> body_;
    DippedFilm film_;
    FilmContact contact_;
    std::vector<FilmTriangle> triangles_;
    std::vector<PrincipalStretch> stretches_;
    PaintedStretch painted_;
    mutable std::once_flag hasPointAreas_;
    mutable std::vector<float> pointAreas_;
    std::unique_ptr<const FilmOnBody> onBody_;
};

// The film as a dip with `process` has left it, located on the body. All cores, deterministic.
std::shared_ptr<const LaidFilm> layFilm(std::shared_ptr<const PosedBody> body, DippedFilm film,
                                        const ProcessSettings& process);

// Whether the film's edge has ended up on the body: it was too small for it, and where the edge
// lies the film may lie over itself.
bool edgeIsOnBody(const LaidFilm& laid);

// The box round the flat film that paints, in restPosition()'s frame, mm; empty where none does.
// And its area over that of the film, 0 … 1.
Eigen::AlignedBox2f usedFilm(const LaidFilm& laid);
double usedShare(const LaidFilm& laid);

} // namespace dipwright
