// Where film lands on the body: from a place on the body back to the flat film.
#pragma once

#include "dip/FilmContact.h"

namespace dipwright {

// A hierarchy over the painted, deformed film. Keeps references to its
// arguments.
class FilmOnBody {
public:
    FilmOnBody(const DippedFilm& film, const FilmContact& contact, const PosedBody& body);
    ~FilmOnBody();
    FilmOnBody(FilmOnBody&&) noexcept;
    FilmOnBody& operator=(FilmOnBody&&) noexcept;

    // The place on the flat film (restPosition's frame) of the film that covers `point` of the
    // body; false where none does. `triangle` gets the film triangle. Any thread.
    bool locate(const SurfacePoint& point, Eigen::Vector2f& rest, std::uint32_t& triangle) const;

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

} // namespace dipwright
