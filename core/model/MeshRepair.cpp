#include "model/MeshRepair.h"

#include "geometry/JoinedPositions.h"
#include "geometry/SurfaceQuery.h"

#include <QCoreApplication>
#include <QMultiHash>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <span>
#include <tuple>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

constexpr std::uint32_t unused = 0xffffffffu;
// The largest gap that rounding leaves between the sides of a seam, relative to the model's longest
// edge. Files store six or seven digits.
constexpr double seamTolerance = 1e-5;

// Finds positions by their exact value, with a hash table with open addressing that is at most half
// full. The hash differs in every run, so that no file can make all its positions collide. The
// results do not depend on the hash.
class PositionIndex {
public:
    explicit PositionIndex(const std::vector<Eigen::Vector3f>& positions)
        : positions_(positions), slots_(std::bit_ceil(2 * positions.size() + 1), unused) {}

    // Returns the first position passed to this function that equals this one.
    std::uint32_t firstEqual(std::uint32_t position) {
        for (std::size_t slot = hash(positions_[position]);; ++slot) {
            std::uint32_t& found = slots_[slot & (slots_.size() - 1)];
            if (found == unused) {
                found = position;
            }
            if (positions_[found] == positions_[position]) {
                return found;
            }
        }
    }

private:
    std::size_t hash(const Eigen::Vector3f& position) const {
        std::uint64_t value = seed_;
        for (const float coordinate : position) {
            // −0 and 0 are equal. Adding zero gives both the same bits.
            value = (value ^ std::bit_cast<std::uint32_t>(coordinate + 0.0F)) * 0x9e3779b97f4a7c15u;
            value ^= value >> 29;
        }
        return std::size_t(value);
    }

    const std::vector<Eigen::Vector3f>& positions_;
    std::vector<std::uint32_t> slots_;
    std::uint64_t seed_ = std::size_t(QHashSeed::globalSeed());
};

struct Cell {
    qint64 x, y, z;
    bool operator==(const Cell&) const = default;
};

std::size_t qHash(const Cell& cell, std::size_t seed) {
    return qHashMulti(seed, cell.x, cell.y, cell.z);
}

// Finds positions within a given distance. Stored positions are farther apart than that, so that no
// file can put many into one cell.
class NearbyPositions {
public:
    NearbyPositions(const std::vector<Eigen::Vector3f>& positions, double reach)
        : positions_(positions), reach_(reach) {}

    // Returns the first stored position within the distance of this one; stores this one if there
    // is none.
    std::uint32_t firstNear(std::uint32_t position) {
        const Eigen::Vector3d place = positions_[position].cast<double>();
        const Eigen::Vector3d middle = (place / reach_).array().floor();
        const Cell cell{qint64(middle.x()), qint64(middle.y()), qint64(middle.z())};
        std::uint32_t first = position;
        for (qint64 x = cell.x - 1; x <= cell.x + 1; ++x) {
            for (qint64 y = cell.y - 1; y <= cell.y + 1; ++y) {
                for (qint64 z = cell.z - 1; z <= cell.z + 1; ++z) {
                    const auto [begin, end] = kept_.equal_range({x, y, z});
                    std::for_each(begin, end, [&](std::uint32_t other) {
                        const Eigen::Vector3d way = positions_[other].cast<double>() - place;
                        first = way.norm() <= reach_ ? std::min(first, other) : first;
                    });
                }
            }
        }
        if (first == position) {
            kept_.insert(cell, position);
        }
        return first;
    }

private:
    const std::vector<Eigen::Vector3f>& positions_;
    double reach_;
    QMultiHash<Cell, std::uint32_t> kept_;
};

// Returns which positions are on edges that do not lie between exactly two triangles.
std::vector<bool> positionsOnRims(const TriangleMesh& mesh) {
    std::vector<bool> isOnRim(mesh.positions.size());
    const auto opposite = oppositeEdges(mesh);
    for (std::uint32_t edge = 0; edge < opposite.size(); ++edge) {
        if (opposite[edge] == noEdge) {
            isOnRim[mesh.triangles[edge / 3][edge % 3]] = true;
            isOnRim[mesh.triangles[edge / 3][(edge + 1) % 3]] = true;
        }
    }
    return isOnRim;
}

