#include "texture/AreaStretch.h"

namespace dipwright {

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
    return sum;
}

} // namespace dipwright
