// The interface between the program and a film solver: plain C++, no Qt, no VTK.
//
// A solver simulates one film that floats on the water (the plane y = 0) while one rigid body moves
// down along −Y. Units are millimetres, seconds and radians, in a right-handed frame with Y up. The
// host owns the loop: it calls begin(), then advance() until `finished`, and may read the film
// between two calls. One solver object is used by one thread at a time; different objects are
// independent.
//
// Errors: every member may throw std::exception (std::runtime_error with a sentence for the user).
// The object can then only be destroyed or begun again.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace dipwright::solver {

// Increased whenever this folder changes in a way that breaks older modules.
inline constexpr int interfaceVersion = 3;

// Which constraints hold the film together.
enum class Lattice : std::uint8_t {
    Structural, // horizontal and vertical neighbours only (the paper)
    Isotropic,  // constant-strain triangles, two to a cell, plane stress, Poisson ratio 1/3
};

// What supports free film.
enum class Support : std::uint8_t {
    None,  // nothing: no water, no gravity (the paper)
    Water, // a free point stays on the plane y = 0
};

// Returns true for the production film, which floats on water and resists shear; false for the
// paper's film.
constexpr bool isProductionFilm(Lattice lattice, Support support) {
    return lattice == Lattice::Isotropic && support == Support::Water;
}

// How the distance constraints of one iteration are relaxed (structural lattice).
enum class Relaxation : std::uint8_t { Jacobi, GaussSeidel };

// The flat film before the dip: columns × rows points, columns along +X, rows along +Z, centred on
// the origin in the plane y = 0. Point (column i, row j) has index j·columns + i and rests at
// (restX(i), 0, restZ(j)). The lines need not be evenly spaced: a graded film is fine under the
// body and coarse towards its edges. Each cell is cut into two triangles. If i + j is even, the cut
// is the diagonal (i, j)–(i+1, j+1), otherwise (i+1, j)–(i, j+1).
struct FilmGrid {
    int columns = 0;
    int rows = 0;
    double width = 0; // mm along X, swell included
    double depth = 0; // mm along Z, swell included
    // Rest positions of all columns along X, mm, ascending from −width/2 to width/2. Empty: evenly
    // spaced.
    std::vector<double> columnPlaces = {};
    // Rest positions of all rows along Z, mm, ascending from −depth/2 to depth/2. Empty: evenly
    // spaced.
    std::vector<double> rowPlaces = {};

    bool operator==(const FilmGrid&) const = default;

    std::size_t pointCount() const { return std::size_t(columns) * std::size_t(rows); }
    bool isEven() const { return columnPlaces.empty() && rowPlaces.empty(); }
    // Returns the rest position of a column along X, mm.
    double restX(int column) const { return rest(columnPlaces, columns, width, column); }
    // Returns the rest position of a row along Z, mm.
    double restZ(int row) const { return rest(rowPlaces, rows, depth, row); }
    // Returns the distance from a column (not the last) to the next, mm: the width of the cells
    // between them.
    double spacingX(int column) const { return spacing(columnPlaces, columns, width, column); }
    // Returns the distance from a row (not the last) to the next, mm: the depth of the cells
    // between them.
    double spacingZ(int row) const { return spacing(rowPlaces, rows, depth, row); }
    // Smallest cell sizes, mm.
    double leastSpacingX() const { return leastSpacing(columnPlaces, columns, width); }
    double leastSpacingZ() const { return leastSpacing(rowPlaces, rows, depth); }
    double leastSpacing() const { return std::min(leastSpacingX(), leastSpacingZ()); }

private:
    using Places = std::vector<double>;
    static double rest(const Places& places, int count, double length, int line) {
        return places.empty() ? -length / 2 + line * (length / (count - 1))
                              : places[std::size_t(line)];
    }
    static double spacing(const Places& places, int count, double length, int line) {
        return places.empty() ? length / (count - 1)
                              : places[std::size_t(line) + 1] - places[std::size_t(line)];
    }
    static double leastSpacing(const Places& places, int count, double length) {
        double least = spacing(places, count, length, 0);
        for (int line = 1; line + 1 < int(places.size()); ++line) {
            least = std::min(least, spacing(places, count, length, line));
        }
        return least;
    }
};