bool hasRepeatedCorner(const std::array<std::uint32_t, 3>& triangle) {
    return triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0];
}

TexturedMesh withoutTriangles(const TexturedMesh& mesh, const std::vector<bool>& removed) {
    TexturedMesh result;
    result.materials = mesh.materials;
    result.textures = mesh.textures;
    result.inks = mesh.inks;
    result.mesh.positions = mesh.mesh.positions;
    for (std::size_t t = 0; t < removed.size(); ++t) {
        if (!removed[t]) {
            result.mesh.triangles.push_back(mesh.mesh.triangles[t]);
            result.textureCoordinates.push_back(mesh.textureCoordinates[t]);
            result.material.push_back(mesh.material[t]);
        }
    }
    return result;
}

std::size_t remove(TexturedMesh& mesh, const std::vector<bool>& removed) {
    const auto count = std::size_t(std::count(removed.begin(), removed.end(), true));
    if (count > 0) {
        mesh = withoutTriangles(mesh, removed);
    }
    return count;
}

void turn(TexturedMesh& mesh, std::size_t triangle) {
    std::swap(mesh.mesh.triangles[triangle][1], mesh.mesh.triangles[triangle][2]);
    std::swap(mesh.textureCoordinates[triangle][1], mesh.textureCoordinates[triangle][2]);
}

// A triangle identified by its corners, whatever their order.
struct CornerSet {
    std::array<std::uint32_t, 3> sorted;
    std::uint32_t triangle;
    bool isEven; // whether its corners are an even permutation of `sorted`
    bool operator<(const CornerSet& other) const {
        return std::tie(sorted, triangle) < std::tie(other.sorted, other.triangle);
    }
};

std::vector<CornerSet> sortedCorners(const TriangleMesh& mesh) {
    std::vector<CornerSet> sets;
    sets.reserve(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        auto sorted = mesh.triangles[t];
        std::rotate(sorted.begin(), std::min_element(sorted.begin(), sorted.end()), sorted.end());
        const bool isEven = sorted[1] < sorted[2];
        if (!isEven) {
            std::swap(sorted[1], sorted[2]);
        }
        sets.push_back({sorted, t, isEven});
    }
    std::sort(sets.begin(), sets.end());
    return sets;
}

// Calls `use` with each run of two or more triangles that have the same corners.
template <typename Use>
void forEachDoubled(const std::vector<CornerSet>& sets, const Use& use) {
    for (auto same = sets.begin(); same != sets.end();) {
        const auto next = std::find_if(
            same, sets.end(), [&](const CornerSet& set) { return set.sorted != same->sorted; });
        if (next - same > 1) {
            use(std::span(same, next));
        }
        same = next;
    }
}

// Returns for each position whether all triangles of its connected piece are in `chosen`.
std::vector<bool> areAllChosen(const TriangleMesh& mesh, const std::vector<bool>& chosen) {
    JoinedPositions joined(mesh);
    std::vector<bool> isMixed(mesh.positions.size()), areAll(mesh.positions.size());
    for (std::size_t t = 0; t < chosen.size(); ++t) {
        const std::uint32_t piece = joined.pieceOf(mesh.triangles[t][0]);
        isMixed[piece] = isMixed[piece] || !chosen[t];
    }
    for (std::uint32_t position = 0; position < areAll.size(); ++position) {
        areAll[position] = !isMixed[joined.pieceOf(position)];
    }
    return areAll;
}

// A connected piece of a mesh, and which of its triangles have the opposite orientation of its
// first one.
struct Piece {
    std::vector<std::uint32_t> triangles, against;
    bool isOrientable = true;
    bool isClosed = true;
};

