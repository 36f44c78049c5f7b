#include "artwork/EditArtwork.h"

#include "artwork/LayerPicture.h"
#include "artwork/LayerPlane.h"
#include "base/ColourNote.h"
#include "base/Error.h"
#include "base/NumberText.h"
#include "geometry/SurfacePieces.h"
#include "geometry/SurfaceQuery.h"
#include "model/NamedMaterials.h"

#include <QCoreApplication>
#include <QFontDatabase>
#include <QGlyphRun>
#include <QRawFont>
#include <QTextBoundaryFinder>
#include <QTextLayout>

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Artwork)
};

// Tells whether a glyph run is drawn as boxes: no installed font has the glyph, or none can shape
// the script. In the second case, Qt's own font of boxes has the same glyph for all characters.
bool isOfBoxes(const QGlyphRun& run) {
    const QList<quint32> two = run.rawFont().glyphIndexesForString(QStringLiteral("AB"));
    return run.glyphIndexes().contains(0) || (two.value(0) != 0 && two.value(0) == two.value(1));
}

// Tells whether no installed font has a glyph for a character and its combining marks.
bool isMissing(const QString& character, const QFont& font) {
    QTextLayout layout(character, font);
    layout.beginLayout();
    layout.createLine();
    layout.endLayout();
    const QList<QGlyphRun> runs = layout.glyphRuns();
    return std::any_of(runs.begin(), runs.end(), isOfBoxes);
}

// Returns the characters of a text that no installed font has, each once.
QString missingCharacters(const QString& text, const QFont& font) {
    QString missing;
    QTextBoundaryFinder finder(QTextBoundaryFinder::Grapheme, text);
    for (qsizetype begin = 0, end = 0; (end = finder.toNextBoundary()) >= 0; begin = end) {
        const QString character = text.mid(begin, end - begin);
        if (!missing.contains(character) && !character.trimmed().isEmpty() &&
            isMissing(character, font)) {
            missing += character;
        }
    }
    return missing;
}

bool isDecal(const ArtworkLayer& layer) {
    return layer.visible && layer.opacity > 0 && layer.placement == LayerPlacement::Decal;
}

std::size_t pieceCount(const TriangleMesh& mesh) {
    const auto all = [](std::uint32_t) { return true; };
    return surfacePieces(mesh, oppositeEdges(mesh), all, 0).size();
}

// Returns a warning if a layer around an axis is longer than a turn; otherwise an empty string.
QString longerThanATurn(const ArtworkLayer& layer, const TriangleMesh& mesh) {
    constexpr double hidden = 1.001; // rounding does not count
    const double length = shownSize(layer)[0].value(), turn = lengthAround(layer, mesh);
    if (layer.repeat.value() > 0 || length <= hidden * turn) {
        return {};
    }
    return Text::tr("The layer “%1” is %2 mm long, but a turn around its axis is "
                    "only %3 mm, so its sides are cut off; make it smaller")
        .arg(layer.name, numberText(length, 1), numberText(turn, 1));
}

// Returns a warning if another body of the model covers a part of a decal; otherwise an empty
// string.
QString coveredByAnotherBody(const ArtworkLayer& layer, const TriangleMesh& mesh,
                             const SurfaceQuery& query) {
    constexpr double leastShare = 0.005;
    const auto shown = shownSize(layer);
    const Eigen::Vector2d size(shown[0].value(), shown[1].value());
    const double lost = LayerPlane(layer, mesh, query, size).coveredShare(size);
    if (lost < leastShare) {
        return {};
    }
    return Text::tr("The layer “%1” ends where another body of the model covers the surface, so "
                    "about %2 % of it is missing; join the bodies in a modelling program, or place "
                    "the layer along an axis")
        .arg(layer.name, numberText(100 * lost, 0));
}

} // namespace

ArtworkLayer newLayer(LayerKind kind, const QString& name) {
    ArtworkLayer layer;
    layer.kind = kind;
    layer.name = name.left(longestLayerName);
    if (!isPattern(kind)) {
        return layer;
    }
    layer.placement = LayerPlacement::Box;
    const auto show = [&layer](const QColor& dark, const QColor& light, double repeat) {
        layer.colour = dark;
        layer.secondColour = light;
        layer.repeat = Millimetres(repeat);
    };
    if (kind == LayerKind::Carbon) {
        show(QColor(18, 19, 22), QColor(112, 116, 124), 8);
    } else if (kind == LayerKind::Camouflage) {
        show(QColor(44, 46, 34), QColor(178, 164, 120), 120);
    } else {
        show(QColor(96, 56, 28), QColor(196, 146, 92), 60);
    }
    return layer;
}

ArtworkLayer placedOn(const TexturedMesh& model, ArtworkLayer layer) {
    constexpr double share = 0.4; // size as a share of the body's longest side
    const BoundingBox box = boundingBox(model.mesh);
    Eigen::Vector3f place = box.center();
    if (layer.placement == LayerPlacement::Decal) {
        const SurfaceQuery query(model.mesh);
        const Eigen::Vector3f before(place.x(), place.y(), box.max().z() + 1);
        const RayHit hit = query.hit(before, -Eigen::Vector3f::UnitZ());
        place = position(model.mesh, hit.point.isValid() ? hit.point : query.closest(before).point);
    }
    for (int axis = 0; axis < 3; ++axis) {
        layer.place[std::size_t(axis)] =
            Millimetres(std::round(double(place[axis]) * 100) / 100 + 0.0);
    }
    const double most = share * double(box.sizes().maxCoeff());
    for (Millimetres& side : layer.size) {
        side = Millimetres(std::clamp(std::round(std::min(side.value(), most) * 10) / 10,
                                      smallestLayer, largestLayer));
    }
    return layer;
}

