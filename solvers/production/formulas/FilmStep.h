// The dip of the production film (film-physics §2), whatever solves its equilibrium.
//
// The film is a plane problem: every point has a place in the water plane. A free point is where
// the equilibrium puts it. A point that has adhered is held; the triangles that cross the contact
// line see it where its piece of the body's surface lies when that is unfolded about the line
// (ContactPath.h). One step lowers the body by so much that the contact line travels a fraction of
// a cell along the surface, lets the film find its equilibrium, and lets every point that met the
// surface on the way adhere when and where it met it. Where the body turns up it loses its grip,
// and film follows its unfolding less and less (LaidCorners); past what film holds on it lets go of
// it: the edge of what floats stays where it lay on the water. Film that tears stays where it is,
// all of it: it is softened, and springs back no more.
#pragma once

#include "production/formulas/Adhesion.h"
#include "production/formulas/StepLength.h"
#include "production/formulas/WaterDrag.h"

#include <dipwright/FilmSolver.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dipwright::numerics {

// `Equilibrium` has a type Vector (two arrays x, z of its Real, a film point each) and
//   Equilibrium(grid), setFree(vector<float>),
//   setCrossing(vector<CrossingTriangle<Real>>, const Vector& displacement),
//   moveCrossing(vector<CrossingTriangle<Real>>),
//   solve(Vector& displacement, Drag<Vector>, double residual),
//   tornTriangles(const Vector& displacement, double limit) → vector<TriangleCorners>,
//   relax(const Vector& displacement, double keep),
//   reshape(cell, second, Matrix2 change): a triangle's inverse rest shape times `change`, and
//   forEach(count, work): work(i) for all i below `count`, in any order, on its threads.
template <typename Equilibrium>
class FilmDip {
public:
    using Vector = typename Equilibrium::Vector;
    using Real = typename Vector::Real;

    explicit FilmDip(const solver::DipSetup& setup)
        : grid_(setup.film), settings_(setup.settings), body_(contactBody<Real>(setup)),
          equilibrium_(setup.film), displacement_(grid_.pointCount()), before_(grid_.pointCount()),
          states_(grid_.pointCount(), solver::PointState::Free), attached_(grid_.pointCount()),
          free_(grid_.pointCount(), 1.f), clearance_(grid_.pointCount(), Real(0)),
          laid_(2 * std::size_t(grid_.columns - 1) * std::size_t(grid_.rows - 1)) {
        for (std::size_t point = 0; point < setup.pinned.size(); ++point) {
            free_[point] = setup.pinned[point] ? 0.f : 1.f;
        }
        equilibrium_.setFree(free_);
    }

    solver::DipState advance(int maximumSteps) {
        for (int i = 0; i < maximumSteps && !finished(); ++i) {
            step();
        }
        return {steps_, descent_, finished()};
    }

    // World position of a point.
    Vector3<Real> position(std::size_t point) const {
        return states_[point] != solver::PointState::Free
                   ? bodyFrame<Real>(body_.motion, descent_).toWorld(attached_[point])
                   : planePosition(displacement_, point);
    }
    solver::PointState state(std::size_t point) const { return states_[point]; }
    const Equilibrium& equilibrium() const { return equilibrium_; }

private:
    bool finished() const { return descent_ >= body_.motion.travel; }
    Real cell() const { return Real(std::min(grid_.spacingX(), grid_.spacingZ())); }

    Vector3<Real> rest(std::size_t point) const {
        const std::size_t columns = std::size_t(grid_.columns);
        const std::size_t column = point % columns, row = point / columns;
        return {Real(-grid_.width / 2 + double(column) * grid_.spacingX()), Real(0),
                Real(-grid_.depth / 2 + double(row) * grid_.spacingZ())};
    }
    Vector3<Real> planePosition(const Vector& displacement, std::size_t point) const {
        return rest(point) + Vector3<Real>{displacement.x[point], Real(0), displacement.z[point]};
    }

    void step() {
        const double increment = std::min(nextIncrement(), body_.motion.travel - descent_);
        const BodyFrame<Real> frame = bodyFrame<Real>(body_.motion, descent_ + increment);
        predict(increment);
        if (anyAdhered_) {
            equilibrium_.moveCrossing(crossingTriangles(frame, true));
            equilibrium_.solve(displacement_,
                               {before_, pointDrag(grid_.spacingX(), grid_.spacingZ(), increment)},
                               settings_.residual);
            for (const TriangleCorners& torn :
                 equilibrium_.tornTriangles(displacement_, settings_.tearStretch)) {
                hold(torn);
            }
            equilibrium_.relax(displacement_,
                               keptStress(increment, body_.motion.speed, settings_.relaxationTime));
        }
        const std::vector<std::size_t> touching = touchingPoints(increment, frame);
        bool anyStuck = false;
        for (const std::size_t point : touching) {
            anyStuck = stick(point, increment) || anyStuck;
        }
        anyAdhered_ = anyAdhered_ || anyStuck;
        if (anyAdhered_) {
            std::vector<CrossingTriangle<Real>> crossing = crossingTriangles(frame, false);
            if (releaseWhereTurnedUp(crossing, frame)) {
                crossing = crossingTriangles(frame, false);
            }
            equilibrium_.setCrossing(std::move(crossing), displacement_);
        }
        if (anyStuck || freeChanged_) {
            freeChanged_ = false;
            equilibrium_.setFree(free_);
        }
        descent_ += increment;
        increment_ = increment;
        ++steps_;
    }

