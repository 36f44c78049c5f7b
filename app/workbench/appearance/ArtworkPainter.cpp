#include "workbench/appearance/ArtworkPainter.h"

#include "artwork/PaintArtwork.h"

namespace dipwright {
namespace {

constexpr qint64 draftTexels = 1'500'000; // as many as the view shows

} // namespace

ArtworkPainter::ArtworkPainter(QObject* parent) : QObject(parent) {}

void ArtworkPainter::paint(const std::shared_ptr<const TexturedMesh>& model,
                           const Artwork& artwork) {
    wanted_ = {model, artwork};
    if (!isPainting_) {
        begin();
    }
}

void ArtworkPainter::begin() {
    isPainting_ = true;
    begun_ = wanted_;
    using Look = std::shared_ptr<const TexturedMesh>;
    const auto ended = [this] {
        isPainting_ = false;
        if (wanted_ != begun_) {
            begin();
        }
    };
    jobs_.start(std::make_unique<ValueJob<Look>>(
        tr("Painting the artwork"),
        [wish = begun_](const Progress& progress) {
            return dipwright::painted(wish.model, wish.artwork, 0, progress, draftTexels);
        },
        [this, ended](const Look& look) {
            emit painted(begun_.model, look);
            ended();
        },
        [ended](const std::exception_ptr&) { ended(); })); // on failure, keeps the view
}

} // namespace dipwright
