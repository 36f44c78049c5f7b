// The production film's step on the GPU (ProductionDip.h, film-physics §2), the same as on the
// CPU: all of it in one kernel in which the blocks of a film meet between the parts of the work, so
// that the host is not asked before the steps are done.
#pragma once

#include "production/cuda/PlaneForces.cuh"
#include "production/formulas/StepLength.h"
#include "production/formulas/Tolerances.h"
#include "production/formulas/WaterDrag.h"

#include <dipwright/FilmSolver.h>

namespace dipwright::cuda {

// One film in the hands of its team. All members are called by all threads of the team.
class ProductionFilm {
public:
    __device__ ProductionFilm(const ProductionModel& model, const ProductionDip& dip, Team& team,
                              float2* memory)
        : model_(model), dip_(dip), team_(team), memory_(memory), state_(*dip.state) {}

    __device__ bool finished() const { return state_.descent >= dip_.body.motion.travel; }
    __device__ const ProductionState& state() const { return state_; }

    __device__ void step() {
        const double increment = fmin(nextIncrement(), dip_.body.motion.travel - state_.descent);
        const double descent = state_.descent + increment;
        predict(increment);
        team_.meet();
        bool freeChanged = false;
        if (state_.anyAdhered) {
            findCrossing(descent, true);
            moveAnchors();
            solve(float(numerics::pointDrag(model_.spacingX, model_.spacingZ, increment)));
            freeChanged = holdTorn();
            relax(float(
                numerics::keptStress(increment, dip_.body.motion.speed, model_.relaxationTime)));
        }
        const bool hasTouched = touch(increment);
        state_.anyAdhered = anyOf(hasTouched) || state_.anyAdhered;
        if (state_.anyAdhered) {
            findCrossing(descent, false);
            if (releaseWhereTurnedUp(descent)) {
                findCrossing(descent, false);
            }
            setAnchors();
        }
        if (anyOf(freeChanged || hasTouched)) {
            setFree();
        }
        state_.descent = descent;
        state_.increment = increment;
        ++state_.steps;
    }

private:
    __device__ int pointCount() const { return model_.columns * model_.rows; }
    __device__ int triangleCount() const { return 2 * (model_.columns - 1) * (model_.rows - 1); }

    template <typename Work>
    __device__ void forPoints(const Work& work) const {
        for (int point = team_.thread(); point < pointCount(); point += team_.threadCount()) {
            work(point);
        }
    }
    template <typename Work>
    __device__ void forTriangles(const Work& work) const {
        for (int i = team_.thread(); i < triangleCount(); i += team_.threadCount()) {
            work(i);
        }
    }

    __device__ bool isFree(std::uint32_t point) const {
        return solver::PointState(dip_.states[point]) == solver::PointState::Free;
    }
    __device__ numerics::Vector3<float> planePosition(std::uint32_t point,
                                                      float2 displacement) const {
        const std::uint32_t row = point / std::uint32_t(model_.columns);
        const std::uint32_t column = point - row * std::uint32_t(model_.columns);
        return {float(-model_.width / 2 + double(column) * model_.spacingX) + displacement.x, 0.0f,
                float(-model_.depth / 2 + double(row) * model_.spacingZ) + displacement.y};
    }
    __device__ numerics::TriangleCorners corners(int triangle) const {
        return numerics::triangleCorners(model_.columns, std::size_t(triangle));
    }

    __device__ double nextIncrement() {
        const double travel = model_.contactTravel * double(model_.cell);
        const double increment = state_.anyAdhered
                                     ? numerics::contactIncrement(travel, double(state_.steepness))
                                     : double(model_.cell);
        return fmin(increment, numerics::approachIncrement(travel, nearestClearance(increment)));
    }

