// The interface between the program and a film solver: plain C++, no Qt, no VTK.
//
// A solver simulates one film that floats on the water (the plane y = 0) while one rigid body moves
// down along −Y. Millimetres, seconds, radians; right-handed frame, Y up. The host owns the loop:
// it calls begin(), then advance() until `finished`, and may read the film between two calls. One
// solver object is used by one thread at a time; different objects are independent.
//
// Errors: every member may throw std::exception (std::runtime_error with a sentence for the user);
// the object can then only be destroyed or begun anew.
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

// Raised whenever anything in this folder changes in a way that an older module would not survive.
inline constexpr int interfaceVersion = 3;

// Which constraints hold the film together.
enum class Lattice : std::uint8_t {
    Structural, // horizontal and vertical neighbours only (the paper)
    Isotropic,  // constant-strain triangles, two to a cell, plane stress, Poisson ratio 1/3
};

// What keeps free film up.
enum class Support : std::uint8_t {
    None,  // nothing: no water, no gravity (the paper)
    Water, // a free point stays on the plane y = 0
};

// Which of the two films this is: the production film, which floats on water and resists shear, or
// else the paper's.
constexpr bool isProductionFilm(Lattice lattice, Support support) {
    return lattice == Lattice::Isotropic && support == Support::Water;
}

// How the distance constraints of one iteration are relaxed (structural lattice).
enum class Relaxation : std::uint8_t { Jacobi, GaussSeidel };

// The flat film before the dip: columns × rows points, columns along +X, rows along +Z, centred on
// the origin in the plane y = 0. Point (column i, row j) has index j·columns + i and rests at
// (restX(i), 0, restZ(j)). The lines need not be evenly spaced: a graded film is fine under the
// body and coarse towards its edge. Each cell is cut into two triangles along the diagonal (i,
// j)–(i+1, j+1) where i + j is even and (i+1, j)–(i, j+1) where it is odd.
struct FilmGrid {
    int columns = 0;
    int rows = 0;
    double width = 0; // mm along X, swell included
    double depth = 0; // mm along Z, swell included
    // Where the columns rest along X and the rows along Z, mm: ascending, one each, the first at
    // −width/2 or −depth/2 and the last at width/2 or depth/2. Empty: evenly spaced.
    std::vector<double> columnPlaces = {};
    std::vector<double> rowPlaces = {};

    bool operator==(const FilmGrid&) const = default;

    std::size_t pointCount() const { return std::size_t(columns) * std::size_t(rows); }
    bool isEven() const { return columnPlaces.empty() && rowPlaces.empty(); }
    // Where the points of a column and of a row rest, mm.
    double restX(int column) const { return rest(columnPlaces, columns, width, column); }
    double restZ(int row) const { return rest(rowPlaces, rows, depth, row); }
    // mm from a column or row, that is not the last, to the next: the size of the cells between.
    double spacingX(int column) const { return spacing(columnPlaces, columns, width, column); }
    double spacingZ(int row) const { return spacing(rowPlaces, rows, depth, row); }
    // The finest cells' sides, mm.
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

// Signed distance of the body, sampled on a uniform grid in body coordinates; not owned, valid
// until the solver is begun anew or destroyed. Sample (i, j, k) is at origin + spacing·(i, j, k)
// and stands at index (k·ny + j)·nx + i. Negative inside. Between samples: trilinear.
struct FieldView {
    const float* distance = nullptr;
    std::array<int, 3> size{};
    std::array<double, 3> origin{};
    double spacing = 0;
};

// The body's way through the water. A point q of the body (body coordinates, those of the field) is
// in the world at  rotation·q + start − (0, descent, 0),  descent growing from 0 to `travel`.
struct BodyMotion {
    std::array<double, 9> rotation{1, 0, 0, 0, 1, 0, 0, 0, 1}; // row-major
    std::array<double, 3> start{};                             // mm
    double travel = 0;                                         // mm
    double speed = 5;                                          // mm/s
};

struct Settings {
    Lattice lattice = Lattice::Isotropic;
    Support support = Support::Water;
    double contactDistance = 0; // mm: a point at this distance from the surface touches it
    // Seconds in which stress in the floating film decays: infinity = elastic, 0 = viscous.
    // Isotropic film on water only.
    double relaxationTime = 0;
    // Structural lattice, or no support: the step in seconds and the sweeps of one step.
    double timeStep = 1.0 / 60;
    int iterations = 5;
    Relaxation relaxation = Relaxation::Jacobi;
    bool selfContact = false;
    // Isotropic film on water: the travel of the contact line in one step, in cells, and the
    // residual at which a step counts as in equilibrium: the forces left on the free points over
    // the elastic forces in the film, each the root of its sum of squares.
    double contactTravel = 0.5;
    double residual = 1e-4;
    // Laws of what film does, isotropic film on water only (docs/film-model.md, "Constants of
    // ours"). Film is laid on faces that turn upwards by no more than this, radians from the
    // vertical; ever less of it on the way there. Past it the film is let go of, and what the body
    // catches (PointState::Trapped) is neither painted nor pulled along.
    double overhang = 0.35;
    // Film is held fast up to so far before the overhang, radians; from there on the grip fades.
    double gripFade = 5 * std::numbers::pi / 180;
    double tearStretch = 4; // film tears past so many times its length or its area
    // Film pushed together to a mean stretch, (λ1 + λ2)/2, below this gathers; 2/3 … 1.
    double gatheringStretch = 0.8;
    // Film that floats grows alike along X and Z: t seconds after the dip began its rest shape is
    // 1 + limit·(1 − exp(−rate·t/limit)) times as long. What is laid grows no more. Rate in 1/s,
    // limit a share of its length; no growth where one of them is 0.
    double growthRate = 0;
    double growthLimit = 0;
    int threads = 0; // 0: all the host has

