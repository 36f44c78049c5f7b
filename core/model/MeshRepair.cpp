#include "model/MeshRepair.h"

#include "geometry/SurfaceQuery.h"

#include <QHashFunctions>

#include <algorithm>
#include <bit>
#include <cstdint>

namespace dipwright {

namespace {

constexpr std::uint32_t unused = 0xffffffffu;

// Finds positions by their exact value: a hash table with open addressing, at most half full. Where
// in it they lie differs from run to run, so that no file can be made whose positions all meet in
// one place; what is found does not.
class PositionIndex {
public:
    explicit PositionIndex(const std::vector<Eigen::Vector3f>& positions)
        : positions_(positions), slots_(std::bit_ceil(2 * positions.size() + 1), unused) {}

    // The first position that was asked for and equals this one.
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
            // Adding zero makes −0 and 0, which are equal, the same bits.
            value = (value ^ std::bit_cast<std::uint32_t>(coordinate + 0.0F)) * 0x9e3779b97f4a7c15u;
            value ^= value >> 29;
        }
        return std::size_t(value);
    }

    const std::vector<Eigen::Vector3f>& positions_;
    std::vector<std::uint32_t> slots_;
    std::uint64_t seed_ = std::size_t(QHashSeed::globalSeed());
};

bool hasRepeatedCorner(const std::array<std::uint32_t, 3>& triangle) {
    return triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0];
}

TexturedMesh withoutTriangles(const TexturedMesh& mesh, const std::vector<bool>& removed) {
    TexturedMesh result;
    result.materials = mesh.materials;
    result.textures = mesh.textures;
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

// One connected piece of a mesh and which of its triangles run against its first one.
struct Piece {
    std::vector<std::uint32_t> triangles, against;
    bool isOrientable = true;
    bool isClosed = true;
};

// The piece that holds the triangle `first`. `sense` holds what is known of each triangle: 0
// unknown, 1 as its piece's first, −1 against it.
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

// Whether some fifty places spread over the piece lie inside the body of `query`.
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

} // namespace

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

std::size_t removeDegenerateTriangles(TexturedMesh& mesh) {
    const std::size_t count = mesh.mesh.triangles.size();
    std::vector<bool> collapsed(count);
    for (std::size_t t = 0; t < count; ++t) {
        collapsed[t] = hasRepeatedCorner(mesh.mesh.triangles[t]);
    }
    const std::size_t removed = remove(mesh, collapsed);

    std::vector<bool> flat(mesh.mesh.triangles.size());
    for (std::size_t t = 0; t < flat.size(); ++t) {
        flat[t] = triangleArea(mesh.mesh, t) == 0;
    }
    if (std::find(flat.begin(), flat.end(), true) == flat.end()) {
        return removed;
    }
    // A triangle squeezed to a line can be what joins its neighbours.
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

std::size_t turnInsideOutParts(TexturedMesh& mesh, const std::function<void()>& goOn) {
    const auto opposite = oppositeEdges(mesh.mesh);
    std::vector<std::int8_t> sense(mesh.mesh.triangles.size(), 0);
    std::vector<Piece> insideOut;
    TriangleMesh solid;
    for (std::uint32_t first = 0; first < sense.size(); ++first) {
        if (sense[first] != 0) {
            continue;
        }
        Piece piece = gatherPiece(mesh.mesh, opposite, first, sense);
        if (piece.isClosed && enclosedVolume(mesh.mesh, piece.triangles) < 0) {
            insideOut.push_back(std::move(piece));
            continue;
        }
        for (const std::uint32_t triangle : piece.triangles) {
            solid.triangles.push_back(mesh.mesh.triangles[triangle]);
        }
    }
    if (insideOut.empty()) {
        return 0;
    }
    solid.positions = mesh.mesh.positions;
    const SurfaceQuery query(solid);
    std::erase_if(insideOut,
                  [&](const Piece& piece) { return isInside(query, mesh.mesh, piece, goOn); });
    for (const Piece& piece : insideOut) {
        for (const std::uint32_t triangle : piece.triangles) {
            turn(mesh, triangle);
        }
    }
    return insideOut.size();
}

} // namespace dipwright
