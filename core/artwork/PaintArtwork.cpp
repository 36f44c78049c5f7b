#include "artwork/PaintArtwork.h"

#include "artwork/LayerPicture.h"
#include "artwork/LayerPlane.h"
#include "artwork/Unwrap.h"
#include "base/Budgets.h"
#include "base/Error.h"
#include "base/WideGamut.h"
#include "geometry/SurfaceQuery.h"
#include "model/NamedMaterials.h"
#include "parallel/ParallelFor.h"
#include "texture/SurfaceColours.h"

#include <QCoreApplication>

#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::PaintArtwork)
};

// Smallest size of a sheet pixel on the body, relative to its size on the sheet. On gathered film
// and oblique charts, sheet pixels may be smaller.
constexpr double texelShare = 0.7;

struct Layer {
    LayerPicture picture;
    LayerPlane plane;
    float opacity;
    std::vector<bool> isBare; // by the model's material: the layer does not show there; or empty

    Layer(const ArtworkLayer& layer, const TexturedMesh& model, const SurfaceQuery& query,
          double texel, bool wide)
        : picture(layer, texel, wide), plane(layer, model.mesh, query, picture.size()),
          opacity(float(layer.opacity)) {
        if (!layer.material.isEmpty()) {
            isBare.assign(model.materials.size(), true);
            for (const std::size_t material : materialsNamed(model, layer.material)) {
                isBare[material] = false;
            }
        }
    }

    // `material` is that of the place.
    CoveringLight at(const SurfacePoint& place, const Eigen::Vector3d& outward,
                     std::uint16_t material) const {
        CoveringLight light = CoveringLight::Zero();
        if (!isBare.empty() && isBare[material]) {
            return light;
        }
        for (const PlanePlace& flat : plane.at(place, outward)) {
            if (flat.share > 0) {
                light += flat.share * picture.at(flat.place, plane.isEndless());
            }
        }
        return opacity * light;
    }
};

bool isWide(const TexturedMesh& model, const Artwork& artwork) {
    const auto wide = [](const QImage& image) { return dipwright::isWide(image); };
    return (!artwork.base && std::any_of(model.textures.begin(), model.textures.end(), wide)) ||
           std::any_of(artwork.layers.begin(), artwork.layers.end(), [&](const auto& layer) {
               return layer.kind == LayerKind::Picture && wide(layer.picture.image);
           });
}

bool isShown(const ArtworkLayer& layer) {
    const bool showsNothing = layer.kind == LayerKind::Picture && layer.picture.image.isNull();
    return layer.visible && layer.opacity > 0 && !showsNothing;
}

// Returns the triangles at the middles of the decals, uppermost first.
std::vector<std::uint32_t> middlesOfDecals(const Artwork& artwork, const SurfaceQuery& query) {
    std::vector<std::uint32_t> triangles;
    for (auto layer = artwork.layers.rbegin(); layer != artwork.layers.rend(); ++layer) {
        if (isShown(*layer) && layer->placement == LayerPlacement::Decal) {
            const Eigen::Vector3d place(layer->place[0].value(), layer->place[1].value(),
                                        layer->place[2].value());
            triangles.push_back(query.closest(place.cast<float>()).point.triangle);
        }
    }
    return triangles;
}

// The colours below all layers.
class Ground {
public:
    Ground(const TexturedMesh& model, const Artwork& artwork, bool wide)
        : isModelWide_(
              std::any_of(model.textures.begin(), model.textures.end(), dipwright::isWide)),
          wide_(wide) {
        if (artwork.base) {
            base_ = linearColour(*artwork.base);
            base_ = wide ? wideLight(*base_) : *base_;
        } else {
            colours_ = std::make_unique<SurfaceColours>(model);
        }
    }

    // `steps` is the change of the corner weights per texel to the right and per texel down.
    LinearColour at(const SurfacePoint& place, const Eigen::Matrix<float, 3, 2>& steps) const {
        if (base_) {
            return *base_;
        }
        const LinearColour own = colours_->at(place, steps);
        return wide_ && !isModelWide_ ? wideLight(own) : own;
    }

private:
    bool isModelWide_, wide_;
    std::optional<LinearColour> base_;
    std::unique_ptr<const SurfaceColours> colours_;
};

// The weights of a triangle's corners as a linear function over its chart, in texels.
struct Weights {
    Eigen::Vector3f origin = Eigen::Vector3f::Constant(1.0f / 3);
    Eigen::Matrix<float, 3, 2> steps = Eigen::Matrix<float, 3, 2>::Zero();

    explicit Weights(const std::array<Eigen::Vector2f, 3>& corners) {
        const Eigen::Vector2d a = corners[0].cast<double>();
        const Eigen::Vector2d b = corners[1].cast<double>() - a, c = corners[2].cast<double>() - a;
        const double area = b.x() * c.y() - b.y() * c.x();
        if (area == 0) {
            return;
        }
        Eigen::Matrix<double, 3, 2> exact;
        exact.row(1) << c.y() / area, -c.x() / area;
        exact.row(2) << -b.y() / area, b.x() / area;
        exact.row(0) = -exact.row(1) - exact.row(2);
        steps = exact.cast<float>();
        origin = (Eigen::Vector3d(1, 0, 0) - exact * a).cast<float>();
    }