    __device__ double nearestClearance(double most) {
        const auto frame = numerics::bodyFrame<float>(dip_.body.motion, state_.descent);
        const auto free = [&](std::size_t point) { return isFree(std::uint32_t(point)); };
        float nearest = float(most);
        forPoints([&](int point) {
            if (dip_.clearance[point] < nearest &&
                !numerics::isNextToContact(model_.columns, model_.rows, point, free)) {
                const float distance =
                    numerics::sampleField(dip_.body.field, frame.toBody(planePosition(
                                                               point, dip_.displacement[point])))
                        .distance;
                nearest = fminf(nearest, distance - dip_.body.contactDistance);
            }
        });
        double largest[1] = {-double(nearest)};
        team_.largest(largest);
        return -largest[0];
    }

    // Free points go on as in the step before: the warm start of the equilibrium.
    __device__ void predict(double increment) {
        const float factor =
            state_.increment > 0 && state_.driven ? float(increment / state_.increment) : 0.0f;
        const auto limited = [&](float way) {
            return fminf(fmaxf(way, -model_.cell), model_.cell);
        };
        forPoints([&](int point) {
            const float2 now = dip_.displacement[point], before = dip_.before[point];
            if (dip_.free[point] > 0) {
                dip_.displacement[point] = {now.x + limited(factor * (now.x - before.x)),
                                            now.y + limited(factor * (now.y - before.y))};
            }
            dip_.before[point] = now;
        });
    }

    // The triangles that cross the contact line with the body at `descent`, and still move.
    // `moved`: because the body has; else because the film has.
    __device__ void findCrossing(double descent, bool moved) {
        const auto frame = numerics::bodyFrame<float>(dip_.body.motion, descent);
        float steepness = 1;
        bool driven = false;
        forTriangles([&](int triangle) {
            const numerics::TriangleCorners points = corners(triangle);
            bool anyHeld = false, moves = false;
            for (const std::uint32_t point : points.points) {
                anyHeld = anyHeld || !isFree(point);
                moves = moves || dip_.free[point] > 0;
            }
            const bool crosses = anyHeld && moves;
            dip_.crosses[triangle] = crosses ? 1 : 0;
            if (crosses) {
                numerics::CrossingCorner<float> seen[3];
                findCorners(points, frame, seen);
                numerics::UnfoldedTriangle<float> unfolded = numerics::unfoldedTriangle(
                    dip_.body, frame, model_.cell, points, seen, moved, dip_.laid[triangle]);
                unfolded.crossing.cell = std::uint32_t(triangle / 2);
                dip_.crossing[triangle] = unfolded.crossing;
                steepness = fminf(steepness, unfolded.steepness);
                driven = true;
            }
        });
        double found[2] = {-double(steepness), driven ? 1.0 : 0.0};
        team_.largest(found);
        state_.steepness = float(-found[0]);
        state_.driven = found[1] > 0;
    }

    __device__ void findCorners(const numerics::TriangleCorners& triangle,
                                const numerics::BodyFrame<float>& frame,
                                numerics::CrossingCorner<float> (&found)[3]) const {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t point = triangle.points[k];
            found[k] = numerics::crossingCorner(solver::PointState(dip_.states[point]),
                                                planePosition(point, dip_.displacement[point]),
                                                frame.toWorld(attached(point)));
        }
    }
    __device__ numerics::Vector3<float> attached(std::uint32_t point) const {
        const float3 place = dip_.attached[point];
        return {place.x, place.y, place.z};
    }

    // The floating parts of the crossing triangles have the gradient that they have now.
    __device__ void setAnchors() const {
        forTriangles([&](int triangle) {
            if (dip_.crosses[triangle]) {
                const numerics::CrossingTriangle<float>& crossing = dip_.crossing[triangle];
                dip_.anchors[triangle] = numerics::crossingAnchor(
                    crossing,
                    gradientOf(numerics::unfoldedEdges(edges(corners(triangle)), crossing),
                               shapeOf(dip_, triangle)));
            }
        });
    }
    __device__ void moveAnchors() const {
        forTriangles([&](int triangle) {
            if (dip_.crosses[triangle]) {
                dip_.anchors[triangle] =
                    numerics::anchorOverStep(dip_.anchors[triangle], dip_.crossing[triangle]);
            }
        });
        team_.meet();
    }

