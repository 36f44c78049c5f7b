// The production film on the GPU (FilmBackend.h): all steps of a launch in one kernel in which the
// blocks of a film have barriers between the parts of the work, so that the host is not asked
// before they are done.
#pragma once

#include "production/cuda/PlaneForces.cuh"
#include "production/formulas/FilmStep.h"

#include <dipwright/FilmSolver.h>

namespace dipwright::cuda {

// One film in the hands of its team (FilmBackend.h). All members are called by all threads of the
// team.
class CudaBackend {
public:
    using Real = float;

    __device__ CudaBackend(const ProductionModel& model, const ProductionDip& dip, Team& team,
                           float2* memory)
        : model_(model), dip_(dip), team_(team), memory_(memory), state_(*dip.state) {}

    __device__ const numerics::FilmModel<float>& model() const { return model_; }
    __device__ const numerics::ContactBody<float>& body() const { return dip_.body; }
    __device__ numerics::StepState<float>& state() { return state_; }

    __device__ numerics::Vector2<float> displacement(int point) const {
        return plain(dip_.displacement[point]);
    }
    __device__ numerics::Vector2<float> before(int point) const {
        return plain(dip_.before[point]);
    }
    __device__ void setDisplacement(int point, numerics::Vector2<float> way) const {
        dip_.displacement[point] = {way.x, way.z};
    }
    __device__ void setBefore(int point, numerics::Vector2<float> way) const {
        dip_.before[point] = {way.x, way.z};
    }
    __device__ solver::PointState pointState(int point) const {
        return solver::PointState(dip_.states[point]);
    }
    __device__ numerics::Vector3<float> attached(int point) const {
        const float3 place = dip_.attached[point];
        return {place.x, place.y, place.z};
    }
    __device__ void attach(int point, numerics::Vector3<float> place,
                           solver::PointState state) const {
        dip_.attached[point] = {place.x, place.y, place.z};
        dip_.states[point] = std::uint8_t(state);
    }
    __device__ bool moves(int point) const { return dip_.free[point] > 0; }
    __device__ void hold(int point) const { dip_.free[point] = 0; }
    __device__ float clearance(int point) const { return dip_.clearance[point]; }
    __device__ void setClearance(int point, float clearance) const {
        dip_.clearance[point] = clearance;
    }

    __device__ numerics::Matrix2<float> shape(int triangle) const {
        return shapeOf(dip_, triangle);
    }
    __device__ void setShape(int triangle, const numerics::Matrix2<float>& inverse) const {
        dip_.inverseShape[triangle] = {inverse.a, inverse.b, inverse.c, inverse.d};
    }
    __device__ numerics::EdgePair<float> edges(int triangle) const {
        return triangleEdges(corners(triangle), model_.edgeX, model_.edgeZ,
                             [&](std::uint32_t point) { return dip_.displacement[point]; });
    }
    __device__ bool triangleMoves(int triangle) const {
        bool moves = false;
        for (const std::uint32_t point : corners(triangle).points) {
            moves = moves || dip_.levelFree[point] > 0;
        }
        return moves;
    }
    __device__ numerics::LaidCorners<float>& laid(int triangle) const {
        return dip_.laid[triangle];
    }

    __device__ void barrier() const { team_.barrier(); }
    __device__ float least(float value) const {
        double largest[1] = {-double(value)};
        team_.largest(largest);
        return float(-largest[0]);
    }
    __device__ bool anyOf(bool flag) const {
        double found[1] = {flag ? 1.0 : 0.0};
        team_.largest(found);
        return found[0] > 0;
    }

    template <typename Work>
    __device__ void forPoints(const Work& work) const {
        const int count = numerics::pointCount(model_);
        for (int point = team_.thread(); point < count; point += team_.threadCount()) {
            work(point);
        }
    }
    template <typename Crosses, typename Unfold>
    __device__ numerics::LineState<float> findCrossing(const Crosses& crosses,
                                                       const Unfold& unfold) const {
        float steepness = 1;
        bool driven = false;
        forAllTriangles([&](int triangle) {
            const numerics::TriangleCorners points = corners(triangle);
            const bool onLine = crosses(points);
            dip_.crosses[triangle] = onLine ? 1 : 0;
            if (onLine) {
                const numerics::UnfoldedTriangle<float> unfolded = unfold(triangle, points);
                dip_.crossing[triangle] = unfolded.crossing;
                steepness = fminf(steepness, unfolded.steepness);
                driven = true;
            }
        });
        double found[2] = {-double(steepness), driven ? 1.0 : 0.0};
        team_.largest(found);
        return {float(-found[0]), found[1] > 0};
    }
    template <typename Work>
    __device__ void forCrossing(const Work& work) const {
        forAllTriangles([&](int triangle) {
            if (dip_.crosses[triangle]) {
                work(triangle, dip_.crossing[triangle], dip_.anchors[triangle]);
            }
        });
    }
    template <typename OnLine, typename Floating>
    __device__ void forTriangles(const OnLine& onLine, const Floating& floating) const {
        forAllTriangles([&](int triangle) {
            if (dip_.crosses[triangle]) {
                onLine(triangle, dip_.crossing[triangle], dip_.anchors[triangle]);
            } else {
                floating(triangle);
            }
        });
    }
    template <typename OnLine, typename Floating>
    __device__ void forStretched(float, const OnLine& onLine, const Floating& floating) const {
        forTriangles(onLine, floating);
    }

