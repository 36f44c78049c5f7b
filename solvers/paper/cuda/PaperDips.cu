// Runs the paper's films on the GPU: the host's part.

#include "paper/cuda/PaperDips.h"

#include "common/SetupLimits.h"
#include "common/cuda/FieldUploads.h"
#include "paper/cuda/PaperStep.cuh"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace dipwright::cuda {

namespace {

using Kernel = void (*)(PaperModel, const PaperDip*, PaperWork, int, int);

// These take some milliseconds, so that the host can cancel soon.
constexpr int passesPerLaunch = 2048;
constexpr int stripRowsWithDiagonals = 2;

bool hasDiagonals(const solver::DipSetup& setup) {
    return setup.settings.lattice == solver::Lattice::Isotropic;
}

Kernel kernel(int stripRows, bool withDiagonals) {
    if (withDiagonals) {
        return paperPasses<stripRowsWithDiagonals, true>;
    }
    switch (stripRows) {
    case 1:
        return paperPasses<1, false>;
    case 2:
        return paperPasses<2, false>;
    default:
        return paperPasses<4, false>;
    }
}

std::size_t sharedBytes(int warps) {
    constexpr std::size_t rowsPerWarp = 4; // a warp's first and last row, double buffered
    return rowsPerWarp * std::size_t(warps) * PaperTiles::lanes * sizeof(paper::Position);
}

// Returns the factor on the sum of a point's corrections: 1 / the number of its constraints, or
// with diagonals 1 / their total stiffness (docs/film-model.md, "Lattice with diagonals").
float share(int alongX, int alongZ, bool withDiagonals) {
    if (!withDiagonals) {
        return 1 / float(alongX + alongZ);
    }
    const float edgeX = alongZ == 2 ? 1.0f : 0.5f, edgeZ = alongX == 2 ? 1.0f : 0.5f;
    return 1 / (edgeX * float(alongX) + edgeZ * float(alongZ) + 0.5f * float(alongX * alongZ));
}

PaperModel paperModel(const solver::DipSetup& setup, const PaperTiles& tiles) {
    const solver::FilmGrid& film = setup.film;
    const double x = film.spacingX(0), z = film.spacingZ(0);
    PaperModel model;
    model.columns = film.columns;
    model.rows = film.rows;
    model.width = film.width;
    model.depth = film.depth;
    model.spacingX = x;
    model.spacingZ = z;
    model.restX = float(x);
    model.restZ = float(z);
    model.restDiagonal = float(std::hypot(x, z));
    model.firstX = float(-film.width / 2);
    model.firstZ = float(-film.depth / 2);
    model.vertical = setup.settings.support == solver::Support::Water ? 0.0f : 1.0f;
    for (int alongX = 1; alongX <= 2; ++alongX) {
        for (int alongZ = 1; alongZ <= 2; ++alongZ) {
            model.share[alongX][alongZ] = share(alongX, alongZ, hasDiagonals(setup));
        }
    }
    model.stepLength = setup.motion.speed * setup.settings.timeStep;
    model.contactDistance = setup.settings.contactDistance;
    // Between two places, the trilinear φ of a distance field falls by at most their distance plus
    // the diagonal of a cell.
    model.clearanceMargin =
        float(model.contactDistance + 1.01 * std::numbers::sqrt3 * setup.field.spacing);
    model.noContactDistance = float(model.contactDistance + 0.001 * setup.field.spacing);
    model.iterations = setup.settings.iterations;
    model.passesPerStep = (model.iterations + tiles.reach - 1) / tiles.reach;
    model.tiles = tiles;
    return model;
}

// Returns the number of steps until the body has descended completely.
int stepsOf(const solver::DipSetup& setup, double stepLength) {
    const double steps = std::ceil(setup.motion.travel / stepLength - 1e-9);
    if (!(steps < 1e8)) {
        throw std::invalid_argument("the dip would take too many steps; choose a longer time step");
    }
    int count = int(steps);
    // The count above may have been rounded down.
    while (double(count) * stepLength < setup.motion.travel) {
        ++count;
    }
    return count;
}

void requireKnown(const solver::DipSetup& setup) {
    numerics::requireValid(setup);
    numerics::requireEven(setup.film);
    numerics::requireStraightDown(setup);
    numerics::requireNoGrowth(setup.settings);
    if (setup.settings.relaxation != solver::Relaxation::Jacobi || setup.settings.selfContact) {
        throw std::invalid_argument(
            "on the GPU, the paper's film uses Jacobi sweeps and has no self-contact; for "
            "Gauss-Seidel sweeps or self-contact choose the CPU");
    }
}

struct PaperTiling {
    PaperTiles tiles;
    bool allBlocksRunTogether = false;
};

// Returns how many blocks with these tiles fit on one multiprocessor.
int blocksAtOnce(const PaperTiles& tiles, bool withDiagonals) {
    const auto* function = reinterpret_cast<const void*>(kernel(tiles.stripRows, withDiagonals));
    const std::size_t shared = sharedBytes(tiles.warps);
    check(cudaFuncSetAttribute(function, cudaFuncAttributeMaxDynamicSharedMemorySize,
                               int(sharedBytes(PaperTiles::mostWarps))));
    int blocks = 0;
    check(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&blocks, function,
                                                        tiles.warps * PaperTiles::lanes, shared));
    return blocks;
}