    __device__ void hold(const numerics::TriangleCorners& points) const {
        for (const std::uint32_t point : points.points) {
            dip_.free[point] = 0;
        }
    }

    // Holds the corners of film that is stretched too far. Whether this thread has.
    __device__ bool holdTorn() const {
        bool any = false;
        forTriangles([&](int triangle) {
            const numerics::TriangleCorners points = corners(triangle);
            bool moves = false;
            for (const std::uint32_t point : points.points) {
                moves = moves || dip_.levelFree[point] > 0;
            }
            if (!moves) {
                return;
            }
            const numerics::EdgePair<float> plane = edges(points);
            const numerics::EdgePair<float> seen =
                dip_.crosses[triangle] ? numerics::unfoldedEdges(plane, dip_.crossing[triangle])
                                       : plane;
            if (numerics::isTorn(seen, model_.edgeX, model_.edgeZ, float(model_.tearStretch))) {
                hold(points);
                any = true;
            }
        });
        return any;
    }

    // Lets film go where the body has turned up past what it holds on. Whether the team has any.
    __device__ bool releaseWhereTurnedUp(double descent) const {
        bool any = false;
        forTriangles([&](int triangle) {
            if (dip_.crosses[triangle] &&
                dip_.crossing[triangle].upwards > dip_.body.steepestHeld) {
                release(triangle, descent);
                any = true;
            }
        });
        return anyOf(any);
    }
    __device__ void release(int triangle, double descent) const {
        const numerics::TriangleCorners points = corners(triangle);
        numerics::CrossingCorner<float> seen[3];
        findCorners(points, numerics::bodyFrame<float>(dip_.body.motion, descent), seen);
        const numerics::Matrix2<float> change = numerics::releaseWhereTurnedUp(
            dip_.body, points, dip_.crossing[triangle], seen, dip_.laid[triangle]);
        setShape(triangle, change * shapeOf(dip_, triangle));
    }

    __device__ numerics::EdgePair<float> edges(const numerics::TriangleCorners& points) const {
        return triangleEdges(points, model_.edgeX, model_.edgeZ,
                             [&](std::uint32_t point) { return dip_.displacement[point]; });
    }

    // Lets stretch decay by `keep`, and makes the floating part of a crossing triangle stand for
    // all of it.
    __device__ void relax(float keep) const {
        forTriangles([&](int triangle) {
            const bool crosses = dip_.crosses[triangle] != 0;
            if (!crosses && keep == 1) {
                return;
            }
            const numerics::EdgePair<float> plane = edges(corners(triangle));
            const numerics::Matrix2<float> shape = shapeOf(dip_, triangle);
            const numerics::Matrix2<float> relaxed =
                crosses ? numerics::relaxedCrossingShape(
                              dip_.anchors[triangle],
                              gradientOf(numerics::unfoldedEdges(plane, dip_.crossing[triangle]),
                                         shape),
                              shape, keep)
                        : numerics::relaxedInverseShape(shape, gradientOf(plane, shape), keep);
            setShape(triangle, relaxed);
        });
    }
    __device__ void setShape(int triangle, const numerics::Matrix2<float>& inverse) const {
        dip_.inverseShape[triangle] = {inverse.a, inverse.b, inverse.c, inverse.d};
    }

    // Free points within the contact distance at the end of the step stick. A point far from the
    // body is not looked at again before it or the body can have come so far. Whether this thread
    // has met any.
    __device__ bool touch(double increment) const {
        bool hasTouched = false;
        const auto frame = numerics::bodyFrame<float>(dip_.body.motion, state_.descent + increment);
        forPoints([&](int point) {
            if (!isFree(point)) {
                return;
            }
            const float2 now = dip_.displacement[point], before = dip_.before[point];
            const float2 way = now - before;
            float clearance =
                dip_.clearance[point] - (float(increment) + sqrtf(way.x * way.x + way.y * way.y));
            if (!(clearance > 0)) {
                const numerics::Vector3<float> end = planePosition(point, now);
                const float distance =
                    numerics::sampleField(dip_.body.field, frame.toBody(end)).distance -
                    dip_.body.contactDistance;
                if (distance <= 0) {
                    hasTouched =
                        stick(point, increment, planePosition(point, before), end) || hasTouched;
                } else {
                    clearance = distance / 3; // safe outside the field's grid too
                }
            }
            dip_.clearance[point] = clearance;
        });
        return hasTouched;
    }

