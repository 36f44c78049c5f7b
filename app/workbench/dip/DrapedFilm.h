// The film of a finished dip as it is drawn. The film's triangles are flat and would cut through a
// curved body. Where they lie on the body, they are therefore divided until they follow its
// surface, and are lifted slightly above it.
#pragma once

#include "dip/LaidFilm.h"

namespace dipwright {

struct DrapedFilm {
    // The film's points, then the points that divide its sides; pose frame, mm.
    std::vector<Eigen::Vector3f> positions;
    // For each point after the film's points: the two earlier points that it lies between.
    std::vector<std::array<std::uint32_t, 2>> between;
    std::vector<FilmTriangle> triangles;
    std::vector<std::uint8_t> painted; // per triangle: 1 if it is on the body

    // Appends values for the points that divide the sides to one value for each film point.
    template <typename Value>
    std::vector<Value> onAllPoints(std::vector<Value> values) const {
        values.reserve(positions.size());
        for (const auto& [a, b] : between) {
            values.push_back((values[a] + values[b]) / 2);
        }
        return values;
    }
};

// Uses all cores; deterministic.
DrapedFilm drapedFilm(const LaidFilm& laid);

} // namespace dipwright