// Chooses the tiles for `dips` films that run together. Strips with fewer rows make a sweep faster.
PaperTiling chooseTiling(const Device& device, const solver::DipSetup& setup, std::size_t dips) {
    const bool withDiagonals = hasDiagonals(setup);
    for (const int stripRows : {1, 2, 4}) {
        if (withDiagonals && stripRows != stripRowsWithDiagonals) {
            continue;
        }
        for (const int blocks : {1, 2}) {
            const int most = int(std::size_t(device.multiprocessors * blocks) / dips);
            const auto tiles = paperTiles(setup.film, setup.settings.iterations, stripRows, most);
            if (tiles && blocksAtOnce(*tiles, withDiagonals) >= blocks) {
                return {*tiles, true};
            }
        }
    }
    // The film is too large for the device, so its blocks run one after the other.
    std::optional<PaperTiles> tiles;
    for (int most = device.multiprocessors; !tiles; most *= 2) {
        tiles = paperTiles(setup.film, setup.settings.iterations, stripRowsWithDiagonals, most);
    }
    blocksAtOnce(*tiles, withDiagonals);
    return {*tiles, false};
}

// Returns whether one kernel can run both dips.
bool areAlike(const solver::DipSetup& a, const solver::DipSetup& b) {
    return a.film == b.film && a.settings == b.settings && a.motion.speed == b.motion.speed &&
           a.field.spacing == b.field.spacing;
}

class PaperDips final : public Dips {
public:
    PaperDips(const Device& device, Setups setups);

    void advance(int maximumSteps) override;
    solver::DipState state(std::size_t dip) const override;
    StoredFilm stored(std::size_t dip) const override;

private:
    void unpackPoints(std::size_t dip, const std::byte* stored, const solver::DipState& dipState,
                      std::span<float> positions,
                      std::span<solver::PointState> states) const override;
    void layFlat(Setups setups);
    void launch(int firstPass, int lastPass);
    std::size_t pointCount() const { return film(0).pointCount(); }

    PaperModel model_;
    bool allBlocksRunTogether_ = false;
    Kernel kernel_ = nullptr;
    FieldUploads fields_;
    DeviceArray<StoredPoint> points_; // four arrays of the film's points per dip
    std::vector<PaperDip> dips_;
    DeviceArray<PaperDip> dipsOnDevice_;
    int stepsDone_ = 0, mostSteps_ = 0;
};

PaperDips::PaperDips(const Device& device, Setups setups) : Dips(device, setups) {
    for (const solver::DipSetup* setup : setups) {
        requireKnown(*setup);
    }
    use(device);
    const PaperTiling tiling = chooseTiling(device, *setups.front(), setups.size());
    allBlocksRunTogether_ = tiling.allBlocksRunTogether;
    model_ = paperModel(*setups.front(), tiling.tiles);
    kernel_ = kernel(tiling.tiles.stripRows, hasDiagonals(*setups.front()));
    layFlat(setups);
}

