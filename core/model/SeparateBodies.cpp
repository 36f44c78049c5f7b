#include "model/SeparateBodies.h"

#include "base/NumberText.h"
#include "geometry/JoinedPositions.h"

#include <QCoreApplication>
#include <algorithm>
#include <map>
#include <numeric>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(SeparateBodies)
};

// Connected pieces of the surface, and the box of each.
struct Pieces {
    std::vector<std::uint32_t> ofTriangle;
    std::vector<BoundingBox> boxes;
};

Pieces connectedPieces(const TriangleMesh& mesh) {
    Pieces pieces;
    JoinedPositions joined(mesh);
    std::map<std::uint32_t, std::uint32_t> numbers;
    for (const auto& triangle : mesh.triangles) {
        const auto [known, isNew] =
            numbers.try_emplace(joined.pieceOf(triangle[0]), std::uint32_t(numbers.size()));
        pieces.ofTriangle.push_back(known->second);
        if (isNew) {
            pieces.boxes.emplace_back();
        }
        for (const std::uint32_t corner : triangle) {
            pieces.boxes[known->second].extend(mesh.positions[corner]);
        }
    }
    return pieces;
}

// Joins boxes that overlap, until none do. Returns for each box the index of the joined one.
std::vector<std::uint32_t> joinOverlapping(std::vector<BoundingBox>& boxes) {
    std::vector<std::uint32_t> joined(boxes.size());
    std::iota(joined.begin(), joined.end(), 0U);
    for (bool hasChanged = true; hasChanged;) {
        hasChanged = false;
        for (std::uint32_t i = 0; i < boxes.size(); ++i) {
            for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
                if (!boxes[i].intersection(boxes[j]).isEmpty()) {
                    boxes[i].extend(boxes[j]);
                    boxes[j].setEmpty();
                    std::ranges::replace(joined, j, i);
                    hasChanged = true;
                }
            }
        }
    }
    return joined;
}

// Returns the part's name in "PART: MATERIAL", else the material's name.
QString partOf(const QString& material) {
    const auto end = material.indexOf(QStringLiteral(": "));
    return end > 0 ? material.left(end) : material;
}

QString placeText(const BoundingBox& box) {
    const Eigen::Vector3f middle = box.center();
    const auto mm = [](float length) { return numberText(double(length), 1); };
    return Text::tr("The body at X %1, Y %2, Z %3 mm")
        .arg(mm(middle.x()), mm(middle.y()), mm(middle.z()));
}

// Returns the name of each body: of its part or only material, if no other body has that name.
QStringList namesOf(const TexturedMesh& model, const SeparateBodies& bodies,
                    const std::vector<BoundingBox>& boxes) {
    QStringList parts(qsizetype(boxes.size()));
    std::vector<bool> isMixed(boxes.size());
    for (std::size_t t = 0; t < bodies.ofTriangle.size(); ++t) {
        const std::uint32_t body = bodies.ofTriangle[t];
        const QString part = partOf(model.materials[model.material[t]].name);
        isMixed[body] = isMixed[body] || (!parts[body].isNull() && parts[body] != part);
        parts[body] = part.isNull() ? QStringLiteral("") : part;
    }
    QStringList names;
    for (std::size_t body = 0; body < boxes.size(); ++body) {
        const QString& part = parts[qsizetype(body)];
        names << (isMixed[body] || part.isEmpty() || parts.count(part) > 1 ? placeText(boxes[body])
                                                                           : part);
    }
    return names;
}

} // namespace

std::shared_ptr<const SeparateBodies> separateBodies(const TexturedMesh& model) {
    Pieces pieces = connectedPieces(model.mesh);
    if (pieces.boxes.size() < 2 || pieces.boxes.size() > mostSeparatePieces) {
        return nullptr;
    }
    const std::vector<std::uint32_t> joined = joinOverlapping(pieces.boxes);
    std::vector<std::uint32_t> bodyOf(joined.size());
    std::vector<BoundingBox> boxes;
    for (std::uint32_t piece = 0; piece < joined.size(); ++piece) {
        if (joined[piece] == piece) {
            bodyOf[piece] = std::uint32_t(boxes.size());
            boxes.push_back(pieces.boxes[piece]);
        } else {
            bodyOf[piece] = bodyOf[joined[piece]]; // the joined one comes first
        }
    }
    if (boxes.size() < 2) {
        return nullptr;
    }
    auto bodies = std::make_shared<SeparateBodies>();
    for (const std::uint32_t piece : pieces.ofTriangle) {
        bodies->ofTriangle.push_back(bodyOf[piece]);
    }
    bodies->names = namesOf(model, *bodies, boxes);
    return bodies;
}

} // namespace dipwright