// Returns the piece that contains the triangle `first`. `sense` holds for each triangle: 0 unknown,
// 1 oriented like the first triangle of its piece, −1 oppositely.
Piece gatherPiece(const TriangleMesh& mesh, const std::vector<std::uint32_t>& opposite,
                  std::uint32_t first, std::vector<std::int8_t>& sense) {
    Piece piece;
    piece.triangles.push_back(first);
    sense[first] = 1;
    for (std::size_t next = 0; next < piece.triangles.size(); ++next) {
        const std::uint32_t triangle = piece.triangles[next];
        if (sense[triangle] < 0) {
            piece.against.push_back(triangle);
        }
        for (std::uint32_t edge = 3 * triangle; edge < 3 * triangle + 3; ++edge) {
            if (opposite[edge] == noEdge) {
                piece.isClosed = false;
                continue;
            }
            const std::uint32_t other = opposite[edge] / 3;
            const bool sameDirection =
                mesh.triangles[triangle][edge % 3] == mesh.triangles[other][opposite[edge] % 3];
            const auto expected = std::int8_t(sameDirection ? -sense[triangle] : sense[triangle]);
            if (sense[other] == 0) {
                sense[other] = expected;
                piece.triangles.push_back(other);
            } else if (sense[other] != expected) {
                piece.isOrientable = false;
            }
        }
    }
    return piece;
}

double enclosedVolume(const TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles) {
    const auto corner = [&](std::uint32_t triangle, int i) -> Eigen::Vector3d {
        return mesh.positions[mesh.triangles[triangle][i]].cast<double>();
    };
    const Eigen::Vector3d origin = corner(triangles.front(), 0);
    double sixfold = 0;
    for (const std::uint32_t t : triangles) {
        const Eigen::Vector3d a = corner(t, 0) - origin, b = corner(t, 1) - origin;
        sixfold += a.dot(b.cross(corner(t, 2) - origin));
    }
    return sixfold / 6;
}

std::vector<Piece> piecesOf(const TriangleMesh& mesh) {
    const auto opposite = oppositeEdges(mesh);
    std::vector<std::int8_t> sense(mesh.triangles.size(), 0);
    std::vector<Piece> pieces;
    for (std::uint32_t first = 0; first < sense.size(); ++first) {
        if (sense[first] == 0) {
            pieces.push_back(gatherPiece(mesh, opposite, first, sense));
        }
    }
    return pieces;
}

// Whether a closed piece is inside out, as cavities are.
bool isHollow(const TriangleMesh& mesh, const Piece& piece) {
    return piece.isClosed && enclosedVolume(mesh, piece.triangles) < 0;
}

// Adds the triangles of a piece, without their positions.
void append(TriangleMesh& part, const TriangleMesh& mesh, const Piece& piece) {
    for (const std::uint32_t triangle : piece.triangles) {
        part.triangles.push_back(mesh.triangles[triangle]);
    }
}

// Whether about fifty places spread over the piece lie inside the body of `query`.
bool isInside(const SurfaceQuery& query, const TriangleMesh& mesh, const Piece& piece,
              const std::function<void()>& goOn) {
    const std::size_t step = 1 + piece.triangles.size() / 50;
    for (std::size_t i = 0; i < piece.triangles.size(); i += step) {
        goOn();
        if (!query.isInside(mesh.positions[mesh.triangles[piece.triangles[i]][0]])) {
            return false;
        }
    }
    return true;
}

// Returns the distance in mm below which two surfaces count as one. Rays start so far from a place,
// so that they miss the surface there.
float clearOf(const TriangleMesh& mesh) {
    return 1e-4F * boundingBox(mesh).diagonal().norm();
}

// Moves the mesh to the origin, so that rays lose no precision.
TriangleMesh centred(TriangleMesh mesh) {
    const BoundingBox box = boundingBox(mesh);
    const Eigen::Vector3d middle = (box.min().cast<double>() + box.max().cast<double>()) / 2;
    for (Eigen::Vector3f& position : mesh.positions) {
        position = (position.cast<double>() - middle).cast<float>();
    }
    return mesh;
}