// Signed distance to the body, sampled on a uniform grid in body coordinates; negative inside. The
// samples are not owned. They must stay valid until the solver is begun again or destroyed. Sample
// (i, j, k) is at origin + spacing·(i, j, k) and has index (k·ny + j)·nx + i. Values between
// samples are interpolated trilinearly.
struct FieldView {
    const float* distance = nullptr;
    std::array<int, 3> size{};
    std::array<double, 3> origin{};
    double spacing = 0;
};

// The body's motion into the water. A point q of the body (body coordinates, as in the field) has
// the world position rotation·q + start − (0, descent, 0). Here descent grows from 0 to `travel`.
struct BodyMotion {
    std::array<double, 9> rotation{1, 0, 0, 0, 1, 0, 0, 0, 1}; // row-major
    std::array<double, 3> start{};                             // mm
    double travel = 0;                                         // mm
    double speed = 5;                                          // mm/s
};

struct Settings {
    Lattice lattice = Lattice::Isotropic;
    Support support = Support::Water;
    double contactDistance = 0; // mm; a film point this close to the surface touches it
    // Time constant in seconds by which stress in the floating film decays: infinity = elastic, 0 =
    // viscous. Isotropic film on water only.
    double relaxationTime = 0;
    // The next four settings apply to a structural lattice or to film without support.
    double timeStep = 1.0 / 60; // s
    int iterations = 5;         // sweeps of the constraints in one step
    Relaxation relaxation = Relaxation::Jacobi;
    bool selfContact = false;
    // The next two settings apply to isotropic film on water. `contactTravel` is how far the
    // contact line moves in one step, in cells. A step has converged when its residual is below
    // `residual`. The residual is the remaining forces on the free points divided by the elastic
    // forces in the film. Both are root sums of squares.
    double contactTravel = 0.5;
    double residual = 1e-4;
    // The following laws apply to isotropic film on water only (docs/film-model.md, "Assumed
    // constants"). Film adheres to faces that turn upwards from the vertical by at most `overhang`
    // radians. The body releases film at faces that turn upwards by more. Film that the body
    // catches there (PointState::Trapped) is not painted and takes no part in the unfolding.
    double overhang = 0.35;
    // Range of angles before the overhang in which the grip fades, radians. Before that range the
    // grip is full.
    double gripFade = 5 * std::numbers::pi / 180;
    double tearStretch = 4; // length or area stretch above which film tears
    // Film gathers where its mean stretch (λ1 + λ2)/2 falls below this value, 2/3 … 1.
    double gatheringStretch = 0.8;
    // Floating film grows equally along X and Z: t seconds after the start of the dip, its rest
    // lengths are 1 + limit·(1 − exp(−rate·t/limit)) times the original ones. Adhered film stops
    // growing. The film does not grow if the rate or the limit is 0.
    double growthRate = 0;  // 1/s
    double growthLimit = 0; // share of the length
    int threads = 0;        // 0: all threads of the host

    bool operator==(const Settings&) const = default;
};

// Everything a dip needs. `pinned` is empty or has one byte for each point; non-zero means held at
// rest, as by a barrier.
struct DipSetup {
    FilmGrid film;
    FieldView field;
    BodyMotion motion;
    Settings settings;
    std::vector<std::uint8_t> pinned;
};

// How well the steps of a dip have converged so far. All zero for a film that does not seek
// equilibrium.
struct EquilibriumAccount {
    std::int64_t stepsWithout = 0;     // steps that ended with a residual above Settings::residual
    double worstForceLeft = 0;         // the largest residual of those steps
    std::int64_t linearIterations = 0; // iterations of the linear solver in all steps
};

// Progress of a dip.
struct DipState {
    std::int64_t steps = 0; // steps done so far
    double descent = 0;     // mm that the body has come down
    bool finished = false;  // descent has reached the travel
    EquilibriumAccount equilibrium = {};
};

// The state of one film point.
enum class PointState : std::uint8_t {
    Free = 0,
    Adhered = 1, // has touched the surface and moves with the body
    Trapped = 2, // caught by an overhanging face; carried along, not painted
};

// Bits that mark a film point whose place depends on an unmeasured law or on a lack of convergence.
// A point may have none or several; bits are never cleared during a dip.
enum class PointMark : std::uint8_t {
    Torn = 1,  // held because its film tore
    LetGo = 2, // its film was released at an overhang
    // The point did not converge, and was held or left with a residual above Settings::residual. Or
    // it was held because its film turned inside out.
    Unbalanced = 4,
};