    // Whether the point stays on the body.
    __device__ bool stick(int point, double increment, const numerics::Vector3<float>& start,
                          const numerics::Vector3<float>& end) const {
        const numerics::Attachment<float> met =
            numerics::attachment(dip_.body, state_.descent, increment, start, end - start);
        dip_.attached[point] = {met.place.x, met.place.y, met.place.z};
        dip_.states[point] = std::uint8_t(met.state);
        const bool sticks = met.state != solver::PointState::Free;
        dip_.free[point] = sticks ? 0.0f : dip_.free[point];
        return sticks;
    }

    // The team meets, and each thread learns whether any has seen it.
    __device__ bool anyOf(bool seen) const {
        double found[1] = {seen ? 1.0 : 0.0};
        team_.largest(found);
        return found[0] > 0;
    }

    // Tells the equilibrium which points move.
    __device__ void setFree() {
        forPoints([&](int point) { dip_.levelFree[point] = dip_.free[point]; });
        team_.meet();
        for (int l = 1; l < model_.levelCount; ++l) {
            holdCoarse(l);
        }
    }

    // A coarse point is held where the fine point nearest to it is. A held patch too small to be
    // seen by any coarse point still holds the coarse points nearest to it: without one the level
    // could not tell where the film is.
    __device__ void holdCoarse(int index) {
        const PlaneLevel &fine = model_.levels[index - 1], &coarse = model_.levels[index];
        const float* fineFree = dip_.levelFree + fine.offset;
        float* coarseFree = dip_.levelFree + coarse.offset;
        const auto nearest = [](int i, int from, int to) {
            return int(lround(double(i) * (to - 1) / (from - 1)));
        };
        const auto forLevel = [&](const PlaneLevel& level, const auto& work) {
            forRange({0, level.columns, 0, level.rows}, work, team_.thread(), team_.threadCount());
        };
        double anyHeld[1] = {0};
        forLevel(coarse, [&](int x, int z) {
            const float free = fineFree[nearest(z, coarse.rows, fine.rows) * fine.columns +
                                        nearest(x, coarse.columns, fine.columns)];
            coarseFree[z * coarse.columns + x] = free;
            anyHeld[0] = free == 0 ? 1 : anyHeld[0];
        });
        team_.largest(anyHeld);
        if (anyHeld[0] > 0) {
            return;
        }
        forLevel(fine, [&](int x, int z) {
            if (fineFree[z * fine.columns + x] == 0) {
                coarseFree[nearest(z, fine.rows, coarse.rows) * coarse.columns +
                           nearest(x, fine.columns, coarse.columns)] = 0;
            }
        });
        team_.meet();
    }

    // Moves the free points until the forces left on them are `residual` times those in the film:
    // Newton's method (FilmEquilibrium.h).
    __device__ void solve(float drag) {
        // Below this the film is flat and whole to the precision of its numbers.
        const double floor = 1e-6 * sqrt(double(pointCount()));
        FilmForce now = force(model_, dip_, drag, 0, team_, memory_);
        double best = now.left;
        copy(dip_.displacement, dip_.best);
        for (int iteration = 0; iteration < numerics::maximumNewtonSteps; ++iteration) {
            const double allowed = fmax(model_.residual * now.elastic, floor);
            if (now.left <= allowed) {
                return;
            }
            conjugateGradients(drag, now.left, fmax(0.5 * allowed, 0.02 * now.left));
            if (!advance(drag, now)) {
                break;
            }
            if (now.left < best) {
                best = now.left;
                copy(dip_.displacement, dip_.best);
            }
        }
        copy(dip_.best, dip_.displacement);
        team_.meet();
    }

