// Runs the production films on the GPU: the host's part.

#include "production/cuda/ProductionDips.h"

#include "common/SetupLimits.h"
#include "common/cuda/FieldUploads.h"
#include "production/cuda/CudaBackend.cuh"

#include <algorithm>
#include <cmath>
#include <deque>
#include <set>
#include <stdexcept>

namespace dipwright::cuda {

namespace {

constexpr int mostTilePoints = 34 * 34; // includes the points around the tile's own points

// Bytes of static shared memory, which the kernel uses besides its dynamic part.
constexpr std::size_t staticSharedBytes = sizeof(Block) + 256;

// Divides a grid so that `blocks` blocks finish as soon as possible. work(columns, rows) returns
// the number of points that a block processes for a tile of this size, or 0 if there are too many
// points.
template <typename Work>
PlaneTiles planeTiles(int columns, int rows, int blocks, const Work& work) {
    PlaneTiles best;
    for (int most = blocks;; most += blocks) {
        int least = 0;
        for (int across = 1; across <= std::min(columns, most); ++across) {
            const PlaneTiles tiles{across, std::min(rows, most / across)};
            const int points = work((columns + tiles.across - 1) / tiles.across,
                                    (rows + tiles.down - 1) / tiles.down);
            if (points > 0 && (least == 0 || points < least)) {
                best = tiles;
                least = points;
            }
        }
        if (least > 0) {
            return best;
        }
    }
}

PlaneTiles filmTiles(int columns, int rows, int blocks) {
    return planeTiles(columns, rows, blocks, [](int tileColumns, int tileRows) {
        const int points = (tileColumns + 2) * (tileRows + 2);
        return points <= mostTilePoints ? points : 0;
    });
}

// Divides a level into tiles of the coarser level.
PlaneTiles coarseTiles(const PlaneLevel& level, int blocks) {
    const auto fine = [](int points, int coarse) {
        return std::min(2 * coarse + 1 + 2 * numerics::galerkin::smoothingDegree, points);
    };
    return planeTiles(numerics::galerkin::coarser(level.columns),
                      numerics::galerkin::coarser(level.rows), blocks,
                      [&](int tileColumns, int tileRows) {
                          const int width = fine(level.columns, tileColumns);
                          const int height = fine(level.rows, tileRows);
                          return ManyPoints::cover(width, height) ? width * height : 0;
                      });
}

// Shared memory for the largest possible tile. Among patches with the same number of points, long
// and narrow patches need the most surrounding zeros.
constexpr std::size_t tileBytes =
    std::max({2 * std::size_t(PlanePatch::values(1, ManyPoints::mostInPatch)) * sizeof(float2),
              std::size_t(mostTilePoints) * (sizeof(float2) + sizeof(CellForces)),
              std::size_t(mostAssembledCells* detail::CellStiffness::blocks) * sizeof(float4)});

// The multigrid levels of one film.
class Levels {
public:
    Levels(const Device& device, ProductionModel& model, int blocks) {
        int columns = model.columns, rows = model.rows;
        std::uint32_t offset = 0;
        for (;;) {
            PlaneLevel& level = model.levels[model.levelCount++];
            level.columns = columns;
            level.rows = rows;
            level.offset = offset;
            offset += std::uint32_t(columns) * std::uint32_t(rows);
            if (numerics::galerkin::isCoarsest(columns, rows)) {
                break;
            }
            if (model.levelCount == ProductionModel::mostLevels) {
                throw std::invalid_argument("the film has too many points along one edge");
            }
            level.tiles = coarseTiles(level, blocks);
            columns = numerics::galerkin::coarser(columns);
            rows = numerics::galerkin::coarser(rows);
        }
        pointCount_ = offset;
        chooseWholeLevel(device, model);
    }

    std::size_t pointCount() const { return pointCount_; }
    std::size_t sharedBytes() const { return sharedBytes_; }

private:
    // Chooses `wholeLevel`: the first level that fits into one block together with all coarser
    // levels. Each thread then has only few points.
    void chooseWholeLevel(const Device& device, ProductionModel& model) {
        std::size_t bytes = 0;
        int level = model.levelCount;
        while (level > 0) {
            const PlaneLevel& finer = model.levels[level - 1];
            const std::size_t all =
                bytes +
                3 * std::size_t(PlanePatch::values(finer.columns, finer.rows)) * sizeof(float2);
            const bool isHeld = level == model.levelCount
                                    ? ManyPoints::cover(finer.columns, finer.rows)
                                    : FewPoints::cover(finer.columns, finer.rows);
            // On the way up, the tiles lie behind the levels in shared memory.
            if (!isHeld || all + tileBytes + staticSharedBytes > device.sharedBytes) {
                break;
            }
            bytes = all;
            --level;
        }
        if (level == model.levelCount) {
            throw std::invalid_argument(
                "the film is too long and narrow for the GPU; choose the CPU");
        }
        sharedBytes_ = bytes + tileBytes;
        model.wholeLevel = level;
    }