    bool operator==(const Settings&) const = default;
};

// Everything a dip needs. `pinned` has one byte a point (non-zero: held where it rests, as by a
// barrier) or is empty.
struct DipSetup {
    FilmGrid film;
    FieldView field;
    BodyMotion motion;
    Settings settings;
    std::vector<std::uint8_t> pinned;
};

// How well the steps of a dip so far have ended in equilibrium, of a film that seeks it; all zero
// of any other.
struct EquilibriumAccount {
    std::int64_t stepsWithout = 0;     // ended with more force left than Settings::residual
    double worstForceLeft = 0;         // of those: the most, over the elastic forces in the film
    std::int64_t linearIterations = 0; // of the linear solver, in all steps
};

// How far a dip has come.
struct DipState {
    std::int64_t steps = 0; // done so far
    double descent = 0;     // mm the body has come down
    bool finished = false;  // descent has reached the travel
    EquilibriumAccount equilibrium = {};
};

// What has become of one film point.
enum class PointState : std::uint8_t {
    Free = 0,
    Adhered = 1, // it has met the surface and moves with the body
    Trapped = 2, // caught by a face that it cannot hold to; carried along, not painted
};

// Bits that say of a film point that it lies where a law without measurement behind it, or a lack
// of equilibrium, has put it. A point may have none or several; they stay once they are set.
enum class PointMark : std::uint8_t {
    Torn = 1,  // held because its film tore
    LetGo = 2, // of film that was released at an overhang
    // Held, or left with more force than Settings::residual, for want of equilibrium; or held
    // because its film turned inside out.
    Unbalanced = 4,
};

constexpr bool has(std::uint8_t marks, PointMark mark) {
    return (marks & std::uint8_t(mark)) != 0;
}

class FilmSolver {
public:
    virtual ~FilmSolver() = default;

    // Lays the flat film under the body; copies what it needs of `setup` except the field's
    // samples.
    virtual void begin(const DipSetup& setup) = 0;

    // Advances by at most `maximumSteps` steps of the solver's own length.
    virtual DipState advance(int maximumSteps) = 0;

    // World positions (x, y, z per point, film order) and states of all points as they are now.
    // `positions` holds 3·pointCount floats, `states` pointCount or is empty.
    virtual void read(std::span<float> positions, std::span<PointState> states) const = 0;

    // The PointMark bits of all points as they are now; `marks` holds pointCount.
    virtual void readMarks(std::span<std::uint8_t> marks) const {
        std::fill(marks.begin(), marks.end(), std::uint8_t(0));
    }

    // The film for display, without holding up a device that computes beside the host. True: the
    // arrays are filled as by read(), with the film as it was after whole steps, and `shown`, on
    // entry the film's progress now, is its progress then. False: the film as it is now has begun
    // to come over, or has not arrived; advance and ask again.
    virtual bool peek(std::span<float> positions, std::span<PointState> states, DipState& shown) {
        static_cast<void>(shown); // is now
        read(positions, states);
        return true;
    }
};

// One dip of a batch: what to simulate and where its end goes.
struct BatchItem {
    DipSetup setup;
    std::vector<float> positions; // filled: 3·pointCount, world frame at the end
    std::vector<PointState> states;
    std::vector<std::uint8_t> marks; // PointMark bits
    std::int64_t steps = 0;
    EquilibriumAccount equilibrium;

    // Fills in the end of a dip. read(positions, states, marks) is to do as FilmSolver::read and
    // readMarks; the marks are none before it.
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

// What a device can do at most, measured: the roof that a film's rates stand under.
struct Ceiling {
    double flopsPerSecond = 0; // single precision; a fused multiply-add counts as two
    double bytesPerSecond = 0; // read and written by a = b + s·c in arrays past every cache
};

// Asked between pieces of work; true: stop as soon as possible.
using CancelFunction = bool (*)(void* context);

// What a module gives the host. Owned by the module, alive while it is loaded.
class SolverModule {
public:
    virtual ~SolverModule() = default;

    // nullptr when the solver can run here, else a sentence why not (no GPU, driver too old …).
    virtual const char* unavailableReason() const = 0;
    // The device in words: "2 × AMD EPYC, AVX-512", "NVIDIA H200".
    virtual const char* device() const = 0;
    virtual std::unique_ptr<FilmSolver> create() const = 0;
    // Simulates all dips, together where the device gains by it. Same results as one by one.
    // Returns false if cancelled.
    virtual bool runBatch(std::span<BatchItem> items, CancelFunction cancelled,
                          void* context) const = 0;
    // Measures the device, by all threads that may compute, in a few tenths of a second.
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
// Its type: given the interface version of the host, the module, or nullptr if it does not fit.
using DipwrightSolverEntry = const dipwright::solver::SolverModule*(int hostInterfaceVersion);