    __device__ void copy(const float2* from, float2* to) const {
        forPoints([&](int point) { to[point] = from[point]; });
    }

    // Solves Hessian · newtonStep = −forces to a residual of `tolerance`, or as far as it goes.
    __device__ void conjugateGradients(float drag, double start, double tolerance) {
        forPoints([&](int point) { dip_.newtonStep[point] = {0, 0}; });
        double before = 0;
        for (int iteration = 0; iteration < numerics::maximumConjugateSteps; ++iteration) {
            double now[1] = {multigridCycle(model_, dip_, team_, memory_)};
            team_.sum(now);
            if (!(now[0] > 0)) {
                return;
            }
            const float keep = before > 0 ? float(now[0] / before) : 0.0f;
            before = now[0];
            float2* direction = dip_.direction[iteration % 2];
            const double bend = curvature(model_, dip_, drag, dip_.direction[(iteration + 1) % 2],
                                          direction, keep, team_, memory_);
            if (!(bend > 1e-6 * now[0])) {
                return;
            }
            const float length = float(now[0] / bend);
            double squares[1] = {0};
            forPoints([&](int point) {
                dip_.newtonStep[point] = dip_.newtonStep[point] - direction[point] * length;
                const float2 left = dip_.right[point] - dip_.product[point] * length;
                dip_.right[point] = left;
                squares[0] += double(left.x * left.x + left.y * left.y);
            });
            team_.sum(squares);
            const double left = sqrt(squares[0]);
            if (left <= tolerance || !(left < 10 * start)) {
                return;
            }
        }
    }

    // Adds newtonStep to the displacement, shortened until the forces shrink. Where no length
    // helps, the whole step is taken all the same: the forces may have to grow on the way past a
    // crease. `now` becomes the force then. False where the step is no number.
    __device__ bool advance(float drag, FilmForce& now) {
        double longest[1] = {0};
        forPoints([&](int point) {
            const float2 step = dip_.newtonStep[point];
            dip_.start[point] = dip_.displacement[point];
            longest[0] = fmax(longest[0], double(fmaxf(fabsf(step.x), fabsf(step.y))));
        });
        team_.largest(longest);
        if (!isfinite(longest[0])) {
            return false;
        }
        const double longestStep = 2 * fmax(model_.spacingX, model_.spacingZ);
        const double whole = fmin(1.0, longestStep / fmax(longest[0], 1e-30));
        const double before = now.left;
        double length = whole;
        for (int attempt = 0; attempt <= numerics::maximumShortenings; ++attempt, length /= 2) {
            const bool isLast = attempt == numerics::maximumShortenings;
            now = force(model_, dip_, drag, float(isLast ? whole : length), team_, memory_);
            if (now.left <= before * (1 - 0.1 * length)) {
                break;
            }
        }
        return true;
    }

    const ProductionModel& model_;
    const ProductionDip& dip_;
    Team& team_;
    float2* memory_;
    ProductionState state_;
};

// At most `maximumSteps` steps of every dip, each by `blocksPerDip` blocks.
__global__ void __launch_bounds__(Team::threads, 1)
    productionSteps(const __grid_constant__ ProductionModel model, const ProductionDip* dips,
                    int blocksPerDip, int maximumSteps) {
    extern __shared__ float2 memory[];
    __shared__ ProductionDip dip;
    __shared__ Team team;
    if (threadIdx.x == 0) {
        dip = dips[int(blockIdx.x) / blocksPerDip];
    }
    __syncthreads();
    team.begin(dip.team, blocksPerDip, int(blockIdx.x) % blocksPerDip);
    ProductionFilm film(model, dip, team, memory);
    for (int step = 0; step < maximumSteps && !film.finished(); ++step) {
        film.step();
    }
    team.meet(); // everyone has read the state
    if (team.block() == 0 && threadIdx.x == 0) {
        *dip.state = film.state();
    }
}

} // namespace dipwright::cuda
