// The dip of the production film (film-physics §2), whatever solves its equilibrium.
//
// The film is a plane problem: every point has a place in the water plane. A free point is where
// the equilibrium puts it. A point that has adhered is held; the triangles that cross the contact
// line see it where its piece of the body's surface lies when that is unfolded about the line
// (ContactPath.h). One step lowers the body by so much that the contact line travels a fraction of
// a cell along the surface, lets the film find its equilibrium, and lets every point that met the
// surface on the way adhere when and where it met it. Where the body turns up past what film holds
// on, it lets go of it: the edge of what floats stays where it lay on the water at that moment
// (ReleasedCorners). Film that tears stays where it is, all of it: it is softened, and springs back
// no more.
#pragma once

#include "pbd/FilmContact.h"
#include "pbd/StepLength.h"
#include "pbd/WaterDrag.h"

#include <dipwright/FilmSolver.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace dipwright::pbd {

// `Equilibrium` has a type Vector (two arrays x, z of its Real, a film point each) and
//   Equilibrium(grid), setFree(vector<float>),
//   setCrossing(vector<CrossingTriangle<Real>>, const Vector& displacement),
//   moveCrossing(vector<CrossingTriangle<Real>>),
//   solve(Vector& displacement, Drag<Vector>, double residual),
//   tornTriangles(const Vector& displacement, double limit) → vector<TriangleCorners> and
//   relax(const Vector& displacement, double keep).
template <typename Equilibrium>
class QuasiStaticDip {
public:
    using Vector = typename Equilibrium::Vector;
    using Real = typename Vector::Real;

    explicit QuasiStaticDip(const solver::DipSetup& setup)
        : grid_(setup.film),
          settings_(setup.settings), body_{fieldGrid<Real>(setup.field), setup.motion,
                                           Real(settings_.contactDistance),
                                           Real(std::sin(settings_.overhang))},
          equilibrium_(setup.film), displacement_(grid_.pointCount()), before_(grid_.pointCount()),
          states_(grid_.pointCount(), solver::PointState::Free), attached_(grid_.pointCount()),
          free_(grid_.pointCount(), 1.f), clearance_(grid_.pointCount(), Real(0)) {
        for (std::size_t point = 0; point < setup.pinned.size(); ++point) {
            free_[point] = setup.pinned[point] ? 0.f : 1.f;
        }
        equilibrium_.setFree(free_);
    }

    solver::Progress advance(int maximumSteps) {
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
            equilibrium_.moveCrossing(crossingTriangles(frame));
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
            std::vector<CrossingTriangle<Real>> crossing = crossingTriangles(frame);
            if (releaseWhereTurnedUp(crossing, increment)) {
                crossing = crossingTriangles(frame);
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
                              double increment) {
        bool any = false;
        for (const CrossingTriangle<Real>& triangle : crossing) {
            if (triangle.upwards > body_.steepestHeld) {
                release(triangle, increment);
                any = true;
            }
        }
        return any;
    }
    void release(const CrossingTriangle<Real>& crossing, double increment) {
        const int cells = grid_.columns - 1;
        const TriangleCorners triangle = triangleCorners(
            grid_.columns, int(crossing.cell) % cells, int(crossing.cell) / cells, crossing.second);
        const std::size_t index = triangleIndex(crossing.cell, crossing.second);
        CrossingStep<Real> step{descent_, increment};
        findCorners(triangle, index, bodyFrame<Real>(body_.motion, descent_), before_, step.before);
        findCorners(triangle, index, bodyFrame<Real>(body_.motion, descent_ + increment),
                    displacement_, step.after);
        Vector3<Real> held[3];
        for (int k = 0; k < 3; ++k) {
            held[k] = attached_[triangle.points[k]];
        }
        pbd::releaseWhereTurnedUp(body_, cell(), triangle, step, held, released_[index]);
    }

    static std::size_t triangleIndex(std::size_t cell, bool second) { return 2 * cell + second; }

    void findCorners(const TriangleCorners& triangle, std::size_t index,
                     const BodyFrame<Real>& frame, const Vector& displacement,
                     CrossingCorner<Real> (&corners)[3]) const {
        const auto found = released_.find(index);
        const ReleasedCorners<Real> released =
            found == released_.end() ? ReleasedCorners<Real>{} : found->second;
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t point = triangle.points[k];
            corners[k] = crossingCorner(states_[point], planePosition(displacement, point),
                                        frame.toWorld(attached_[point]), released, k);
        }
    }

    // Unfolds the surface under every triangle that crosses the contact line and still moves. Where
    // there is no contact line near (a flat face, a body that has gone under) its corners stay
    // where they are.
    std::vector<CrossingTriangle<Real>> crossingTriangles(const BodyFrame<Real>& frame) {
        std::vector<CrossingTriangle<Real>> crossing;
        steepness_ = Real(1);
        driven_ = false;
        const auto isAdhered = [&](std::size_t point) {
            return states_[point] != solver::PointState::Free;
        };
        for (int row = 0; row + 1 < grid_.rows; ++row) {
            for (int column = 0; column + 1 < grid_.columns; ++column) {
                const std::size_t p =
                    std::size_t(row) * std::size_t(grid_.columns) + std::size_t(column);
                const int adhered = isAdhered(p) + isAdhered(p + 1) +
                                    isAdhered(p + std::size_t(grid_.columns)) +
                                    isAdhered(p + std::size_t(grid_.columns) + 1);
                if (adhered == 0 || adhered == 4) {
                    continue;
                }
                for (const bool second : {false, true}) {
                    unfoldTriangle(column, row, second, frame, crossing);
                }
            }
        }
        return crossing;
    }

    void unfoldTriangle(int column, int row, bool second, const BodyFrame<Real>& frame,
                        std::vector<CrossingTriangle<Real>>& crossing) {
        const TriangleCorners triangle = triangleCorners(grid_.columns, column, row, second);
        bool anyHeld = false, moves = false;
        for (const std::uint32_t point : triangle.points) {
            anyHeld = anyHeld || states_[point] != solver::PointState::Free;
            moves = moves || free_[point] > 0;
        }
        if (!anyHeld || !moves) {
            return;
        }
        const std::uint32_t cellIndex =
            std::uint32_t(row) * std::uint32_t(grid_.columns - 1) + std::uint32_t(column);
        CrossingCorner<Real> corners[3];
        findCorners(triangle, triangleIndex(cellIndex, second), frame, displacement_, corners);
        UnfoldedTriangle<Real> unfolded = unfoldedTriangle(body_, frame, cell(), triangle, corners);
        unfolded.crossing.cell = cellIndex;
        steepness_ = std::min(steepness_, unfolded.steepness);
        driven_ = true;
        crossing.push_back(unfolded.crossing);
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
    std::map<std::size_t, ReleasedCorners<Real>> released_; // by triangle, see triangleIndex
    Real steepness_ = Real(1);                              // the least of all contact-line places
    double descent_ = 0, increment_ = 0;
    std::int64_t steps_ = 0;
    bool anyAdhered_ = false;
    bool driven_ = false;      // the contact line still pulls at the film
    bool freeChanged_ = false; // free_ is newer than what the equilibrium knows
};

// FilmSolver::read for such a dip.
template <typename Equilibrium>
void readFilm(const QuasiStaticDip<Equilibrium>& dip, std::size_t points,
              std::span<float> positions, std::span<solver::PointState> states) {
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

} // namespace dipwright::pbd
