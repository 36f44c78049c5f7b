#include "model/NamedMaterials.h"

#include "geometry/SurfaceQuery.h"
#include "settings/SurfaceMark.h"

#include <QSet>

namespace dipwright {

std::vector<std::size_t> materialsNamed(const SurfaceAppearance& model, const QString& name) {
    std::vector<std::size_t> found;
    for (std::size_t material = 0; material < model.materials.size(); ++material) {
        if (model.materials[material].name == name) {
            found.push_back(material);
        }
    }
    return found;
}

QStringList materialNames(const SurfaceAppearance& model) {
    QStringList names;
    QSet<QString> known{QString()};
    for (const Material& material : model.materials) {
        if (!known.contains(material.name) && material.name.size() <= longestMaterialName) {
            known.insert(material.name);
            names.append(material.name);
        }
    }
    return names;
}

std::optional<Eigen::Vector3f> middleOfMaterial(const TexturedMesh& model, const QString& name) {
    std::vector<bool> isMeant(model.materials.size());
    for (const std::size_t material : materialsNamed(model, name)) {
        isMeant[material] = true;
    }
    TriangleMesh surface{model.mesh.positions, {}};
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double area = 0;
    for (std::size_t triangle = 0; triangle < model.mesh.triangles.size(); ++triangle) {
        if (isMeant[model.material[triangle]]) {
            const auto [a, b, c] = cornersOf(model.mesh, triangle);
            const double own = double((b - a).cross(c - a).norm());
            surface.triangles.push_back(model.mesh.triangles[triangle]);
            centre += own * ((a + b + c) / 3).cast<double>();
            area += own;
        }
    }
    if (!(area > 0)) {
        return std::nullopt;
    }
    const SurfaceQuery query(surface);
    return position(surface, query.closest((centre / area).cast<float>()).point);
}

} // namespace dipwright
