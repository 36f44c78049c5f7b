#include "dip/ContactLimit.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dipwright {

namespace {

// In cells. Film that bridges two places on the body counts as held if it is at most this far from
// the body.
constexpr float largestGap = 0.1f;
constexpr int stepsOfACell = 8;
// The limit crosses a triangle's side at least this far from the side's ends, as a share of the
// side's length. Thus the linear function limit() exists for every triangle.
constexpr float leastShare = 1e-3f;
// The solver's contact may stop short of the limit by at most this many cells.
constexpr int rings = 2;
constexpr int triedPlaces = 8;
constexpr int halvings = 10;

class LimitFinder {
public:
    LimitFinder(const DippedFilm& film, const PosedBody& body, const CornerNormals& normals,
                const ProcessSettings& process, FilmContact& contact)
        : film_(film), body_(body), mesh_(body.mesh), normals_(normals), query_(body.query),
          contact_(contact), triangles_(filmTriangles(film.grid)),
          steepest_(float(std::sin(radians(process.overhang)))), mostStretch_(process.tearStretch),
          state_(film.positions.size(), Reach::None) {}

    void find() {
        for (std::size_t triangle = 0; triangle < triangles_.size(); ++triangle) {
            for (const std::uint32_t point : triangles_[triangle]) {
                if (contact_.painted[triangle]) {
                    state_[point] = Reach::Held;
                }
            }
        }
        for (int ring = 0; ring < rings; ++ring) {
            continueByACell();
        }
        for (std::uint32_t triangle = 0; triangle < triangles_.size(); ++triangle) {
            const FilmTriangle& corners = triangles_[triangle];
            const bool isNew = std::any_of(corners.begin(), corners.end(), [&](auto point) {
                return !contact_.surface[point].isValid();
            });
            if (isNew && !contact_.painted[triangle] && isContinued(corners)) {
                contact_.limits.emplace(triangle, limit(corners));
            }
        }
    }

private:
    // State of a film point.
    enum class Reach : std::uint8_t {
        None, // unknown, or floating
        Held, // on the body, or would be if the film continued
        Past, // would be past the limit if the film continued
    };

    void continueByACell() {
        std::vector<std::pair<std::uint32_t, Eigen::Vector3f>> continued;
        for (std::uint32_t point = 0; point < state_.size(); ++point) {
            if (const auto place = continuedPlace(point)) {
                continued.emplace_back(point, *place);
            }
        }
        for (const auto& [point, place] : continued) {
            contact_.places[point] = place;
            const bool held = isHeld(place, point);
            state_[point] = held ? Reach::Held : Reach::Past;
        }
    }

    // Returns where a floating film point would lie if the film continued past its last two points
    // on the body. If several grid directions lead to the point, returns the mean of their results.
    // Returns nothing if no direction does, or if the point floats near that place without touching
    // the body.
    std::optional<Eigen::Vector3f> continuedPlace(std::uint32_t point) const {
        if (film_.states[point] != solver::PointState::Free || state_[point] != Reach::None ||
            contact_.surface[point].isValid()) {
            return std::nullopt;
        }
        const int columns = film_.grid.columns;
        const int column = int(point) % columns;
        const int row = int(point) / columns;
        const auto lies = [&](int c, int r) {
            return c >= 0 && r >= 0 && c < columns && r < film_.grid.rows &&
                   state_[std::size_t(r * columns + c)] == Reach::Held;
        };
        Eigen::Vector3f sum = Eigen::Vector3f::Zero();
        float way = 0;
        int count = 0;
        for (int down = -1; down <= 1; ++down) {
            for (int right = -1; right <= 1; ++right) {
                if (lies(column + right, row + down) && lies(column + 2 * right, row + 2 * down)) {
                    const int last = (row + down) * columns + column + right;
                    const Eigen::Vector3f& near = contact_.places[std::size_t(last)];
                    const Eigen::Vector3f& before =
                        contact_.places[std::size_t(last + down * columns + right)];
                    sum += continued(before, near);
                    way += (near - before).norm();
                    ++count;
                }
            }
        }
        if (count == 0) {
            return std::nullopt;
        }
        const Eigen::Vector3f place = sum / float(count);
        const Eigen::Vector3f& floats = film_.positions[point];
        const bool hangs = place.y() > floats.y() || (floats - place).norm() > way / float(count);
        return hangs ? std::optional(place) : std::nullopt;
    }

    // Returns the place one step past `near` along the body. The step is as long as the distance
    // from `before` to `near`. Where the body ends, the rest of the step goes straight on.
    Eigen::Vector3f continued(const Eigen::Vector3f& before, const Eigen::Vector3f& near) const {
        const float step = (near - before).norm() / stepsOfACell;
        Eigen::Vector3f place = near;
        Eigen::Vector3f ahead = (near - before).normalized();
        for (int left = stepsOfACell; left > 0; --left) {
            const ClosestPoint under = query_.closestNear(place + step * ahead, step);
            const Eigen::Vector3f next = position(mesh_, under.point);
            if ((next - place).dot(ahead) < step / 2) {
                return place + float(left) * step * ahead;
            }
            const Eigen::Vector3f outward = normal(under.point);
            ahead = (ahead - ahead.dot(outward) * outward).normalized();
            place = next;
        }
        return place;
    }

