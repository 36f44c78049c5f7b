#include "production/cpu/CpuBackend.h"

#include "common/cpu/RowParallel.h"
#include "production/cpu/RowKernels.h"

#include <cmath>

namespace dipwright::cpu {

static_assert(numerics::FilmBackend<CpuBackend> && numerics::ConjugateBackend<CpuBackend>);

CpuBackend::CpuBackend(const solver::DipSetup& setup)
    : HostFilm(setup), film_(setup.film), multigrid_(setup.film),
      gradient_(setup.film.pointCount()), step_(setup.film.pointCount()),
      residual_(setup.film.pointCount()), smoothed_(setup.film.pointCount()),
      direction_(setup.film.pointCount()), product_(setup.film.pointCount()),
      start_(setup.film.pointCount()), best_(setup.film.pointCount()) {
    setFree();
}

void CpuBackend::setFree() {
    masked_ = free_;
    film_.setFree(masked_);
    multigrid_.setFree(masked_);
}

double CpuBackend::dot(const PlaneVector& a, const PlaneVector& b) const {
    const std::size_t width = std::size_t(film_.columns());
    return sumOverRows(film_.rows(), film_.columns(), [&](int row) {
        const std::size_t first = std::size_t(row) * width;
        return rowDot(a.x.data() + first, b.x.data() + first, width) +
               rowDot(a.z.data() + first, b.z.data() + first, width);
    });
}

void CpuBackend::maskHeld(PlaneVector& v) const {
    multiplyBy(v.size(), masked_.data(), v.x.data());
    multiplyBy(v.size(), masked_.data(), v.z.data());
}

numerics::FilmForce CpuBackend::force(float drag) {
    const FlushDenormals flush;
    const double elastic = film_.gradient(displacement_, gradient_);
    addDifference(gradient_.size(), drag, displacement_.x.data(), before_.x.data(),
                  gradient_.x.data());
    addDifference(gradient_.size(), drag, displacement_.z.data(), before_.z.data(),
                  gradient_.z.data());
    maskHeld(gradient_);
    return {std::sqrt(dot(gradient_, gradient_)), elastic};
}

numerics::FilmForce CpuBackend::forceAlong(float length, float drag) {
    const FlushDenormals flush;
    displacement_ = start_;
    addScaled(displacement_.size(), length, step_.x.data(), displacement_.x.data());
    addScaled(displacement_.size(), length, step_.z.data(), displacement_.z.data());
    return force(drag);
}

double CpuBackend::startOfStep() {
    start_ = displacement_;
    float longest = 0;
    for (std::size_t point = 0; point < step_.size(); ++point) {
        longest = std::max({longest, std::abs(step_.x[point]), std::abs(step_.z[point])});
    }
    return double(longest);
}

void CpuBackend::solveLinear(float drag, double start, double tolerance) {
    const FlushDenormals flush;
    numerics::conjugateGradients(*this, drag, start, tolerance);
}

void CpuBackend::startLinear() {
    std::fill(step_.x.begin(), step_.x.end(), 0.f);
    std::fill(step_.z.begin(), step_.z.end(), 0.f);
    residual_ = gradient_;
}

double CpuBackend::precondition() {
    multigrid_.apply(residual_, smoothed_);
    return dot(residual_, smoothed_);
}

double CpuBackend::curvature(float drag, float keep, int) {
    const std::size_t count = step_.size();
    scaleAndAdd(count, keep, smoothed_.x.data(), direction_.x.data());
    scaleAndAdd(count, keep, smoothed_.z.data(), direction_.z.data());
    film_.hessian(direction_, product_);
    addScaled(count, drag, direction_.x.data(), product_.x.data());
    addScaled(count, drag, direction_.z.data(), product_.z.data());
    maskHeld(product_);
    return dot(direction_, product_);
}

double CpuBackend::advance(float length, int) {
    const std::size_t count = step_.size();
    addScaled(count, -length, direction_.x.data(), step_.x.data());
    addScaled(count, -length, direction_.z.data(), step_.z.data());
    addScaled(count, -length, product_.x.data(), residual_.x.data());
    addScaled(count, -length, product_.z.data(), residual_.z.data());
    return std::sqrt(dot(residual_, residual_));
}

} // namespace dipwright::cpu