// Whether a ray crosses an odd number of triangles. Triangles less than `clear` apart count as one.
bool isOdd(const SurfaceQuery& query, Eigen::Vector3f origin, const Eigen::Vector3f& direction,
           float clear) {
    bool odd = false;
    for (RayHit hit = query.hit(origin, direction); hit.point.isValid();
         hit = query.hit(origin, direction)) {
        odd = !odd;
        origin += (hit.distance + clear) * direction;
    }
    return odd;
}

// Casts rays to all sides from a place on a surface. Returns the share of rays on its back side
// that cross an odd number of triangles, minus the share on its front side.
double voteOfRays(const SurfaceQuery& query, const Eigen::Vector3f& place,
                  const Eigen::Vector3f& normal, float clear) {
    constexpr int rays = 32;
    constexpr float alongTheSurface = 0.15F;
    double odd[2] = {}, all[2] = {}; // front, back
    for (int ray = 0; ray < rays; ++ray) {
        // A spiral around the sphere, with steps of the golden angle.
        const double height = 1 - (2 * ray + 1) / double(rays), turn = 2.399963229728653 * ray;
        const double radius = std::sqrt(1 - height * height);
        const Eigen::Vector3f direction =
            Eigen::Vector3d(radius * std::cos(turn), radius * std::sin(turn), height).cast<float>();
        const float away = direction.dot(normal);
        if (std::abs(away) < alongTheSurface) {
            continue;
        }
        const bool isBack = away < 0;
        const Eigen::Vector3f origin = place + (isBack ? -clear : clear) * normal;
        all[isBack] += 1;
        odd[isBack] += isOdd(query, origin, direction, clear) ? 1 : 0;
    }
    return odd[1] / std::max(all[1], 1.0) - odd[0] / std::max(all[0], 1.0);
}

// Whether rays from `places` places on the piece show that it faces inwards.
bool facesInwards(const SurfaceQuery& query, const TriangleMesh& mesh, const Piece& piece,
                  std::size_t places, float clear, const std::function<void()>& goOn) {
    constexpr double decided = 0.5;
    const std::size_t step = 1 + (piece.triangles.size() - 1) / places;
    double votes = 0, area = 0;
    for (std::size_t i = 0; i < piece.triangles.size(); i += step) {
        goOn();
        const std::uint32_t triangle = piece.triangles[i];
        const double weight = triangleArea(mesh, triangle);
        votes += weight * voteOfRays(query, position(mesh, middleOf(triangle)),
                                     triangleNormal(mesh, triangle), clear);
        area += weight;
    }
    return votes < -decided * area;
}

// Returns the open pieces that are inside out. Above mostPlaces there are too many pieces to test
// separately, as in a surface of unconnected triangles; they are then tested as one.
std::vector<Piece> insideOutOf(std::vector<Piece> open, const TriangleMesh& mesh,
                               const std::function<void()>& goOn) {
    constexpr std::size_t mostPlaces = 20'000, placesOfPiece = 50;
    if (open.size() > mostPlaces) {
        Piece all;
        for (const Piece& piece : open) {
            all.triangles.insert(all.triangles.end(), piece.triangles.begin(),
                                 piece.triangles.end());
        }
        open.assign(1, std::move(all));
    }
    if (open.empty()) {
        return open;
    }
    const std::size_t places = std::min(mostPlaces / open.size(), placesOfPiece);
    const TriangleMesh body = centred(mesh);
    const SurfaceQuery query(body);
    const float clear = clearOf(body);
    std::erase_if(open, [&](const Piece& piece) {
        return !facesInwards(query, body, piece, places, clear, goOn);
    });
    return open;
}

using Pieces = std::vector<const Piece*>;

BoundingBox boxOf(const TriangleMesh& mesh, const Piece& piece) {
    BoundingBox box;
    for (const std::uint32_t triangle : piece.triangles) {
        for (const std::uint32_t corner : mesh.triangles[triangle]) {
            box.extend(mesh.positions[corner]);
        }
    }
    return box;
}

