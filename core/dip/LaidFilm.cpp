#include "dip/LaidFilm.h"

#include "dip/FilmOnBody.h"
#include "dip/FilmThatPaints.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace dipwright {

LaidFilm::LaidFilm(std::shared_ptr<const PosedBody> body, DippedFilm film, FilmContact contact)
    : body_(std::move(body)), film_(std::move(film)), contact_(std::move(contact)),
      triangles_(filmTriangles(film_.grid)), stretches_(principalStretches(film_)),
      painted_(paintedStretch(film_, triangles_, stretches_, contact_)),
      onBody_(std::make_unique<FilmOnBody>(film_.grid, triangles_, contact_, body_->mesh)) {}

LaidFilm::~LaidFilm() = default;

void LaidFilm::prepareAreas() const {
    std::call_once(hasCellAreas_, [this] {
        cellAreas_ = paintedCellAreas(film_, triangles_, stretches_, contact_);
    });
}

float LaidFilm::areaStretch(std::uint32_t triangle, const Eigen::Vector3f& weights) const {
    prepareAreas();
    const int columns = film_.grid.columns - 1, rows = film_.grid.rows - 1; // of cells
    float x = -0.5F, y = -0.5F; // in cells, from the middle of the first
    for (int k = 0; k < 3; ++k) {
        const int point = int(triangles_[triangle][std::size_t(k)]);
        x += weights[k] * float(point % film_.grid.columns);
        y += weights[k] * float(point / film_.grid.columns);
    }
    const int left = int(std::floor(x)), top = int(std::floor(y));
    const float right = x - float(left), down = y - float(top);
    const auto cell = [&](int column, int row) {
        return cellAreas_[std::size_t(std::clamp(row, 0, rows - 1)) * std::size_t(columns) +
                          std::size_t(std::clamp(column, 0, columns - 1))];
    };
    return (1 - down) * ((1 - right) * cell(left, top) + right * cell(left + 1, top)) +
           down * ((1 - right) * cell(left, top + 1) + right * cell(left + 1, top + 1));
}

std::uint8_t LaidFilm::marks(std::uint32_t triangle) const {
    std::uint8_t marks = 0;
    if (!film_.marks.empty()) {
        for (const std::uint32_t point : triangles_[triangle]) {
            marks |= contact_.surface[point].isValid() ? film_.marks[point] : std::uint8_t(0);
        }
    }
    return marks;
}

float LaidFilm::areaStretch(const FilmPlace& place) const {
    return areaStretch(place.triangle, weights(place));
}

std::optional<FilmPlace> LaidFilm::place(const SurfacePoint& point) const {
    return onBody_->place(point);
}

Eigen::Vector3f LaidFilm::weights(const FilmPlace& place) const {
    const FilmTriangle& corners = triangles_[place.triangle];
    const Eigen::Vector2f a = restPosition(film_.grid, corners[0]);
    Eigen::Matrix2f edges;
    edges << restPosition(film_.grid, corners[1]) - a, restPosition(film_.grid, corners[2]) - a;
    const Eigen::Vector2f along = edges.inverse() * (place.rest - a);
    return {1 - along.sum(), along[0], along[1]};
}

std::optional<FilmPlace> LaidFilm::flat(const Eigen::Vector2f& rest) const {
    const solver::FilmGrid& grid = film_.grid;
    const double column = columnAt(grid, double(rest.x()) / grid.width + 0.5);
    const double row = rowAt(grid, double(rest.y()) / grid.depth + 0.5);
    if (!(column >= 0 && row >= 0 && column <= grid.columns - 1 && row <= grid.rows - 1)) {
        return std::nullopt;
    }
    return FilmPlace{rest, std::uint32_t(triangleAt(grid, column, row))};
}

std::optional<Eigen::Vector3f> LaidFilm::onBody(const FilmPlace& place) const {
    const Eigen::Vector3f weights = this->weights(place);
    if (!contact_.reaches(place.triangle, weights)) {
        return std::nullopt;
    }
    Eigen::Vector3f lies = Eigen::Vector3f::Zero();
    for (int corner = 0; corner < 3; ++corner) {
        lies += weights[corner] * contact_.places[triangles_[place.triangle][std::size_t(corner)]];
    }
    return position(body_->mesh, body_->query.closest(lies).point);
}

std::shared_ptr<const LaidFilm> layFilm(std::shared_ptr<const PosedBody> body, DippedFilm film,
                                        const ProcessSettings& process) {
    FilmContact contact = findFilmContact(film, *body, process);
    return std::make_shared<const LaidFilm>(std::move(body), std::move(film), std::move(contact));
}

bool edgeIsOnBody(const LaidFilm& laid) {
    const int columns = laid.film().grid.columns, rows = laid.film().grid.rows;
    for (int point = 0; point < columns * rows; ++point) {
        const int column = point % columns, row = point / columns;
        const bool isOnEdge = column == 0 || row == 0 || column == columns - 1 || row == rows - 1;
        if (isOnEdge && laid.contact().surface[std::size_t(point)].isValid()) {
            return true;
        }
    }
    return false;
}

Eigen::AlignedBox2f usedFilm(const LaidFilm& laid) {
    const DippedFilm& film = laid.film();
    Eigen::AlignedBox2f box;
    for (std::size_t point = 0; point < film.positions.size(); ++point) {
        if (laid.painted().points[point] != 0) {
            box.extend(restPosition(film.grid, point));
        }
    }
    return box;
}

double usedShare(const LaidFilm& laid) {
    const solver::FilmGrid& grid = laid.film().grid;
    const Eigen::AlignedBox2f box = usedFilm(laid);
    return box.isEmpty() ? 0 : double(box.volume()) / (grid.width * grid.depth);
}

} // namespace dipwright
