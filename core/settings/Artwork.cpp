#include "settings/Artwork.h"

#include "base/ColourNote.h"
#include "base/Sha256.h"
#include "base/WideGamut.h"

#include <algorithm>
#include <iterator>

namespace dipwright {

bool isPattern(LayerKind kind) {
    return kind != LayerKind::Picture && kind != LayerKind::Text;
}

ArtworkPicture artworkPicture(const QImage& image) {
    const bool wide = isWide(image);
    const QImage kept = wide ? inWide(image) : image.convertToFormat(QImage::Format_RGBA8888);
    Sha256 hash;
    hash.add(QByteArray::number(kept.width()) + 'x' + QByteArray::number(kept.height()) +
             (wide ? "w" : "s") + colourNoteValue(image).toUtf8());
    const auto bytes = qsizetype(kept.width()) * kept.depth() / 8;
    for (int row = 0; row < kept.height(); ++row) {
        hash.add(QByteArrayView(kept.constScanLine(row), bytes));
    }
    return {QString::fromLatin1(hash.result().toHex()), kept};
}

Artwork Artwork::inColours() const {
    Artwork coloured{base, {}};
    std::copy_if(layers.begin(), layers.end(), std::back_inserter(coloured.layers),
                 [](const ArtworkLayer& layer) {
                     return layer.spot.isEmpty() && layer.visible && layer.opacity > 0;
                 });
    return coloured;
}

Artwork Artwork::inSpot(const QString& spot) const {
    Artwork own{QColor(Qt::white), {}};
    std::copy_if(layers.begin(), layers.end(), std::back_inserter(own.layers),
                 [&](const ArtworkLayer& layer) { return layer.spot == spot; });
    return own;
}

std::vector<ArtworkLayer> Artwork::spots() const {
    std::vector<ArtworkLayer> found;
    for (const ArtworkLayer& layer : layers) {
        const bool isKnown =
            std::any_of(found.begin(), found.end(),
                        [&](const ArtworkLayer& known) { return known.spot == layer.spot; });
        if (layer.visible && !layer.spot.isEmpty() && !isKnown) {
            found.push_back(layer);
        }
    }
    return found;
}

} // namespace dipwright