// Divides pieces into those whose bounding box lies in that of another, and the others.
std::pair<Pieces, Pieces> innerAndOuter(const TriangleMesh& mesh, const Pieces& pieces) {
    constexpr std::size_t mostPieces = 20'000; // each is compared with each
    if (pieces.size() > mostPieces) {
        return {{}, pieces};
    }
    std::vector<std::pair<BoundingBox, const Piece*>> boxes;
    for (const Piece* piece : pieces) {
        boxes.emplace_back(boxOf(mesh, *piece), piece);
    }
    std::ranges::stable_sort(boxes, std::greater(),
                             [](const auto& box) { return box.first.volume(); });
    Pieces inner, outer;
    std::vector<BoundingBox> outerBoxes;
    for (const auto& [box, piece] : boxes) {
        const bool isInner = std::ranges::any_of(
            outerBoxes, [&](const BoundingBox& other) { return other.contains(box); });
        (isInner ? inner : outer).push_back(piece);
        if (!isInner) {
            outerBoxes.push_back(box);
        }
    }
    return {inner, outer};
}

// Whether an edge of these triangles reaches the surface of `query`. Points less than `clear` mm
// from it count as on it.
bool reaches(const SurfaceQuery& query, const TriangleMesh& mesh,
             const std::vector<std::uint32_t>& triangles, float clear,
             const std::function<void()>& goOn) {
    return std::ranges::any_of(triangles, [&](std::uint32_t triangle) {
        goOn();
        const auto& corners = mesh.triangles[triangle];
        for (std::size_t i = 0; i < 3; ++i) {
            const Eigen::Vector3f &from = mesh.positions[corners[i]],
                                  &to = mesh.positions[corners[(i + 1) % 3]];
            if (query.isNear(from, clear) || query.isHit(from, to - from, 1)) {
                return true;
            }
        }
        return false;
    });
}

// A body and the search for places on its surface.
struct SearchedBody {
    TriangleMesh mesh;
    SurfaceQuery query;
};

SearchedBody searchedBody(const TriangleMesh& mesh, const Pieces& pieces) {
    TriangleMesh body; // with its own positions: a piece may be a small part of the mesh
    for (const Piece* piece : pieces) {
        for (const std::uint32_t triangle : piece->triangles) {
            const auto first = std::uint32_t(body.positions.size());
            body.triangles.push_back({first, first + 1, first + 2});
            for (const std::uint32_t corner : mesh.triangles[triangle]) {
                body.positions.push_back(mesh.positions[corner]);
            }
        }
    }
    SurfaceQuery query(body);
    return {std::move(body), std::move(query)};
}

// Whether a closed piece lies inside the body: one of its points is inside, and neither surface
// reaches the other.
bool isEnclosed(const SearchedBody& body, const TriangleMesh& mesh, const Piece& piece, float clear,
                const std::function<void()>& goOn) {
    if (!body.query.isInside(mesh.positions[mesh.triangles[piece.triangles[0]][0]]) ||
        reaches(body.query, mesh, piece.triangles, clear, goOn)) {
        return false;
    }
    const BoundingBox box = boxOf(mesh, piece);
    const std::vector<std::uint32_t> around =
        body.query.trianglesNear(box.center(), box.diagonal().norm() / 2);
    return around.empty() ||
           !reaches(searchedBody(mesh, {&piece}).query, body.mesh, around, clear, goOn);
}

// Marks the triangles of the pieces that lie inside the body of the solid pieces.
void markEnclosed(std::vector<bool>& marked, const TriangleMesh& mesh, const Pieces& pieces,
                  const Pieces& solid, const std::function<void()>& goOn) {
    if (pieces.empty() || solid.empty()) {
        return;
    }
    const SearchedBody body = searchedBody(mesh, solid);
    const float clear = clearOf(mesh);
    for (const Piece* piece : pieces) {
        const bool enclosed = isEnclosed(body, mesh, *piece, clear, goOn);
        for (const std::uint32_t triangle : piece->triangles) {
            marked[triangle] = enclosed;
        }
    }
}

} // namespace

