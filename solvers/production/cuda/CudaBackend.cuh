// The production film on the GPU (FilmBackend.h). One kernel runs all steps of a launch. The blocks
// of a film synchronize at barriers, so the host is not involved until the steps are done.
#pragma once

#include "production/cuda/PlaneForces.cuh"
#include "production/formulas/FilmStep.h"

#include <dipwright/FilmSolver.h>

namespace dipwright::cuda {

// A block's small least-squares problem of GMRES. It is identical in all blocks of a team.
struct SmallProblem {
    numerics::GmresProblem problem;
    float factors[numerics::mostBasisVectors + 1]; // factors on the stored basis vectors
    double answer;
};

// One film, as seen by its team (FilmBackend.h). All threads of the team call all members.
class CudaBackend {
public:
    using Real = float;

    __device__ CudaBackend(const ProductionModel& model, const ProductionDip& dip, Team& team,
                           SmallProblem& small, float2* memory)
        : model_(model), dip_(dip), team_(team), small_(small), memory_(memory),
          state_(*dip.state) {}

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
    __device__ void mark(int point, solver::PointMark why) const {
        atomicOr(dip_.marks + point, unsigned(why));
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
        const numerics::TriangleSize<float> size = triangleSize(model_, triangle);
        return triangleEdges(corners(triangle), size.x, size.z,
                             [&](std::uint32_t point) { return dip_.displacement[point]; });
    }
    __device__ bool triangleMoves(int triangle) const {
        bool moves = false;
        for (const std::uint32_t point : corners(triangle).points) {
            moves = moves || dip_.masked[point] > 0;
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

    template <typename Ask>
    __device__ bool anyPoint(const Ask& ask) const {
        bool any = false;
        forPoints([&](int point) { any = ask(point) || any; });
        return any;
    }
    template <typename Fold>
    __device__ float leastOver(float value, const Fold& fold) {
        forPoints([&](int point) { value = fold(point, value); });
        return least(value);
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
        forPoints([&](int point) { dip_.masked[point] = dip_.free[point]; });
        team_.barrier();
    }
    __device__ numerics::FilmForce force(float drag) const {
        return cuda::force(model_, dip_, drag, nullptr, team_, memory_);
    }
    __device__ numerics::FilmForce forceAlong(float length, float drag) const {
        return cuda::force(model_, dip_, drag, &length, team_, memory_);
    }
    __device__ numerics::Vector2<float> forceOn(int point) const {
        return plain(dip_.forces[point]);
    }
    __device__ void prepareLinear(float drag) const { prepareCycle(model_, dip_, drag, team_); }
    __device__ void solveLinear(float drag, numerics::Tangent tangent, double start,
                                double tolerance) {
        numerics::solveGmres(*this, drag, tangent, start, tolerance);
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

    // Each block has its own problem, and one of its threads works on it.
    template <typename Work>
    __device__ double inSmallProblem(const Work& work) const {
        if (threadIdx.x == 0) {
            small_.answer = work(small_.problem);
        }
        __syncthreads();
        const double answer = small_.answer;
        __syncthreads();
        return answer;
    }
    __device__ void startLinear() const {
        forPoints([&](int point) {
            dip_.newtonStep[point] = {0, 0};
            dip_.basis[0][point] = dip_.forces[point];
        });
        team_.barrier();
    }
    __device__ void startBasis(float factor) const {
        inSmallProblem([&](numerics::GmresProblem&) { return small_.factors[0] = factor; });
    }
    __device__ void extendBasis(int count, float drag, numerics::Tangent tangent) const {
        float2* next = dip_.basis[count + 1];
        multigridCycle(model_, dip_, {dip_.basis[count], small_.factors[count]},
                       dip_.smoothed[count], team_, memory_);
        std::int64_t products[numerics::mostBasisVectors] = {};
        multiply(model_, dip_, drag, tangent, dip_.smoothed[count], team_, memory_,
                 [&](int point, float2 product) {
                     next[point] = product;
#pragma unroll
                     for (int i = 0; i < numerics::mostBasisVectors; ++i) {
                         if (i <= count) {
                             const float2 earlier = dip_.basis[i][point];
                             products[i] += numerics::ProductSum::multiple(
                                 double(product.x * earlier.x + product.y * earlier.y) *
                                 double(small_.factors[i]));
                         }
                     }
                 });
        team_.sum(products, count + 1);
        float weights[numerics::mostBasisVectors];
#pragma unroll
        for (int i = 0; i < numerics::mostBasisVectors; ++i) {
            if (i <= count) {
                weights[i] =
                    float(numerics::ProductSum::value(products[i]) * double(small_.factors[i]));
            }
        }
        numerics::SquareSum squares;
        forPoints([&](int point) {
            float2 left = next[point];
#pragma unroll
            for (int i = 0; i < numerics::mostBasisVectors; ++i) {
                if (i <= count) {
                    left = left - dip_.basis[i][point] * weights[i];
                }
            }
            next[point] = left;
            squares.add(double(left.x * left.x + left.y * left.y));
        });
        const double length = rootOf(squares);
        inSmallProblem([&](numerics::GmresProblem& problem) {
            double* column = problem.matrix[count];
#pragma unroll
            for (int i = 0; i < numerics::mostBasisVectors; ++i) {
                if (i <= count) {
                    column[i] = numerics::ProductSum::value(products[i]);
                }
            }
            column[count + 1] = length;
            small_.factors[count + 1] = numerics::inverseLength(length);
            return 0.0;
        });
    }
    __device__ void addToStep(int count) const {
        forPoints([&](int point) {
            float2 step = dip_.newtonStep[point];
            for (int i = 0; i < count; ++i) {
                step = step - dip_.smoothed[i][point] * float(small_.problem.weights[i]);
            }
            dip_.newtonStep[point] = step;
        });
    }
    __device__ double linearResidual(float drag, numerics::Tangent tangent) const {
        team_.barrier();
        numerics::SquareSum squares;
        multiply(model_, dip_, drag, tangent, dip_.newtonStep, team_, memory_,
                 [&](int point, float2 product) {
                     const float2 left = dip_.forces[point] + product;
                     dip_.basis[0][point] = left;
                     squares.add(double(left.x * left.x + left.y * left.y));
                 });
        return rootOf(squares);
    }

private:
    // Returns the root of the sum of all threads' squares.
    __device__ double rootOf(const numerics::SquareSum& squares) const {
        std::int64_t sums[2] = {squares.whole, squares.rest};
        team_.sum(sums);
        return numerics::SquareSum{sums[0], sums[1]}.root();
    }
    __device__ static numerics::Vector2<float> plain(float2 value) {
        return {value.x, value.y};
    }
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

    const ProductionModel& model_;
    const ProductionDip& dip_;
    Team& team_;
    SmallProblem& small_;
    float2* memory_;
    numerics::StepState<float> state_;
};

static_assert(numerics::FilmBackend<CudaBackend> && numerics::GmresBackend<CudaBackend>);

// Runs at most `maximumSteps` steps of each dip, with `blocksPerDip` blocks per dip.
__global__ void __launch_bounds__(Team::threads, 1)
    productionSteps(const __grid_constant__ ProductionModel model, const ProductionDip* dips,
                    int blocksPerDip, int maximumSteps) {
    extern __shared__ float2 memory[];
    __shared__ ProductionDip dip;
    __shared__ Team team;
    __shared__ SmallProblem small;
    if (threadIdx.x == 0) {
        dip = dips[int(blockIdx.x) / blocksPerDip];
    }
    __syncthreads();
    team.begin(dip.team, blocksPerDip, int(blockIdx.x) % blocksPerDip);
    CudaBackend film(model, dip, team, small, memory);
    for (int step = 0; step < maximumSteps && !numerics::isFinished(film); ++step) {
        numerics::step(film);
    }
    team.barrier(); // all threads have read the state
    if (team.block() == 0 && threadIdx.x == 0) {
        *dip.state = film.state();
    }
}

} // namespace dipwright::cuda
