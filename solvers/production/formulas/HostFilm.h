// Stores the points of a production film in host memory for the backends that run there
// (FilmBackend.h, FilmStorage), and implements the functions of the solver interface. The team is
// one thread.
#pragma once

#include "production/formulas/FilmStep.h"

#include <dipwright/FilmSolver.h>

#include <span>
#include <vector>

namespace dipwright::numerics {

// `Vector` has two arrays x and z of its type Real, with one entry per film point.
template <typename Vector>
class HostFilm {
public:
    using Real = typename Vector::Real;

    explicit HostFilm(const solver::DipSetup& setup)
        : displacement_(setup.film.pointCount()), before_(setup.film.pointCount()),
          free_(setup.film.pointCount(), 1.f), columns_(columnsOf<Real>(setup.film)),
          rows_(rowsOf<Real>(setup.film)),
          model_(filmModel<Real>(setup, columns_.lines(), rows_.lines())), path_(setup.path),
          body_(contactBody<Real>(setup)),
          states_(setup.film.pointCount(), solver::PointState::Free),
          marks_(setup.film.pointCount(), 0), attached_(setup.film.pointCount()),
          clearance_(setup.film.pointCount(), Real(0)), laid_(std::size_t(triangleCount(model_))) {
        body_.path = pathView(path_);
        for (std::size_t point = 0; point < setup.pinned.size(); ++point) {
            free_[point] = setup.pinned[point] ? 0.f : 1.f;
        }
    }

    HostFilm(const HostFilm&) = delete; // the model points into the film's lines
    HostFilm& operator=(const HostFilm&) = delete;

    const FilmModel<Real>& model() const { return model_; }
    const ContactBody<Real>& body() const { return body_; }
    StepState<Real>& state() { return state_; }

    Vector2<Real> displacement(int point) const { return at(displacement_, point); }
    Vector2<Real> before(int point) const { return at(before_, point); }
    void setDisplacement(int point, Vector2<Real> way) { put(displacement_, point, way); }
    void setBefore(int point, Vector2<Real> way) { put(before_, point, way); }
    solver::PointState pointState(int point) const { return states_[std::size_t(point)]; }
    Vector3<Real> attached(int point) const { return attached_[std::size_t(point)]; }
    void attach(int point, Vector3<Real> place, solver::PointState state) {
        attached_[std::size_t(point)] = place;
        states_[std::size_t(point)] = state;
    }
    bool moves(int point) const { return free_[std::size_t(point)] > 0; }
    void hold(int point) { free_[std::size_t(point)] = 0; }
    void mark(int point, solver::PointMark why) { marks_[std::size_t(point)] |= std::uint8_t(why); }
    Real clearance(int point) const { return clearance_[std::size_t(point)]; }
    void setClearance(int point, Real clearance) { clearance_[std::size_t(point)] = clearance; }
    LaidCorners<Real>& laid(int triangle) { return laid_[std::size_t(triangle)]; }

    static void barrier() {}
    static Real least(Real value) { return value; }
    static bool anyOf(bool flag) { return flag; }
    template <typename Work>
    void forPoints(const Work& work) const {
        for (int point = 0; point < pointCount(model_); ++point) {
            work(point);
        }
    }

    template <typename Ask>
    bool anyPoint(const Ask& ask) const {
        bool any = false;
        forPoints([&](int point) { any = ask(point) || any; });
        return any;
    }
    template <typename Fold>
    Real leastOver(Real value, const Fold& fold) const {
        forPoints([&](int point) { value = fold(point, value); });
        return value;
    }

    // See solver::FilmSolver::read.
    void read(std::span<float> positions, std::span<solver::PointState> states) const {
        const BodyFrame<Real> frame = body_.frameAt(state_.descent);
        forPoints([&](int point) {
            const Vector3<Real> place =
                pointState(point) == solver::PointState::Free
                    ? planePosition(model_, std::uint32_t(point), displacement(point))
                    : frame.toWorld(attached(point));
            float* position = positions.data() + 3 * std::size_t(point);
            position[0] = float(place.x);
            position[1] = float(place.y);
            position[2] = float(place.z);
        });
        std::copy_n(states_.begin(), states.size(), states.begin());
    }

    // See solver::FilmSolver::readMarks.
    void readMarks(std::span<std::uint8_t> marks) const {
        std::copy_n(marks_.begin(), marks.size(), marks.begin());
    }

protected:
    Vector displacement_, before_; // displacement from rest: now, and one step ago
    std::vector<float> free_;      // 1 if the equilibrium moves the point, else 0

private:
    static Vector2<Real> at(const Vector& v, int point) {
        return {v.x[std::size_t(point)], v.z[std::size_t(point)]};
    }
    static void put(Vector& v, int point, Vector2<Real> way) {
        v.x[std::size_t(point)] = way.x;
        v.z[std::size_t(point)] = way.z;
    }

    FilmLineValues<Real> columns_, rows_;
    FilmModel<Real> model_;
    solver::BodyPath path_;
    ContactBody<Real> body_;
    StepState<Real> state_;
    std::vector<solver::PointState> states_;
    std::vector<std::uint8_t> marks_;     // solver::PointMark bits
    std::vector<Vector3<Real>> attached_; // place of an adhered point, body coordinates
    std::vector<Real> clearance_;
    std::vector<LaidCorners<Real>> laid_;
};

// Runs at most `maximumSteps` steps. See solver::FilmSolver::advance.
template <FilmBackend Film>
solver::DipState advance(Film& film, int maximumSteps) {
    for (int i = 0; i < maximumSteps && !isFinished(film); ++i) {
        step(film);
    }
    const StepState<typename Film::Real>& state = film.state();
    return {state.steps, state.descent, isFinished(film), state.equilibrium};
}

} // namespace dipwright::numerics
