#include "production/cpu/FilmEquilibrium.h"

#include "common/cpu/RowParallel.h"
#include "common/cpu/SimdClones.h"
#include "production/cpu/RowMath.h"
#include "production/formulas/Tolerances.h"

#include <cmath>

namespace dipwright::cpu {

namespace {

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
void addDifference(std::size_t count, float factor, const float* a, const float* b, float* out) {
    DIPWRIGHT_INDEPENDENT_LOOP
    for (std::size_t i = 0; i < count; ++i) {
        out[i] += factor * (a[i] - b[i]);
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
      direction_(grid.pointCount()), product_(grid.pointCount()), start_(grid.pointCount()),
      best_(grid.pointCount()), longestStep_(2 * std::max(grid.spacingX(), grid.spacingZ())) {}

void FilmEquilibrium::setFree(const std::vector<float>& free) {
    free_ = free;
    film_.setFree(free);
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

// Solves Hessian · step_ = −gradient_ to a residual of `tolerance`, or as far as it goes: crossing
// triangles make the Hessian slightly unsymmetric.
void FilmEquilibrium::conjugateGradients(const Drag& drag, double tolerance) {
    const std::size_t count = step_.size();
    std::fill(step_.x.begin(), step_.x.end(), 0.f);
    std::fill(step_.z.begin(), step_.z.end(), 0.f);
    residual_ = gradient_;
    double before = 0;
    const double start = std::sqrt(dot(residual_, residual_));
    for (int iteration = 0; iteration < numerics::maximumConjugateSteps; ++iteration) {
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
        addScaled(count, float(drag.perPoint), direction_.x.data(), product_.x.data());
        addScaled(count, float(drag.perPoint), direction_.z.data(), product_.z.data());
        maskHeld(product_);
        const double curvature = dot(direction_, product_);
        if (!(curvature > 1e-6 * now)) {
            return;
        }
        const float length = float(now / curvature);
        addScaled(count, -length, direction_.x.data(), step_.x.data());
        addScaled(count, -length, direction_.z.data(), step_.z.data());
        addScaled(count, -length, product_.x.data(), residual_.x.data());
        addScaled(count, -length, product_.z.data(), residual_.z.data());
        const double left = std::sqrt(dot(residual_, residual_));
        if (left <= tolerance || !(left < 10 * start)) {
            return;
        }
    }
}

double FilmEquilibrium::force(const PlaneVector& displacement, const Drag& drag, double& elastic) {
    elastic = film_.gradient(displacement, gradient_);
    addDifference(displacement.size(), float(drag.perPoint), displacement.x.data(),
                  drag.before.x.data(), gradient_.x.data());
    addDifference(displacement.size(), float(drag.perPoint), displacement.z.data(),
                  drag.before.z.data(), gradient_.z.data());
    maskHeld(gradient_);
    return std::sqrt(dot(gradient_, gradient_));
}

// Adds step_ to `displacement`, shortened until the forces shrink. Where no length helps, the whole
// step is taken all the same: the forces may have to grow on the way past a crease. Returns the
// force then.
double FilmEquilibrium::advance(PlaneVector& displacement, const Drag& drag, double before,
                                double& elastic) {
    float longest = 0;
    for (std::size_t point = 0; point < step_.size(); ++point) {
        longest = std::max({longest, std::abs(step_.x[point]), std::abs(step_.z[point])});
    }
    if (!std::isfinite(longest)) {
        return before;
    }
    start_ = displacement;
    const auto tryLength = [&](double length) {
        displacement = start_;
        addScaled(displacement.size(), float(length), step_.x.data(), displacement.x.data());
        addScaled(displacement.size(), float(length), step_.z.data(), displacement.z.data());
        return force(displacement, drag, elastic);
    };
    const double whole = std::min(1.0, longestStep_ / std::max(double(longest), 1e-30));
    double length = whole;
    for (int attempt = 0; attempt < numerics::maximumShortenings; ++attempt, length /= 2) {
        const double after = tryLength(length);
        if (after <= before * (1 - 0.1 * length)) {
            return after;
        }
    }
    return tryLength(whole);
}

double FilmEquilibrium::solve(PlaneVector& displacement, const Drag& drag, double residual) {
    const FlushDenormals flush;
    // Below this the film is flat and whole to the precision of its numbers.
    const double floor = 1e-6 * std::sqrt(double(displacement.size()));
    double elastic = 0, now = force(displacement, drag, elastic);
    double best = now, bestElastic = elastic;
    best_ = displacement;
    for (int iteration = 0; iteration < numerics::maximumNewtonSteps; ++iteration) {
        const double allowed = std::max(residual * elastic, floor);
        if (now <= allowed) {
            return elastic > 0 ? now / elastic : 0;
        }
        ++work_.newtonSteps;
        conjugateGradients(drag, std::max(0.5 * allowed, 0.02 * now));
        now = advance(displacement, drag, now, elastic);
        if (now < best) {
            best = now;
            bestElastic = elastic;
            best_ = displacement;
        }
    }
    displacement = best_;
    return bestElastic > 0 ? best / bestElastic : 0;
}

} // namespace dipwright::cpu
