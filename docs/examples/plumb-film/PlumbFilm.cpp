// A complete solver plugin, as small as one can be: a film that the body takes along straight down,
// without pull from its neighbours. Nothing but the solver interface is needed to build it.
#include <dipwright/FilmSolver.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace dipwright::solver;
using Vector = std::array<double, 3>;

constexpr double stepLength = 0.1; // mm of descent

// The body's distance at a place in body coordinates; trilinear, far outside the grid a large one.
double distanceAt(const FieldView& field, const Vector& place) {
    std::array<int, 3> cell{};
    Vector share{};
    for (int axis = 0; axis < 3; ++axis) {
        const double samples = (place[axis] - field.origin[axis]) / field.spacing;
        if (!(samples >= 0 && samples <= field.size[axis] - 1)) {
            return 1e9;
        }
        cell[axis] = std::min(int(samples), field.size[axis] - 2);
        share[axis] = samples - cell[axis];
    }
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1;
        std::size_t index = 0;
        for (int axis = 2; axis >= 0; --axis) {
            const int side = (corner >> axis) & 1;
            weight *= side ? share[axis] : 1 - share[axis];
            index = index * std::size_t(field.size[axis]) + std::size_t(cell[axis] + side);
        }
        sum += weight * field.distance[index];
    }
    return sum;
}

class PlumbFilm : public FilmSolver {
public:
    void begin(const DipSetup& setup) override {
        setup_ = setup;
        state_ = {};
        const FilmGrid& film = setup.film;
        touched_.assign(film.pointCount(), -1);
    }

    DipState advance(int maximumSteps) override {
        for (int step = 0; step < maximumSteps && !state_.finished; ++step) {
            state_.descent = std::min(state_.descent + stepLength, setup_.motion.travel);
            state_.finished = state_.descent >= setup_.motion.travel;
            ++state_.steps;
            for (std::size_t point = 0; point < touched_.size(); ++point) {
                if (touched_[point] < 0 && distanceAt(setup_.field, inBody(rest(point))) <=
                                               setup_.settings.contactDistance) {
                    touched_[point] = state_.descent;
                }
            }
        }
        return state_;
    }

    void read(std::span<float> positions, std::span<PointState> states) const override {
        for (std::size_t point = 0; point < touched_.size(); ++point) {
            Vector place = rest(point);
            const bool isTouched = touched_[point] >= 0;
            place[1] = isTouched ? touched_[point] - state_.descent : 0;
            std::copy(place.begin(), place.end(), positions.begin() + std::ptrdiff_t(3 * point));
            if (!states.empty()) {
                states[point] = isTouched ? PointState::Adhered : PointState::Free;
            }
        }
    }

private:
    Vector rest(std::size_t point) const {
        const FilmGrid& film = setup_.film;
        const auto columns = std::size_t(film.columns);
        return {film.restX(int(point % columns)), 0, film.restZ(int(point / columns))};
    }

    // From the world, where the film floats, to the body's own coordinates.
    Vector inBody(const Vector& world) const {
        const BodyMotion& motion = setup_.motion;
        Vector moved{};
        for (int axis = 0; axis < 3; ++axis) {
            moved[axis] = world[axis] - motion.start[axis];
        }
        moved[1] += state_.descent;
        Vector result{};
        for (int column = 0; column < 3; ++column) {
            for (int row = 0; row < 3; ++row) {
                result[column] += motion.rotation[3 * row + column] * moved[row];
            }
        }
        return result;
    }

    DipSetup setup_;
    DipState state_;
    std::vector<double> touched_; // the descent at which each point met the body; negative: not yet
};

class PlumbModule : public SolverModule {
public:
    const char* unavailableReason() const override { return nullptr; }
    const char* device() const override { return "CPU, one core"; }
    std::unique_ptr<FilmSolver> create() const override { return std::make_unique<PlumbFilm>(); }
    bool runBatch(std::span<BatchItem> items, CancelFunction cancelled,
                  void* context) const override {
        for (BatchItem& item : items) {
            PlumbFilm film;
            film.begin(item.setup);
            DipState state;
            while (!state.finished) {
                if (cancelled && cancelled(context)) {
                    return false;
                }
                state = film.advance(16);
            }
            item.finish(state, [&](auto positions, auto states, auto marks) {
                film.read(positions, states);
                film.readMarks(marks);
            });
        }
        return true;
    }
};

} // namespace

extern "C" DIPWRIGHT_EXPORT const SolverModule* dipwrightSolverModule(int hostInterfaceVersion) {
    static const PlumbModule module;
    return hostInterfaceVersion == interfaceVersion ? &module : nullptr;
}