    __host__ __device__ static constexpr numerics::NewtonLimits newtonLimits() { return {}; }
    __device__ void setFree() const {
        forPoints([&](int point) { dip_.levelFree[point] = dip_.free[point]; });
        team_.barrier();
        for (int l = 1; l < model_.levelCount; ++l) {
            holdCoarse(l);
        }
    }
    __device__ numerics::FilmForce force(float drag) const {
        return cuda::force(model_, dip_, drag, 0, team_, memory_);
    }
    __device__ numerics::FilmForce forceAlong(float length, float drag) const {
        return cuda::force(model_, dip_, drag, length, team_, memory_);
    }
    __device__ void solveLinear(float drag, double start, double tolerance) const {
        numerics::conjugateGradients(*this, drag, start, tolerance);
    }
    __device__ double startOfStep() const {
        double longest[1] = {0};
        forPoints([&](int point) {
            const float2 step = dip_.newtonStep[point];
            dip_.start[point] = dip_.displacement[point];
            longest[0] = fmax(longest[0], double(fmaxf(fabsf(step.x), fabsf(step.y))));
        });
        team_.largest(longest);
        return longest[0];
    }
    __device__ void keepBest() const { copy(dip_.displacement, dip_.best); }
    __device__ void takeBest() const {
        copy(dip_.best, dip_.displacement);
        team_.barrier();
    }

    __device__ void startLinear() const {
        forPoints([&](int point) { dip_.newtonStep[point] = {0, 0}; });
    }
    __device__ double precondition() const {
        double product[1] = {multigridCycle(model_, dip_, team_, memory_)};
        team_.sum(product);
        return product[0];
    }
    __device__ double curvature(float drag, float keep, int iteration) const {
        return cuda::curvature(model_, dip_, drag, dip_.direction[(iteration + 1) % 2],
                               dip_.direction[iteration % 2], keep, team_, memory_);
    }
    __device__ double advance(float length, int iteration) const {
        const float2* direction = dip_.direction[iteration % 2];
        double squares[1] = {0};
        forPoints([&](int point) {
            dip_.newtonStep[point] = dip_.newtonStep[point] - direction[point] * length;
            const float2 left = dip_.right[point] - dip_.product[point] * length;
            dip_.right[point] = left;
            squares[0] += double(left.x * left.x + left.y * left.y);
        });
        team_.sum(squares);
        return sqrt(squares[0]);
    }

private:
    __device__ static numerics::Vector2<float> plain(float2 value) { return {value.x, value.y}; }
    __device__ numerics::TriangleCorners corners(int triangle) const {
        return numerics::triangleCorners(model_.columns, std::size_t(triangle));
    }
    template <typename Work>
    __device__ void forAllTriangles(const Work& work) const {
        const int count = numerics::triangleCount(model_);
        for (int triangle = team_.thread(); triangle < count; triangle += team_.threadCount()) {
            work(triangle);
        }
    }
    __device__ void copy(const float2* from, float2* to) const {
        forPoints([&](int point) { to[point] = from[point]; });
    }

    // A coarse point is held where the fine point nearest to it is. A held patch too small to be
    // seen by any coarse point still holds the coarse points nearest to it: without one the level
    // could not tell where the film is.
    __device__ void holdCoarse(int index) const {
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
        team_.barrier();
    }

    const ProductionModel& model_;
    const ProductionDip& dip_;
    Team& team_;
    float2* memory_;
    numerics::StepState<float> state_;
};

static_assert(numerics::FilmBackend<CudaBackend> && numerics::ConjugateBackend<const CudaBackend>);

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
    CudaBackend film(model, dip, team, memory);
    for (int step = 0; step < maximumSteps && !numerics::isFinished(film); ++step) {
        numerics::step(film);
    }
    team.barrier(); // everyone has read the state
    if (team.block() == 0 && threadIdx.x == 0) {
        *dip.state = film.state();
    }
}

} // namespace dipwright::cuda
