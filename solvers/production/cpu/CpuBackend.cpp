#include "production/cpu/CpuBackend.h"

#include "common/cpu/RowParallel.h"
#include "production/cpu/RowKernels.h"

#include <cmath>

namespace dipwright::cpu {

namespace {

void add(float factor, const PlaneVector& a, PlaneVector& out) {
    addScaled(out.size(), factor, a.x.data(), out.x.data());
    addScaled(out.size(), factor, a.z.data(), out.z.data());
}
void scale(float factor, PlaneVector& v) {
    scaleRow(v.size(), factor, v.x.data());
    scaleRow(v.size(), factor, v.z.data());
}

} // namespace

static_assert(numerics::FilmBackend<CpuBackend> && numerics::GmresBackend<CpuBackend>);

CpuBackend::CpuBackend(const solver::DipSetup& setup)
    : HostFilm(setup), film_(model()), multigrid_(setup.film), areas_(setup.film.pointCount()),
      gradient_(setup.film.pointCount()), step_(setup.film.pointCount()),
      residual_(setup.film.pointCount()), start_(setup.film.pointCount()),
      best_(setup.film.pointCount()),
      basis_(std::size_t(numerics::mostBasisVectors) + 1, PlaneVector(setup.film.pointCount())),
      smoothed_(std::size_t(numerics::mostBasisVectors), PlaneVector(setup.film.pointCount())) {
    forPoints([&](int point) { areas_[std::size_t(point)] = pointArea(model(), point); });
    setFree();
}

void CpuBackend::setFree() {
    masked_ = free_;
    film_.setFree(masked_);
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
    addDifference(gradient_.size(), drag, areas_.data(), displacement_.x.data(), before_.x.data(),
                  gradient_.x.data());
    addDifference(gradient_.size(), drag, areas_.data(), displacement_.z.data(), before_.z.data(),
                  gradient_.z.data());
    maskHeld(gradient_);
    return {std::sqrt(dot(gradient_, gradient_)), elastic};
}

numerics::FilmForce CpuBackend::forceAlong(float length, float drag) {
    const FlushDenormals flush;
    displacement_ = start_;
    add(length, step_, displacement_);
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

void CpuBackend::solveLinear(float drag, numerics::Tangent tangent, double start,
                             double tolerance) {
    const FlushDenormals flush;
    numerics::solveGmres(*this, drag, tangent, start, tolerance);
}

void CpuBackend::startLinear() {
    std::fill(step_.x.begin(), step_.x.end(), 0.f);
    std::fill(step_.z.begin(), step_.z.end(), 0.f);
    residual_ = gradient_;
}

void CpuBackend::startBasis(float factor) {
    basis_.front() = residual_;
    scale(factor, basis_.front());
}

void CpuBackend::multiply(const PlaneVector& v, float drag, numerics::Tangent tangent,
                          PlaneVector& out) {
    film_.hessian(v, tangent, out);
    addWeighted(out.size(), drag, areas_.data(), v.x.data(), out.x.data());
    addWeighted(out.size(), drag, areas_.data(), v.z.data(), out.z.data());
    maskHeld(out);
}

void CpuBackend::extendBasis(int count, float drag, numerics::Tangent tangent) {
    const std::size_t newest = std::size_t(count);
    multigrid_.apply(basis_[newest], smoothed_[newest]);
    PlaneVector& next = basis_[newest + 1];
    multiply(smoothed_[newest], drag, tangent, next);
    double* column = leastResiduals_.matrix[count];
    for (std::size_t i = 0; i <= newest; ++i) {
        column[i] = dot(next, basis_[i]);
        add(-float(column[i]), basis_[i], next);
    }
    const double size = std::sqrt(dot(next, next));
    column[newest + 1] = size;
    scale(size > 0 ? float(1 / size) : 0.f, next);
}

void CpuBackend::addToStep(int count) {
    for (int i = 0; i < count; ++i) {
        add(-float(leastResiduals_.weights[i]), smoothed_[std::size_t(i)], step_);
    }
}

double CpuBackend::linearResidual(float drag, numerics::Tangent tangent) {
    multiply(step_, drag, tangent, residual_);
    add(1, gradient_, residual_);
    return std::sqrt(dot(residual_, residual_));
}

} // namespace dipwright::cpu