    std::size_t pointCount_ = 0, sharedBytes_ = 0;
};

// A film's columns or rows on the device.
class DeviceLines {
public:
    explicit DeviceLines(const numerics::FilmLineValues<float>& values)
        : places_(std::span<const double>(values.places)),
          edges_(std::span<const float>(values.edges)),
          spans_(std::span<const float>(values.spans)) {}

    numerics::FilmLines<float> lines() const {
        return {places_.data(), edges_.data(), spans_.data()};
    }

private:
    DeviceArray<double> places_;
    DeviceArray<float> edges_, spans_;
};

ProductionModel modelOf(const solver::DipSetup& setup, int blocks, const DeviceLines& columns,
                        const DeviceLines& rows) {
    ProductionModel model{numerics::filmModel<float>(setup, columns.lines(), rows.lines())};
    model.tiles = filmTiles(model.columns, model.rows, blocks);
    std::ranges::copy(numerics::galerkin::smoothingSteps, model.smoothing);
    std::ranges::copy(numerics::galerkin::coarsestSteps, model.coarsest);
    return model;
}

// Assigns the arrays of one dip to one block of device memory.
class Layout {
public:
    // If `start` is null, only the computed size is valid.
    explicit Layout(std::byte* start) : next_(start), start_(start) {}

    template <typename Value>
    void place(Value*& array, std::size_t count) {
        constexpr std::size_t alignment = 256;
        array = reinterpret_cast<Value*>(next_);
        next_ += (count * sizeof(Value) + alignment - 1) / alignment * alignment;
    }
    std::size_t bytes() const { return std::size_t(next_ - start_); }

private:
    std::byte *next_, *start_;
};

// Places all arrays of a dip from `start` on. Returns their total size in bytes.
std::size_t placeArrays(ProductionDip& dip, const solver::FilmGrid& film,
                        std::size_t pointsOfLevels, std::byte* start) {
    const std::size_t points = film.pointCount();
    const std::size_t triangles = 2 * std::size_t(film.columns - 1) * std::size_t(film.rows - 1);
    Layout layout(start);
    layout.place(dip.state, 1);
    layout.place(dip.displacement, points); // these three arrays form the stored film
    layout.place(dip.attached, points);
    layout.place(dip.states, points);
    for (float2** array : {&dip.before, &dip.start, &dip.best, &dip.forces, &dip.newtonStep}) {
        layout.place(*array, points);
    }
    for (float2*& array : dip.basis) {
        layout.place(array, points);
    }
    for (float2*& array : dip.smoothed) {
        layout.place(array, points);
    }
    layout.place(dip.free, points);
    layout.place(dip.masked, points);
    layout.place(dip.clearance, points);
    layout.place(dip.marks, points);
    layout.place(dip.inverseShape, triangles);
    layout.place(dip.stress, triangles);
    layout.place(dip.crosses, triangles);
    layout.place(dip.crossing, triangles);
    layout.place(dip.anchors, triangles);
    layout.place(dip.laid, triangles);
    layout.place(dip.stencils, std::size_t(neighbours) * pointsOfLevels);
    for (float2** array : {&dip.right, &dip.result, &dip.solution}) {
        layout.place(*array, pointsOfLevels);
    }
    return layout.bytes();
}

template <typename Value>
void upload(Value* to, const std::vector<Value>& values) {
    check(cudaMemcpy(to, values.data(), values.size() * sizeof(Value), cudaMemcpyHostToDevice));
}

// A path's poses in the memory of both sides.
struct DevicePath {
    explicit DevicePath(const solver::BodyPath& path)
        : onHost(path), onDevice(std::span<const solver::PathPose>(onHost.poses)) {}
    solver::BodyPath onHost;
    DeviceArray<solver::PathPose> onDevice;
};

// A film with the memory on the device that no array of ProductionDip holds.
struct HeldFilm {
    HeldFilm(const Device& device, const solver::DipSetup& setup, int blocks)
        : columns(numerics::columnsOf<float>(setup.film)),
          rows(numerics::rowsOf<float>(setup.film)), model(modelOf(setup, blocks, columns, rows)),
          levels(device, model, blocks), path(setup.path) {}