QStringList sentencesOf(const ModelRepairs& repairs) {
    QStringList sentences;
    const auto add = [&](const QString& sentence, int count) {
        if (count > 0) {
            sentences.push_back(sentence.arg(count));
        }
    };
    add(Text::tr("Points merged where rounded coordinates had left a gap: %1"),
        repairs.joinedPoints);
    add(Text::tr("Triangles without area that were removed: %1"), repairs.removedTriangles);
    add(Text::tr("Duplicate triangles that were removed: %1"), repairs.mergedTriangles);
    add(Text::tr("Triangles flipped to face the same way as their neighbours: %1"),
        repairs.turnedTriangles);
    add(Text::tr("Pieces of the surface flipped because they were inside out: %1"),
        repairs.turnedParts);
    add(Text::tr("Triangles inside the body that were removed: %1"), repairs.enclosedTriangles);
    return sentences;
}

void weldPositions(TriangleMesh& mesh) {
    PositionIndex index(mesh.positions);
    std::vector<std::uint32_t> welded(mesh.positions.size(), unused);
    std::vector<Eigen::Vector3f> positions;
    for (auto& triangle : mesh.triangles) {
        for (auto& corner : triangle) {
            std::uint32_t& position = welded[index.firstEqual(corner)];
            if (position == unused) {
                position = std::uint32_t(positions.size());
                positions.push_back(mesh.positions[corner]);
            }
            corner = position;
        }
    }
    mesh.positions = std::move(positions);
}

std::size_t joinOpenSeams(TriangleMesh& mesh) {
    const double reach = seamTolerance * longestEdgeOf(mesh);
    if (!(reach > 0)) {
        return 0;
    }
    const std::vector<bool> isOnRim = positionsOnRims(mesh);
    NearbyPositions nearby(mesh.positions, reach);
    std::vector<std::uint32_t> joined(mesh.positions.size());
    std::iota(joined.begin(), joined.end(), 0U);
    std::size_t count = 0;
    for (std::uint32_t position = 0; position < joined.size(); ++position) {
        if (isOnRim[position]) {
            joined[position] = nearby.firstNear(position);
            count += joined[position] != position;
        }
    }
    if (count > 0) {
        for (auto& triangle : mesh.triangles) {
            for (auto& corner : triangle) {
                corner = joined[corner];
            }
        }
        weldPositions(mesh);
    }
    return count;
}

std::size_t mergeDoubledTriangles(TexturedMesh& mesh) {
    const std::vector<CornerSet> sets = sortedCorners(mesh.mesh);
    std::vector<bool> removed(mesh.mesh.triangles.size()), bothWays(removed.size());
    forEachDoubled(sets, [&](std::span<const CornerSet> doubled) {
        const auto even = std::count_if(doubled.begin(), doubled.end(),
                                        [](const CornerSet& set) { return set.isEven; });
        const auto odd = std::ssize(doubled) - even;
        const auto kept = std::find_if(doubled.begin(), doubled.end(), [&](const CornerSet& set) {
            return even == odd || set.isEven == (even > odd);
        });
        for (const CornerSet& set : doubled) {
            removed[set.triangle] = &set != &*kept;
            bothWays[set.triangle] = even == odd;
        }
    });
    if (std::find(bothWays.begin(), bothWays.end(), true) != bothWays.end()) {
        const std::vector<bool> isGivenFromBothSides = areAllChosen(mesh.mesh, bothWays);
        for (std::size_t t = 0; t < removed.size(); ++t) {
            removed[t] =
                removed[t] && (!bothWays[t] || isGivenFromBothSides[mesh.mesh.triangles[t][0]]);
        }
    }
    return remove(mesh, removed);
}