ArtworkLayer replacedAs(LayerPlacement placement, const TexturedMesh& model, ArtworkLayer layer) {
    const auto isRound = [](LayerPlacement one) {
        return one == LayerPlacement::Cylinder || one == LayerPlacement::Box;
    };
    const bool goesToMiddle = isRound(placement) && !isRound(layer.placement);
    layer.placement = placement;
    if (goesToMiddle) {
        layer.place = placedOn(model, layer).place;
    }
    return layer;
}

ArtworkLayer movedOnto(const TexturedMesh& model, ArtworkLayer layer, const QString& material) {
    const std::optional<Eigen::Vector3f> middle = middleOfMaterial(model, material);
    if (!middle) {
        throw Error(Text::tr("The model has no face or material of this name; its names are %1")
                        .arg(materialNames(model).join(QStringLiteral(", ")).left(400)),
                    material);
    }
    layer.material = material;
    if (layer.placement == LayerPlacement::Decal) {
        for (int axis = 0; axis < 3; ++axis) {
            layer.place[std::size_t(axis)] =
                Millimetres(std::round(double((*middle)[axis]) * 1000) / 1000 + 0.0);
        }
    }
    return layer;
}

void addLayer(Artwork& artwork, const ArtworkLayer& layer, const TexturedMesh& model) {
    if (artwork.layers.size() >= mostArtworkLayers) {
        throw Error(Text::tr("The artwork already has %1 layers, which is the limit; remove one")
                        .arg(mostArtworkLayers),
                    layer.name);
    }
    const auto isPlain = [&](const Material& material) {
        return material.colour == model.materials.front().colour;
    };
    if (artwork.isEmpty() && model.textures.empty() &&
        std::all_of(model.materials.begin(), model.materials.end(), isPlain)) {
        artwork.base = QColor(255, 255, 255);
    }
    artwork.layers.push_back(layer);
}

std::array<Millimetres, 2> shownSize(const ArtworkLayer& layer) {
    if (layer.repeat.value() > 0) {
        return layer.size;
    }
    const double proportions = proportionsOf(layer);
    const double width = std::min(layer.size[0].value(), layer.size[1].value() * proportions);
    return {Millimetres(width), Millimetres(width / proportions)};
}

QStringList fontWarnings(const Artwork& artwork) {
    QStringList warnings;
    for (const ArtworkLayer& layer : artwork.layers) {
        if (layer.kind != LayerKind::Text || !layer.visible) {
            continue;
        }
        if (!QFontDatabase::hasFamily(layer.font)) {
            warnings.append(
                Text::tr("The font %2 of the text “%1” is not installed on this computer, so "
                         "another font replaces it; install it, or choose an installed font")
                    .arg(layer.name, layer.font));
        }
        if (const QString missing = missingCharacters(layer.text, QFont(layer.font));
            !missing.isEmpty()) {
            warnings.append(Text::tr("No installed font has the characters %2 of the text “%1”, so "
                                     "boxes are printed; install a font that has them")
                                .arg(layer.name, missing));
        }
    }
    return warnings;
}

QStringList cutOffWarnings(const Artwork& artwork, const TriangleMesh& mesh) {
    QStringList warnings;
    std::optional<SurfaceQuery> query; // made for the first decal
    const bool isOnePiece = std::none_of(artwork.layers.begin(), artwork.layers.end(), isDecal) ||
                            pieceCount(mesh) == 1;
    for (const ArtworkLayer& layer : artwork.layers) {
        if (layer.visible && layer.placement == LayerPlacement::Cylinder) {
            warnings.append(longerThanATurn(layer, mesh));
        } else if (isDecal(layer) && !isOnePiece) {
            if (!query) {
                query.emplace(mesh);
            }
            warnings.append(coveredByAnotherBody(layer, mesh, *query));
        }
    }
    warnings.removeAll(QString());
    return warnings;
}

QString colourNoteOf(const ArtworkLayer& layer) {
    return colourNoteText(layer.picture.image,
                          Text::tr("The picture of the layer “%1”").arg(layer.name));
}

QStringList layerNotes(const Artwork& artwork) {
    QStringList notes;
    const std::vector<ArtworkLayer> inks = artwork.spots();
    for (const ArtworkLayer& layer : artwork.layers) {
        notes << colourNoteOf(layer);
        const auto ink = std::ranges::find(inks, layer.spot, &ArtworkLayer::spot);
        if (layer.visible && ink != inks.end() &&
            (ink->spotFirst != layer.spotFirst || ink->spotColour != layer.spotColour)) {
            notes << Text::tr("The layers “%1” and “%2” use the ink %3 with different colours or "
                              "printing orders. It is printed with the colour and order of “%1”. "
                              "Give both layers the same colour and order")
                         .arg(ink->name, layer.name, layer.spot);
        }
    }
    notes.removeAll(QString());
    return notes;
}

} // namespace dipwright