void PaperDips::layFlat(Setups setups) {
    constexpr std::size_t filmsPerDip = 4;
    points_ = DeviceArray<StoredPoint>(filmsPerDip * pointCount() * setups.size());
    points_.clear();
    std::vector<StoredPoint> flat(pointCount());
    for (std::size_t i = 0; i < setups.size(); ++i) {
        const solver::DipSetup& setup = *setups[i];
        PaperDip dip;
        dip.field = numerics::fieldGrid<double>(setup.field);
        dip.singleField = numerics::fieldGrid<float>(setup.field);
        dip.field.distance = dip.singleField.distance = fields_.onDevice(setup.field);
        dip.frameAtStart = numerics::bodyFrame<double>(setup.motion, 0);
        dip.singleFrameAtStart = numerics::bodyFrame<float>(setup.motion, 0);
        dip.travel = setup.motion.travel;
        dip.steps = stepsOf(setup, model_.stepLength);
        dip.now = points_.data() + filmsPerDip * i * pointCount();
        dip.before = dip.now + pointCount();
        dip.halo[0] = dip.before + pointCount();
        dip.halo[1] = dip.halo[0] + pointCount();
        for (std::size_t point = 0; point < flat.size(); ++point) {
            const bool isPinned = !setup.pinned.empty() && setup.pinned[point] != 0;
            flat[point] = {0, 0, 0, unsigned(isPinned ? Hold::Pinned : Hold::Free)};
        }
        check(cudaMemcpy(dip.now, flat.data(), flat.size() * sizeof(StoredPoint),
                         cudaMemcpyHostToDevice));
        mostSteps_ = std::max(mostSteps_, dip.steps);
        dips_.push_back(dip);
    }
    dipsOnDevice_ = DeviceArray<PaperDip>(std::span<const PaperDip>(dips_));
}

void PaperDips::advance(int maximumSteps) {
    use(device());
    const int last = std::min(stepsDone_ + std::min(maximumSteps, mostSteps_), mostSteps_);
    const int stepsPerLaunch = std::max(1, passesPerLaunch / model_.passesPerStep);
    while (stepsDone_ < last) {
        const int steps = std::min(last - stepsDone_, stepsPerLaunch);
        launch(stepsDone_ * model_.passesPerStep, (stepsDone_ + steps) * model_.passesPerStep);
        stepsDone_ += steps;
    }
    check(cudaStreamSynchronize(nullptr));
}

void PaperDips::launch(int firstPass, int lastPass) {
    const auto blocks = unsigned(model_.tiles.count()) * unsigned(dips_.size());
    const PaperDip* dips = dipsOnDevice_.data();
    const auto run = [&](PaperWork work, int first, int last) {
        void* arguments[] = {&model_, &dips, &work, &first, &last};
        const auto* function = reinterpret_cast<const void*>(kernel_);
        const dim3 grid(blocks), block(unsigned(model_.tiles.warps * PaperTiles::lanes));
        const std::size_t shared = sharedBytes(model_.tiles.warps);
        check(work == PaperWork::All
                  ? cudaLaunchCooperativeKernel(function, grid, block, arguments, shared, nullptr)
                  : cudaLaunchKernel(function, grid, block, arguments, shared, nullptr));
    };
    if (allBlocksRunTogether_) {
        run(PaperWork::All, firstPass, lastPass);
        return;
    }
    for (int pass = firstPass; pass < lastPass; ++pass) {
        run(PaperWork::Send, pass, pass + 1);
        run(PaperWork::Sweep, pass, pass + 1);
    }
}

solver::DipState PaperDips::state(std::size_t dip) const {
    const PaperDip& own = dips_[dip];
    const int steps = std::min(stepsDone_, own.steps);
    const double descent = std::min(own.travel, double(steps) * model_.stepLength);
    return {steps, descent, steps == own.steps};
}

StoredFilm PaperDips::stored(std::size_t dip) const {
    return {reinterpret_cast<const std::byte*>(dips_[dip].now), pointCount() * sizeof(StoredPoint)};
}

void PaperDips::unpackPoints(std::size_t, const std::byte* stored, const solver::DipState& dipState,
                             std::span<float> positions,
                             std::span<solver::PointState> states) const {
    const std::span points(reinterpret_cast<const StoredPoint*>(stored), pointCount());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const StoredPoint& point = points[i];
        const bool isAdhered = point.hold() == Hold::Adhered;
        const double restX = film(0).restX(int(i % film(0).columns));
        const double restZ = film(0).restZ(int(i / film(0).columns));
        positions[3 * i] = float(restX + double(point.x));
        positions[3 * i + 1] = float(double(point.y) - (isAdhered ? dipState.descent : 0.0));
        positions[3 * i + 2] = float(restZ + double(point.z));
        if (!states.empty()) {
            states[i] = isAdhered ? solver::PointState::Adhered : solver::PointState::Free;
        }
    }
}

} // namespace

std::unique_ptr<Dips> makePaperDips(const Device& device, Setups setups) {
    return std::make_unique<PaperDips>(device, setups);
}

std::size_t paperDipsAtOnce(const Device& device, Setups setups) {
    use(device);
    std::size_t dips = 1;
    while (dips < setups.size() && areAlike(*setups.front(), *setups[dips]) &&
           chooseTiling(device, *setups.front(), dips + 1).allBlocksRunTogether) {
        ++dips;
    }
    return dips;
}

} // namespace dipwright::cuda