std::size_t removeCollapsedTriangles(TexturedMesh& mesh) {
    std::vector<bool> collapsed(mesh.mesh.triangles.size());
    for (std::size_t t = 0; t < collapsed.size(); ++t) {
        collapsed[t] = hasRepeatedCorner(mesh.mesh.triangles[t]);
    }
    const std::size_t removed = remove(mesh, collapsed);
    if (removed > 0) {
        weldPositions(mesh.mesh);
    }
    return removed;
}

std::size_t removeDegenerateTriangles(TexturedMesh& mesh) {
    const std::size_t removed = removeCollapsedTriangles(mesh);
    std::vector<bool> flat(mesh.mesh.triangles.size());
    for (std::size_t t = 0; t < flat.size(); ++t) {
        flat[t] = triangleArea(mesh.mesh, t) == 0;
    }
    if (std::find(flat.begin(), flat.end(), true) == flat.end()) {
        return removed;
    }
    // A degenerate triangle may be the only connection between its neighbours.
    const TexturedMesh without = withoutTriangles(mesh, flat);
    if (isClosed(mesh.mesh) && !isClosed(without.mesh)) {
        return removed;
    }
    return removed + remove(mesh, flat);
}

std::size_t orientTriangles(TexturedMesh& mesh) {
    const auto opposite = oppositeEdges(mesh.mesh);
    std::vector<std::int8_t> sense(mesh.mesh.triangles.size(), 0);
    std::vector<std::uint32_t> toTurn;
    for (std::uint32_t first = 0; first < sense.size(); ++first) {
        if (sense[first] != 0) {
            continue;
        }
        const Piece piece = gatherPiece(mesh.mesh, opposite, first, sense);
        if (!piece.isOrientable) {
            continue;
        }
        const bool turnTheRest = 2 * piece.against.size() > piece.triangles.size();
        for (const std::uint32_t triangle : piece.triangles) {
            if ((sense[triangle] < 0) != turnTheRest) {
                toTurn.push_back(triangle);
            }
        }
    }
    for (const std::uint32_t triangle : toTurn) {
        turn(mesh, triangle);
    }
    return toTurn.size();
}

std::size_t flipInsideOutParts(TexturedMesh& mesh, const std::function<void()>& goOn) {
    std::vector<Piece> insideOut, open;
    TriangleMesh solid;
    for (Piece& piece : piecesOf(mesh.mesh)) {
        if (isHollow(mesh.mesh, piece)) {
            insideOut.push_back(std::move(piece));
            continue;
        }
        append(solid, mesh.mesh, piece);
        if (!piece.isClosed && piece.isOrientable) {
            open.push_back(std::move(piece));
        }
    }
    if (!insideOut.empty()) {
        solid.positions = mesh.mesh.positions;
        const SurfaceQuery query(solid);
        std::erase_if(insideOut,
                      [&](const Piece& piece) { return isInside(query, mesh.mesh, piece, goOn); });
    }
    std::ranges::move(insideOutOf(std::move(open), mesh.mesh, goOn), std::back_inserter(insideOut));
    for (const Piece& piece : insideOut) {
        for (const std::uint32_t triangle : piece.triangles) {
            turn(mesh, triangle);
        }
    }
    return insideOut.size();
}

std::size_t removeEnclosedParts(TexturedMesh& mesh, const std::function<void()>& goOn) {
    const std::vector<Piece> pieces = piecesOf(mesh.mesh);
    if (!std::ranges::all_of(pieces, &Piece::isClosed)) {
        return 0;
    }
    Pieces hollow, solid;
    for (const Piece& piece : pieces) {
        (isHollow(mesh.mesh, piece) ? hollow : solid).push_back(&piece);
    }
    const auto [inner, outer] = innerAndOuter(mesh.mesh, solid);
    std::vector<bool> removed(mesh.mesh.triangles.size());
    markEnclosed(removed, mesh.mesh, hollow, solid, goOn);
    markEnclosed(removed, mesh.mesh, inner, outer, goOn);
    const std::size_t count = remove(mesh, removed);
    weldPositions(mesh.mesh);
    return count;
}

} // namespace dipwright