constexpr bool has(std::uint8_t marks, PointMark mark) {
    return (marks & std::uint8_t(mark)) != 0;
}

class FilmSolver {
public:
    virtual ~FilmSolver() = default;

    // Lays the flat film under the body. Copies what it needs of `setup`, except the field's
    // samples.
    virtual void begin(const DipSetup& setup) = 0;

    // Advances by at most `maximumSteps` steps of the solver's own length.
    virtual DipState advance(int maximumSteps) = 0;

    // Reads the current world positions (x, y, z per point, film order) and states of all points.
    // `positions` holds 3·pointCount floats; `states` holds pointCount or is empty.
    virtual void read(std::span<float> positions, std::span<PointState> states) const = 0;

    // Reads the current PointMark bits of all points; `marks` holds pointCount.
    virtual void readMarks(std::span<std::uint8_t> marks) const {
        std::fill(marks.begin(), marks.end(), std::uint8_t(0));
    }

    // Reads the film for display, without delaying a device that computes in parallel with the
    // host. If it returns true, the arrays are filled as by read(), with the film at the end of a
    // step. `shown` is the film's current progress on entry and the progress of that step on
    // return. If it returns false, a transfer of the current film has begun or is not complete;
    // advance and call it again.
    virtual bool peek(std::span<float> positions, std::span<PointState> states, DipState& shown) {
        static_cast<void>(shown); // it is already the current progress
        read(positions, states);
        return true;
    }
};

// One dip of a batch: what to simulate, and the result.
struct BatchItem {
    DipSetup setup;
    std::vector<float> positions; // output: 3·pointCount, world frame at the end
    std::vector<PointState> states;
    std::vector<std::uint8_t> marks; // PointMark bits
    std::int64_t steps = 0;
    EquilibriumAccount equilibrium;

    // Fills in the result of a dip. read(positions, states, marks) must do the same as
    // FilmSolver::read and readMarks; the marks are zero before it.
    template <typename Read>
    void finish(const DipState& end, const Read& read) {
        positions.resize(3 * setup.film.pointCount());
        states.resize(setup.film.pointCount());
        marks.assign(setup.film.pointCount(), 0);
        steps = end.steps;
        equilibrium = end.equilibrium;
        read(std::span<float>(positions), std::span<PointState>(states),
             std::span<std::uint8_t>(marks));
    }
};

// The measured peak performance of a device. A simulation cannot exceed these rates.
struct Ceiling {
    double flopsPerSecond = 0; // single precision; a fused multiply-add counts as two
    double bytesPerSecond = 0; // read and written by a = b + s·c in arrays larger than every cache
};

// A module calls it between pieces of work. If it returns true, the module stops as soon as
// possible.
using CancelFunction = bool (*)(void* context);

// What a module gives the host. Owned by the module; lives while it is loaded.
class SolverModule {
public:
    virtual ~SolverModule() = default;

    // Returns nullptr if the solver can run here, else a sentence that says why not (no GPU, driver
    // too old …).
    virtual const char* unavailableReason() const = 0;
    // Returns the device's name for the user: "2 × AMD EPYC, AVX-512", "NVIDIA H200".
    virtual const char* device() const = 0;
    virtual std::unique_ptr<FilmSolver> create() const = 0;
    // Simulates all dips, several at a time where that is faster. Each result is the same as that
    // of a single dip. Returns false if cancelled.
    virtual bool runBatch(std::span<BatchItem> items, CancelFunction cancelled,
                          void* context) const = 0;
    // Measures the device with all available threads, in a few tenths of a second.
    virtual std::optional<Ceiling> measuredCeiling() const { return std::nullopt; }
};

} // namespace dipwright::solver

// A module exports exactly this symbol, with C linkage.
#if defined(_WIN32)
#define DIPWRIGHT_EXPORT __declspec(dllexport)
#else
#define DIPWRIGHT_EXPORT __attribute__((visibility("default")))
#endif
#define DIPWRIGHT_SOLVER_ENTRY "dipwrightSolverModule"
// Type of the entry point: takes the host's interface version and returns the module, or nullptr if
// it does not fit.
using DipwrightSolverEntry = const dipwright::solver::SolverModule*(int hostInterfaceVersion);
