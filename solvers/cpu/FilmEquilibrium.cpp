#include "cpu/FilmEquilibrium.h"

#include "cpu/RowMath.h"
#include "cpu/RowParallel.h"
#include "cpu/SimdClones.h"

#include <cmath>

namespace dipwright::cpu {

namespace {

constexpr int maximumNewtonSteps = 12;
constexpr int maximumConjugateSteps = 60;

DIPWRIGHT_SIMD_CLONES
void addScaled(std::size_t count, float factor, const float* a, float* out) {
    DIPWRIGHT_INDEPENDENT_LOOP
    for (std::size_t i = 0; i < count; ++i) {
        out[i] += factor * a[i];
    }
}

DIPWRIGHT_SIMD_CLONES
void scaleAndAdd(std::size_t count, float factor, const float* a, float* out) {
    DIPWRIGHT_INDEPENDENT_LOOP
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = factor * out[i] + a[i];
    }
}

DIPWRIGHT_SIMD_CLONES
void multiplyBy(std::size_t count, const float* a, float* out) {
    DIPWRIGHT_INDEPENDENT_LOOP
    for (std::size_t i = 0; i < count; ++i) {
        out[i] *= a[i];
    }
}

} // namespace

FilmEquilibrium::FilmEquilibrium(const solver::FilmGrid& grid)
    : film_(grid), multigrid_(grid), free_(grid.pointCount(), 1.f), gradient_(grid.pointCount()),
      step_(grid.pointCount()), residual_(grid.pointCount()), preconditioned_(grid.pointCount()),
      direction_(grid.pointCount()), product_(grid.pointCount()) {}

void FilmEquilibrium::setFree(const std::vector<float>& free) {
    free_ = free;
    multigrid_.setFree(free);
}

double FilmEquilibrium::dot(const PlaneVector& a, const PlaneVector& b) const {
    const std::size_t width = std::size_t(film_.columns());
    return sumOverRows(film_.rows(), film_.columns(), [&](int row) {
        const std::size_t first = std::size_t(row) * width;
        return rowDot(a.x.data() + first, b.x.data() + first, width) +
               rowDot(a.z.data() + first, b.z.data() + first, width);
    });
}

void FilmEquilibrium::maskHeld(PlaneVector& v) const {
    multiplyBy(v.size(), free_.data(), v.x.data());
    multiplyBy(v.size(), free_.data(), v.z.data());
}

// Solves Hessian · step_ = −gradient_ to a residual of `tolerance`.
void FilmEquilibrium::conjugateGradients(double tolerance) {
    const std::size_t count = step_.size();
    std::fill(step_.x.begin(), step_.x.end(), 0.f);
    std::fill(step_.z.begin(), step_.z.end(), 0.f);
    residual_ = gradient_;
    double before = 0;
    for (int iteration = 0; iteration < maximumConjugateSteps; ++iteration) {
        ++work_.conjugateSteps;
        multigrid_.apply(residual_, preconditioned_);
        const double now = dot(residual_, preconditioned_);
        if (!(now > 0)) {
            return;
        }
        const float keep = before > 0 ? float(now / before) : 0.f;
        scaleAndAdd(count, keep, preconditioned_.x.data(), direction_.x.data());
        scaleAndAdd(count, keep, preconditioned_.z.data(), direction_.z.data());
        before = now;
        film_.hessian(direction_, product_);
        maskHeld(product_);
        const double curvature = dot(direction_, product_);
        if (!(curvature > 0)) {
            return;
        }
        const float length = float(now / curvature);
        addScaled(count, -length, direction_.x.data(), step_.x.data());
        addScaled(count, -length, direction_.z.data(), step_.z.data());
        addScaled(count, -length, product_.x.data(), residual_.x.data());
        addScaled(count, -length, product_.z.data(), residual_.z.data());
        if (std::sqrt(dot(residual_, residual_)) <= tolerance) {
            return;
        }
    }
}

double FilmEquilibrium::solve(PlaneVector& displacement, double residual) {
    const FlushDenormals flush;
    // Below this the film is flat and whole to the precision of its numbers.
    const double floor = 1e-6 * std::sqrt(double(displacement.size()));
    double ratio = 0;
    for (int iteration = 0; iteration < maximumNewtonSteps; ++iteration) {
        const double elastic = film_.gradient(displacement, gradient_);
        maskHeld(gradient_);
        const double force = std::sqrt(dot(gradient_, gradient_));
        const double allowed = std::max(residual * elastic, floor);
        ratio = elastic > 0 ? force / elastic : 0;
        if (force <= allowed) {
            break;
        }
        ++work_.newtonSteps;
        conjugateGradients(std::max(0.5 * allowed, 0.02 * force));
        addScaled(displacement.size(), 1, step_.x.data(), displacement.x.data());
        addScaled(displacement.size(), 1, step_.z.data(), displacement.z.data());
    }
    return ratio;
}

} // namespace dipwright::cpu