    // As far as the contact line may travel, and not past the moment at which another part of the
    // body touches.
    double nextIncrement() const {
        const double travel = settings_.contactTravel * double(cell());
        const double increment =
            anyAdhered_ ? contactIncrement(travel, double(steepness_)) : double(cell());
        return std::min(increment, approachIncrement(travel, nearestClearance(increment)));
    }

    // Of the points that are not next to film on the body, or `most` if none is nearer.
    double nearestClearance(double most) const {
        const BodyFrame<Real> frame = bodyFrame<Real>(body_.motion, descent_);
        const auto isFree = [&](std::size_t point) {
            return states_[point] == solver::PointState::Free;
        };
        Real nearest = Real(most);
        for (std::size_t point = 0; point < states_.size(); ++point) {
            if (clearance_[point] < nearest &&
                !isNextToContact(grid_.columns, grid_.rows, int(point), isFree)) {
                const Real distance =
                    sampleField(body_.field, frame.toBody(planePosition(displacement_, point)))
                        .distance;
                nearest = std::min(nearest, distance - body_.contactDistance);
            }
        }
        return double(nearest);
    }

    Real limited(Real way) const { return std::clamp(way, -cell(), cell()); }

    // Free points go on as in the step before: the warm start of the equilibrium.
    void predict(double increment) {
        const Real factor = increment_ > 0 && driven_ ? Real(increment / increment_) : Real(0);
        for (std::size_t point = 0; point < states_.size(); ++point) {
            const Real x = displacement_.x[point], z = displacement_.z[point];
            if (free_[point] > 0) {
                displacement_.x[point] += limited(factor * (x - before_.x[point]));
                displacement_.z[point] += limited(factor * (z - before_.z[point]));
            }
            before_.x[point] = x;
            before_.z[point] = z;
        }
    }

    // The corners of a triangle stay where they are from now on.
    void hold(const TriangleCorners& triangle) {
        for (const std::uint32_t point : triangle.points) {
            freeChanged_ = freeChanged_ || free_[point] > 0;
            free_[point] = 0.f;
        }
    }

    // Lets film go where the body has turned up past what it holds on. Whether there was any.
    bool releaseWhereTurnedUp(const std::vector<CrossingTriangle<Real>>& crossing,
                              const BodyFrame<Real>& frame) {
        bool any = false;
        for (const CrossingTriangle<Real>& triangle : crossing) {
            if (triangle.upwards > body_.steepestHeld) {
                release(triangle, frame);
                any = true;
            }
        }
        return any;
    }
    void release(const CrossingTriangle<Real>& crossing, const BodyFrame<Real>& frame) {
        const std::size_t index = triangleIndex(crossing.cell, crossing.second);
        const TriangleCorners triangle = triangleCorners(grid_.columns, index);
        CrossingCorner<Real> corners[3];
        findCorners(triangle, frame, corners);
        equilibrium_.reshape(
            crossing.cell, crossing.second,
            numerics::releaseWhereTurnedUp(body_, triangle, crossing, corners, laid_[index]));
    }

    // Two triangles a cell, cell after cell.
    static std::size_t triangleIndex(std::size_t cell, bool second) { return 2 * cell + second; }

