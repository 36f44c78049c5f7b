#include "texture/PalePlaces.h"

#include "parallel/ParallelFor.h"

namespace dipwright {

std::vector<std::uint8_t> palePlaces(const LaidFilm& laid, const std::vector<SurfacePoint>& places,
                                     const std::vector<LinearColour>& wanted,
                                     const InkCompensation& ink) {
    laid.prepareAreas(); // before several threads need them
    std::vector<std::uint8_t> pale(places.size(), 0);
    parallelFor(std::size_t(0), places.size(), [&](std::size_t index) {
        if (const std::optional<FilmPlace> place = laid.place(places[index])) {
            pale[index] = ink.print(wanted[index], laid.areaStretch(*place)).fallsShort;
        }
    });
    return pale;
}

} // namespace dipwright
