#include "texture/AreaStretch.h"

namespace dipwright {

namespace {

// Past the limit of contact film would be stretched as it is before it.
void continueToLimit(std::vector<float>& stretches, const std::vector<int>& count,
                     const std::vector<FilmTriangle>& triangles, const FilmContact& contact) {
    for (const auto& [triangle, limit] : contact.limits) {
        float sum = 0;
        int known = 0;
        for (const std::uint32_t point : triangles[triangle]) {
            sum += count[point] ? stretches[point] : 0;
            known += count[point] ? 1 : 0;
        }
        for (const std::uint32_t point : triangles[triangle]) {
            stretches[point] = count[point] || known == 0 ? stretches[point] : sum / float(known);
        }
    }
}

} // namespace

std::vector<float> pointAreaStretches(const DippedFilm& film, const FilmContact& contact) {
    const std::vector<PrincipalStretch> stretches = principalStretches(film);
    const std::vector<FilmTriangle> triangles = filmTriangles(film.grid);
    std::vector<float> sum(film.positions.size(), 0);
    std::vector<int> count(film.positions.size(), 0);
    for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle) {
        if (contact.painted[triangle]) {
            for (const std::uint32_t point : triangles[triangle]) {
                sum[point] += stretches[triangle].area();
                ++count[point];
            }
        }
    }
    for (std::size_t point = 0; point < sum.size(); ++point) {
        sum[point] = count[point] ? sum[point] / float(count[point]) : 1;
    }
    continueToLimit(sum, count, triangles, contact);
    return sum;
}

} // namespace dipwright
