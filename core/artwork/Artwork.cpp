#include "artwork/Artwork.h"

#include "base/WideColour.h"

#include <QCryptographicHash>
#include <QFontDatabase>

namespace dipwright {

bool isPattern(LayerKind kind) {
    return kind != LayerKind::Picture && kind != LayerKind::Text;
}

ArtworkPicture artworkPicture(const QImage& image) {
    const bool wide = isWide(image);
    const QImage kept = wide ? inWide(image) : image.convertToFormat(QImage::Format_RGBA8888);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(QByteArray::number(kept.width()) + 'x' + QByteArray::number(kept.height()) +
                 (wide ? "w" : "s"));
    const auto bytes = qsizetype(kept.width()) * kept.depth() / 8;
    for (int row = 0; row < kept.height(); ++row) {
        hash.addData(QByteArrayView(kept.constScanLine(row), bytes));
    }
    return {QString::fromLatin1(hash.result().toHex()), kept};
}

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

QStringList missingFonts(const Artwork& artwork) {
    QStringList missing;
    for (const ArtworkLayer& layer : artwork.layers) {
        if (layer.kind == LayerKind::Text && !QFontDatabase::hasFamily(layer.font)) {
            missing.append(QStringLiteral("%1 (%2)").arg(layer.name, layer.font));
        }
    }
    return missing;
}

} // namespace dipwright