    void findCorners(const TriangleCorners& triangle, const BodyFrame<Real>& frame,
                     CrossingCorner<Real> (&corners)[3]) const {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t point = triangle.points[k];
            corners[k] = crossingCorner(states_[point], planePosition(displacement_, point),
                                        frame.toWorld(attached_[point]));
        }
    }

    // Unfolds the surface under every triangle that crosses the contact line and still moves. Where
    // there is no contact line near (a flat face, a body that has gone under) its corners stay
    // where they are. `moved`: because the body has; else because the film has.
    std::vector<CrossingTriangle<Real>> crossingTriangles(const BodyFrame<Real>& frame,
                                                          bool moved) {
        const std::vector<std::size_t> indices = movingTrianglesOnLine();
        std::vector<CrossingTriangle<Real>> crossing(indices.size());
        std::vector<Real> steepness(indices.size());
        Equilibrium::forEach(indices.size(), [&](std::size_t i) {
            const TriangleCorners triangle = triangleCorners(grid_.columns, indices[i]);
            CrossingCorner<Real> corners[3];
            findCorners(triangle, frame, corners);
            const UnfoldedTriangle<Real> unfolded =
                unfoldedTriangle(body_, frame, cell(), triangle, corners, moved, laid_[indices[i]]);
            crossing[i] = unfolded.crossing;
            crossing[i].cell = std::uint32_t(indices[i] / 2);
            steepness[i] = unfolded.steepness;
        });
        driven_ = !crossing.empty();
        steepness_ = Real(1);
        for (const Real least : steepness) {
            steepness_ = std::min(steepness_, least);
        }
        return crossing;
    }

    // Of the triangles with held and with free corners.
    std::vector<std::size_t> movingTrianglesOnLine() const {
        std::vector<std::size_t> indices;
        const std::size_t cells = std::size_t(grid_.columns - 1) * std::size_t(grid_.rows - 1);
        const std::size_t cellsPerRow = std::size_t(grid_.columns - 1);
        const auto isHeld = [&](std::size_t point) {
            return states_[point] != solver::PointState::Free;
        };
        for (std::size_t cellIndex = 0; cellIndex < cells; ++cellIndex) {
            const std::size_t lower = cellIndex + cellIndex / cellsPerRow;
            const std::size_t upper = lower + std::size_t(grid_.columns);
            const int held = isHeld(lower) + isHeld(lower + 1) + isHeld(upper) + isHeld(upper + 1);
            for (std::size_t second = 0; held > 0 && held < 4 && second < 2; ++second) {
                const std::size_t index = 2 * cellIndex + second;
                const TriangleCorners triangle = triangleCorners(grid_.columns, index);
                const auto& points = triangle.points;
                const bool anyHeld = isHeld(points[0]) || isHeld(points[1]) || isHeld(points[2]);
                if (anyHeld && free_[points[0]] + free_[points[1]] + free_[points[2]] > 0) {
                    indices.push_back(index);
                }
            }
        }
        return indices;
    }

    // Free points within the contact distance at the end of the step. A point far from the body is
    // not looked at again before it or the body can have come so far.
    std::vector<std::size_t> touchingPoints(double increment, const BodyFrame<Real>& frame) {
        std::vector<std::size_t> touching;
        for (std::size_t point = 0; point < states_.size(); ++point) {
            if (states_[point] != solver::PointState::Free) {
                continue;
            }
            const Real dx = displacement_.x[point] - before_.x[point];
            const Real dz = displacement_.z[point] - before_.z[point];
            clearance_[point] -= Real(increment) + std::sqrt(dx * dx + dz * dz);
            if (clearance_[point] > Real(0)) {
                continue;
            }
            const Real distance =
                sampleField(body_.field, frame.toBody(planePosition(displacement_, point)))
                    .distance -
                body_.contactDistance;
            if (distance <= Real(0)) {
                touching.push_back(point);
            } else {
                clearance_[point] =
                    distance / Real(3); // a third: safe outside the field's grid too
            }
        }
        return touching;
    }

    // Whether the point stays on the body.
    bool stick(std::size_t point, double increment) {
        const Vector3<Real> start = planePosition(before_, point);
        const Vector3<Real> way = planePosition(displacement_, point) - start;
        const Attachment<Real> met = attachment(body_, descent_, increment, start, way);
        attached_[point] = met.place;
        states_[point] = met.state;
        if (met.state != solver::PointState::Free) {
            free_[point] = 0.f;
        }
        return met.state != solver::PointState::Free;
    }

    solver::FilmGrid grid_;
    solver::Settings settings_;
    ContactBody<Real> body_;
    Equilibrium equilibrium_;
    Vector displacement_, before_; // from rest, now and a step ago
    std::vector<solver::PointState> states_;
    std::vector<Vector3<Real>> attached_; // where an adhered point sits, body coordinates
    std::vector<float> free_;             // 1: the equilibrium moves it
    std::vector<Real> clearance_;         // how far from contact a free point is at least
    std::vector<LaidCorners<Real>> laid_; // by triangle, see triangleIndex
    Real steepness_ = Real(1);            // the least of all contact-line places
    double descent_ = 0, increment_ = 0;
    std::int64_t steps_ = 0;
    bool anyAdhered_ = false;
    bool driven_ = false;      // the contact line still pulls at the film
    bool freeChanged_ = false; // free_ is newer than what the equilibrium knows
};

// FilmSolver::read for such a dip.
template <typename Equilibrium>
void readFilm(const FilmDip<Equilibrium>& dip, std::size_t points, std::span<float> positions,
              std::span<solver::PointState> states) {
    for (std::size_t point = 0; point < points; ++point) {
        const auto p = dip.position(point);
        positions[3 * point] = float(p.x);
        positions[3 * point + 1] = float(p.y);
        positions[3 * point + 2] = float(p.z);
    }
    for (std::size_t point = 0; point < states.size(); ++point) {
        states[point] = dip.state(point);
    }
}

} // namespace dipwright::numerics
