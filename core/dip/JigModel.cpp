#include "dip/JigModel.h"

#include "base/Error.h"
#include "dip/Pose.h"

#include <QCoreApplication>
#include <QSet>
#include <algorithm>
#include <utility>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::JigModel)
};

constexpr std::size_t mostMaterials = 65536; // their index has 16 bits

TriangleMesh placedMesh(const JigPart& part) {
    const TriangleMesh& mesh = part.model->mesh;
    Eigen::Isometry3d transform = poseTransform(mesh, part.placed);
    transform.pretranslate(Eigen::Vector3d(part.placed.offset[0].value(), part.height.value(),
                                           part.placed.offset[1].value()));
    return transformed(mesh, transform);
}

// Appends a part and adds the number of points before it to its indices.
void append(TexturedMesh& jig, const JigPart& part, const TriangleMesh& placed) {
    const TexturedMesh& model = *part.model;
    const auto firstPosition = std::uint32_t(jig.mesh.positions.size());
    const auto firstMaterial = std::uint16_t(jig.materials.size());
    const int firstTexture = int(jig.textures.size());
    std::uint32_t firstChart = 0;
    for (const std::uint32_t chart : jig.chart) {
        firstChart = std::max(firstChart, chart + 1);
    }
    jig.mesh.positions.insert(jig.mesh.positions.end(), placed.positions.begin(),
                              placed.positions.end());
    for (std::array<std::uint32_t, 3> corners : placed.triangles) {
        for (std::uint32_t& corner : corners) {
            corner += firstPosition;
        }
        jig.mesh.triangles.push_back(corners);
    }
    jig.textureCoordinates.insert(jig.textureCoordinates.end(), model.textureCoordinates.begin(),
                                  model.textureCoordinates.end());
    for (const std::uint16_t material : model.material) {
        jig.material.push_back(std::uint16_t(firstMaterial + material));
    }
    for (const std::uint32_t chart : model.chart) {
        jig.chart.push_back(firstChart + chart);
    }
    for (Material material : model.materials) {
        material.name = QStringLiteral("%1: %2").arg(part.placed.name, material.name);
        material.texture += material.texture < 0 ? 0 : firstTexture;
        jig.materials.push_back(material);
    }
    if (!jig.inks.empty() || !model.inks.empty()) {
        jig.inks.resize(jig.textures.size());
        jig.inks.insert(jig.inks.end(), model.inks.begin(), model.inks.end());
        jig.inks.resize(jig.textures.size() + model.textures.size());
    }
    jig.textures.insert(jig.textures.end(), model.textures.begin(), model.textures.end());
}

void refuseOverlap(const std::vector<JigPart>& parts, const std::vector<BoundingBox>& boxes) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (!boxes[i].intersection(boxes[j]).isEmpty()) {
                throw Error(Text::tr("The bounding boxes of this part and of %1 overlap; move the "
                                     "parts apart on the jig")
                                .arg(parts[j].placed.name),
                            parts[i].placed.name);
            }
        }
    }
}

} // namespace

void numberEqualNames(std::vector<JigPart>& parts) {
    QSet<QString> taken, seen;
    for (const JigPart& part : parts) {
        taken.insert(part.placed.name);
    }
    for (JigPart& part : parts) {
        QString name = part.placed.name;
        for (int number = 2; seen.contains(part.placed.name) && taken.contains(name); ++number) {
            name = QStringLiteral("%1 %2").arg(part.placed.name).arg(number);
        }
        taken.insert(name);
        seen.insert(std::exchange(part.placed.name, name));
    }
}

TexturedMesh jigModel(std::vector<JigPart> parts) {
    numberEqualNames(parts);
    std::size_t materials = 0;
    for (const JigPart& part : parts) {
        materials += part.model->materials.size();
    }
    if (parts.empty() || materials > mostMaterials) {
        throw Error(
            Text::tr(
                "A jig needs at least one part, and its parts may have at most %1 materials in all")
                .arg(mostMaterials),
            QStringLiteral("jig"));
    }
    TexturedMesh jig;
    std::vector<BoundingBox> boxes;
    for (const JigPart& part : parts) {
        const TriangleMesh placed = placedMesh(part);
        boxes.push_back(boundingBox(placed));
        append(jig, part, placed);
    }
    refuseOverlap(parts, boxes);
    return jig;
}

} // namespace dipwright