    // Whether the film continues over a triangle. At least one corner must be held and none
    // unknown, and the film must neither fold nor tear there.
    bool isContinued(const FilmTriangle& triangle) const {
        const auto count = [&](Reach reach) {
            return std::count_if(triangle.begin(), triangle.end(),
                                 [&](std::uint32_t point) { return state_[point] == reach; });
        };
        if (count(Reach::None) > 0 || count(Reach::Held) == 0) {
            return false;
        }
        const Eigen::Vector3f& a = contact_.places[triangle[0]];
        const Eigen::Vector3f& b = contact_.places[triangle[1]];
        const Eigen::Vector3f& c = contact_.places[triangle[2]];
        const Eigen::Vector3f turn = (b - a).cross(c - a);
        const float likely = largestGap * cellOfPoint(film_.grid, triangle[0]);
        const Eigen::Vector3f outward = normal(query_.closestNear(a, likely).point) +
                                        normal(query_.closestNear(b, likely).point) +
                                        normal(query_.closestNear(c, likely).point);
        return outward.dot(turn) < 0 &&
               !principalStretch(film_.grid, triangle, {a, b, c}).isTorn(mostStretch_);
    }

    // Returns the corner values of a linear function that is zero where the limit crosses the
    // triangle's sides.
    Eigen::Vector3f limit(const FilmTriangle& triangle) const {
        const auto isPast = [&](std::size_t corner) {
            return state_[triangle[corner]] == Reach::Past;
        };
        const int past = isPast(0) + isPast(1) + isPast(2);
        Eigen::Vector3f result = Eigen::Vector3f::Constant(past == 1 ? -1 : 1);
        if (past == 0) {
            return result;
        }
        // One corner is alone on its side of the limit.
        std::size_t alone = 0;
        while (isPast(alone) != (past == 1)) {
            ++alone;
        }
        for (std::size_t corner = 0; corner < 3; ++corner) {
            if (corner != alone && past == 1) {
                const float share = shareOnBody(triangle[corner], triangle[alone]);
                result[int(corner)] = share / (1 - share);
            } else if (corner != alone) {
                const float share = shareOnBody(triangle[alone], triangle[corner]);
                result[int(corner)] = -(1 - share) / share;
            }
        }
        return result;
    }

    // Returns which share of the line from a held point to a point past the limit is held by the
    // body.
    float shareOnBody(std::uint32_t from, std::uint32_t past) const {
        const Eigen::Vector3f& start = contact_.places[from];
        const Eigen::Vector3f way = contact_.places[past] - start;
        const auto holds = [&](float share) { return isHeld(start + share * way, past); };
        float held = 0;
        float lost = 1;
        for (int place = 1; place <= triedPlaces; ++place) {
            lost = float(place) / triedPlaces;
            if (!holds(lost)) {
                break;
            }
            held = lost;
        }
        for (int i = 0; i < halvings && held < lost; ++i) {
            const float middle = (held + lost) / 2;
            (holds(middle) ? held : lost) = middle;
        }
        return std::clamp(held, leastShare, 1 - leastShare);
    }

    // Whether the body holds the film at `place` if the film continues towards `point`.
    bool isHeld(const Eigen::Vector3f& place, std::uint32_t point) const {
        const float water = film_.positions[point].y();
        const ClosestPoint under =
            query_.closest(place, largestGap * cellOfPoint(film_.grid, point));
        if (!under.point.isValid() || body_.isDry(under.point)) {
            return false;
        }
        const Eigen::Vector3f at = position(mesh_, under.point);
        if (body_.path.isStraightDown()) {
            return at.y() <= water && normal(under.point).y() <= steepest_;
        }
        const auto way = firstUnderWater(body_.path, at.cast<double>());
        return way && normal(under.point)
                              .dot(placeOnPath(body_.path, *way).linear().row(1).cast<float>()) <=
                          steepest_;
    }
    Eigen::Vector3f normal(const SurfacePoint& point) const { return normalAt(normals_, point); }

    const DippedFilm& film_;
    const PosedBody& body_;
    const TriangleMesh& mesh_;
    const CornerNormals& normals_;
    const SurfaceQuery& query_;
    FilmContact& contact_;
    std::vector<FilmTriangle> triangles_;
    float steepest_;
    double mostStretch_;
    std::vector<Reach> state_; // per film point
};

} // namespace

void continueToLimit(const DippedFilm& film, const PosedBody& body, const CornerNormals& normals,
                     const ProcessSettings& process, FilmContact& contact) {
    LimitFinder(film, body, normals, process, contact).find();
}

} // namespace dipwright