    // Returns the surface point at a texel. Texels beside the triangle give a nearby point in it.
    SurfacePoint at(std::uint32_t triangle, int column, int row) const {
        Eigen::Vector3f weights =
            origin + steps * Eigen::Vector2f(float(column) + 0.5f, float(row) + 0.5f);
        weights = weights.cwiseMax(0);
        return {triangle, weights / weights.sum()};
    }
};

// What to paint: the colours of the layers, or their coverage as black.
enum class Painted { Colour, Cover };

QImage bake(const TexturedMesh& model, const Unwrapping& charts, const Ground& ground,
            const std::vector<std::unique_ptr<const Layer>>& layers, bool wide, Painted painted,
            const Progress& progress) {
    QImage picture(charts.width, charts.height,
                   wide ? QImage::Format_RGBA64 : QImage::Format_RGBA8888);
    if (picture.isNull()) {
        throw Error(Text::tr("The artwork does not fit into this computer's memory; choose a lower "
                             "resolution of the sheet"),
                    QStringLiteral("%1 × %2").arg(charts.width).arg(charts.height));
    }
    if (wide) {
        picture.setColorSpace(wideSpace());
    }
    picture.fill(Qt::white);
    const PixelCode code(picture);
    unsigned char* bits = picture.bits();
    const auto stride = picture.bytesPerLine();
    parallelFor(0, charts.height, [&](int row) {
        progress.cancelToken.throwIfCancelled();
        std::uint32_t last = Unwrapping::nobody;
        std::optional<Weights> weights;
        Eigen::Vector3d outward = Eigen::Vector3d::Zero();
        for (int column = 0; column < charts.width; ++column) {
            const std::uint32_t triangle =
                charts.owner[std::size_t(row) * std::size_t(charts.width) + std::size_t(column)];
            if (triangle == Unwrapping::nobody) {
                continue;
            }
            if (triangle != last) {
                last = triangle;
                weights.emplace(charts.corners[triangle]);
                outward = triangleNormal(model.mesh, triangle).cast<double>();
            }
            const SurfacePoint place = weights->at(triangle, column, row);
            LinearColour colour = ground.at(place, weights->steps);
            for (const auto& layer : layers) {
                const CoveringLight over = layer->at(place, outward, model.material[triangle]);
                if (over[3] > 0) {
                    const LinearColour own(over[0], over[1], over[2]);
                    colour = (1 - over[3]) * colour +
                             (painted == Painted::Colour ? own : LinearColour(0, 0, 0));
                }
            }
            code.write(bits + row * stride + code.bytes() * column, colour, code.opaque());
        }
    });
    return picture;
}

SurfaceAppearance baked(const TexturedMesh& model, const Artwork& artwork, Painted painted,
                        double texel, const Progress& progress, qint64 mostTexels) {
    const QString step = Text::tr("Painting the artwork");
    progress(0, step);
    const qint64 most = budgetLimit(Budget::Pixels);
    const SurfaceQuery query(model.mesh);
    const Unwrapping charts =
        unwrapped(model.mesh, middlesOfDecals(artwork, query), texel,
                  mostTexels > 0 ? std::min(mostTexels, most) : most, progress);
    progress(0.3, step);
    const bool wide = isWide(model, artwork);
    std::vector<std::unique_ptr<const Layer>> layers;
    for (const ArtworkLayer& layer : artwork.layers) {
        if (isShown(layer)) {
            progress.cancelToken.throwIfCancelled();
            layers.push_back(
                std::make_unique<const Layer>(layer, model, query, charts.texel, wide));
        }
    }
    progress(0.5, step);
    SurfaceAppearance result;
    result.textures = {
        bake(model, charts, Ground(model, artwork, wide), layers, wide, painted, progress)};
    result.material = model.material;
    result.materials = model.materials;
    for (Material& material : result.materials) {
        material.texture = 0;
    }
    result.chart = charts.chart;
    result.textureCoordinates.reserve(charts.corners.size());
    for (const auto& corners : charts.corners) {
        auto& coordinates = result.textureCoordinates.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            coordinates[k] = {corners[k].x() / float(charts.width),
                              1 - corners[k].y() / float(charts.height)};
        }
    }
    progress(1, step);
    return result;
}

} // namespace

double texelFor(DotsPerInch resolution) {
    return texelShare / pixelsPerMillimetre(resolution);
}

TexturedMesh paintArtwork(const TexturedMesh& model, const Artwork& artwork, double texel,
                          const Progress& progress, qint64 mostTexels) {
    return {baked(model, artwork, Painted::Colour, texel, progress, mostTexels), model.mesh};
}

SurfaceAppearance paintSpot(const TexturedMesh& model, const Artwork& artwork, const QString& spot,
                            double texel, const Progress& progress) {
    return baked(model, artwork.inSpot(spot), Painted::Cover, texel, progress, 0);
}

std::shared_ptr<const TexturedMesh> painted(const std::shared_ptr<const TexturedMesh>& model,
                                            const Artwork& artwork, double texel,
                                            const Progress& progress, qint64 mostTexels) {
    return artwork.isEmpty() ? model
                             : std::make_shared<const TexturedMesh>(
                                   paintArtwork(*model, artwork, texel, progress, mostTexels));
}

} // namespace dipwright