    DeviceLines columns, rows;
    ProductionModel model;
    Levels levels;
    DevicePath path;
};

class ProductionDips final : public Dips {
public:
    ProductionDips(const Device& device, Setups setups);

    void advance(int maximumSteps) override;
    solver::DipState state(std::size_t dip) const override;
    void readMarks(std::size_t dip, std::span<std::uint8_t> marks) const override;
    StoredFilm stored(std::size_t dip) const override;

private:
    void unpackPoints(std::size_t dip, const std::byte* stored, const solver::DipState& dipState,
                      std::span<float> positions,
                      std::span<solver::PointState> states) const override;
    void layFlat(const solver::DipSetup& setup, const ProductionDip& dip) const;

    int blocksPerFilm_;
    DeviceArray<TeamMemory> teams_; // of the films
    std::deque<HeldFilm> held_;     // in the order of films_
    FieldUploads fields_;
    DeviceArray<std::byte> memory_;
    std::vector<ProductionFilm> films_;
    DeviceArray<ProductionFilm> filmsOnDevice_;
    std::size_t sharedBytes_ = 0;
    std::vector<numerics::StepState<float>> states_;
};

// Checks all setups before anything is uploaded, and makes the device current.
void requireAllValid(const Device& device, Setups setups) {
    for (const solver::DipSetup* setup : setups) {
        numerics::requireValid(*setup);
    }
    use(device);
}

// Returns the number of blocks that work on a film together. Fewer blocks on more films at the same
// time are faster than more blocks on fewer films (docs/speed.md, "The production film").
int blocksPerFilm(const Device& device, std::size_t films) {
    return std::min(device.multiprocessors / int(films), TeamMemory::mostBlocks);
}

ProductionDips::ProductionDips(const Device& device, Setups setups)
    : Dips(device, setups),
      blocksPerFilm_((requireAllValid(device, setups), blocksPerFilm(device, setups.size()))),
      teams_(setups.size()), states_(setups.size()) {
    std::size_t bytes = 0;
    for (const solver::DipSetup* setup : setups) {
        const Levels& levels = held_.emplace_back(device, *setup, blocksPerFilm_).levels;
        ProductionDip sized;
        bytes += placeArrays(sized, setup->film, levels.pointCount(), nullptr);
        sharedBytes_ = std::max(sharedBytes_, levels.sharedBytes());
    }
    memory_ = DeviceArray<std::byte>(bytes);
    memory_.clear();
    std::byte* next = memory_.data();
    for (std::size_t number = 0; number < setups.size(); ++number) {
        const solver::DipSetup& setup = *setups[number];
        const HeldFilm& held = held_[number];
        ProductionDip dip;
        next += placeArrays(dip, setup.film, held.levels.pointCount(), next);
        dip.body = numerics::contactBody<float>(setup);
        dip.body.field.distance = fields_.onDevice(setup.field);
        dip.body.path.poses = held.path.onDevice.data();
        layFlat(setup, dip);
        films_.push_back({held.model, dip});
    }
    filmsOnDevice_ = DeviceArray<ProductionFilm>(std::span<const ProductionFilm>(films_));
    // The maximum for any film, because films of other threads use the same function.
    check(cudaFuncSetAttribute(reinterpret_cast<const void*>(productionSteps),
                               cudaFuncAttributeMaxDynamicSharedMemorySize,
                               int(device.sharedBytes - staticSharedBytes)));
}

void ProductionDips::layFlat(const solver::DipSetup& setup, const ProductionDip& dip) const {
    std::vector<float> free(setup.film.pointCount(), 1.0f);
    for (std::size_t point = 0; point < setup.pinned.size(); ++point) {
        free[point] = setup.pinned[point] ? 0.0f : 1.0f;
    }
    upload(dip.free, free);
    upload(dip.masked, free);
    const std::vector<float> alongX = numerics::columnsOf<float>(setup.film).edges;
    const std::vector<float> alongZ = numerics::rowsOf<float>(setup.film).edges;
    std::vector<float4> shapes;
    for (const float edgeZ : alongZ) {
        for (const float edgeX : alongX) {
            shapes.insert(shapes.end(), 2, float4{1 / edgeX, 0, 0, 1 / edgeZ});
        }
    }
    upload(dip.inverseShape, shapes);
    upload(dip.state, std::vector<numerics::StepState<float>>(1));
}

void ProductionDips::advance(int maximumSteps) {
    use(device());
    teams_.clear();
    const ProductionFilm* films = filmsOnDevice_.data();
    TeamMemory* teams = teams_.data();
    void* arguments[] = {&films, &teams, &blocksPerFilm_, &maximumSteps};
    check(cudaLaunchCooperativeKernel(reinterpret_cast<const void*>(productionSteps),
                                      dim3(unsigned(blocksPerFilm_) * unsigned(films_.size())),
                                      dim3(Team::threads), arguments, sharedBytes_, nullptr));
    for (std::size_t dip = 0; dip < films_.size(); ++dip) {
        check(cudaMemcpy(&states_[dip], films_[dip].dip.state, sizeof states_[dip],
                         cudaMemcpyDeviceToHost));
    }
}

solver::DipState ProductionDips::state(std::size_t dip) const {
    const numerics::StepState<float>& state = states_[dip];
    return {state.steps, state.descent, state.descent >= films_[dip].dip.body.motion.travel,
            state.equilibrium};
}

void ProductionDips::readMarks(std::size_t dip, std::span<std::uint8_t> marks) const {
    use(device());
    std::vector<unsigned> words(marks.size());
    check(cudaMemcpy(words.data(), films_[dip].dip.marks, words.size() * sizeof(unsigned),
                     cudaMemcpyDeviceToHost));
    std::ranges::transform(words, marks.begin(), [](unsigned word) { return std::uint8_t(word); });
}

StoredFilm ProductionDips::stored(std::size_t dip) const {
    const ProductionDip& own = films_[dip].dip;
    const auto* first = reinterpret_cast<const std::byte*>(own.displacement);
    const auto* last = reinterpret_cast<const std::byte*>(own.states + film(dip).pointCount());
    return {first, std::size_t(last - first)};
}

void ProductionDips::unpackPoints(std::size_t dip, const std::byte* stored,
                                  const solver::DipState& dipState, std::span<float> positions,
                                  std::span<solver::PointState> states) const {
    const ProductionDip& own = films_[dip].dip;
    const std::byte* first = this->stored(dip).onDevice;
    const auto inCopy = [&]<typename Value>(const Value* onDevice) {
        return reinterpret_cast<const Value*>(
            stored + (reinterpret_cast<const std::byte*>(onDevice) - first));
    };
    numerics::ContactBody<float> body = own.body;
    body.path = numerics::pathView(held_[dip].path.onHost); // the poses in the host's memory
    const float2* displacement = inCopy(own.displacement);
    const float3* attached = inCopy(own.attached);
    const std::uint8_t* held = inCopy(own.states);
    const auto frame = body.frameAt(dipState.descent);
    const solver::FilmGrid& grid = film(dip);
    const auto floating = [&](std::size_t point, float2 way) { // same as numerics::planePosition()
        const int row = int(point) / grid.columns, column = int(point) - row * grid.columns;
        return numerics::Vector3<float>{float(grid.restX(column)) + way.x, 0,
                                        float(grid.restZ(row)) + way.y};
    };
    for (std::size_t point = 0; point < grid.pointCount(); ++point) {
        const auto state = solver::PointState(held[point]);
        const numerics::Vector3<float> place =
            state == solver::PointState::Free
                ? floating(point, displacement[point])
                : frame.toWorld({attached[point].x, attached[point].y, attached[point].z});
        positions[3 * point] = place.x;
        positions[3 * point + 1] = place.y;
        positions[3 * point + 2] = place.z;
        if (!states.empty()) {
            states[point] = state;
        }
    }
}

} // namespace

std::unique_ptr<Dips> makeProductionDips(const Device& device, Setups setups) {
    return std::make_unique<ProductionDips>(device, setups);
}

std::size_t productionDipsAtOnce(const Device& device, Setups setups) {
    use(device);
    std::size_t free = 0, all = 0, used = 0, dips = 0;
    check(cudaMemGetInfo(&free, &all));
    std::set<const float*> fields;
    const std::size_t most = std::min(setups.size(), std::size_t(device.multiprocessors));
    for (; dips < most; ++dips) {
        const solver::DipSetup& setup = *setups[dips];
        ProductionDip sized;
        used += placeArrays(sized, setup.film, 2 * setup.film.pointCount(), nullptr);
        if (fields.insert(setup.field.distance).second) {
            used += FieldUploads::bytes(setup.field);
        }
        if (used > free / 2) {
            break;
        }
    }
    return std::max(dips, std::size_t(1));
}

} // namespace dipwright::cuda
