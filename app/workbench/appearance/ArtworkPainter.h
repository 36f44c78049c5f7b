// Paints artwork on the body in the view, coarsely, beside the user interface: while one is painted
// the last that was asked for waits, so that a layer that is dragged goes along.
#pragma once

#include "model/TexturedMesh.h"
#include "settings/Artwork.h"
#include "workbench/jobs/JobRunner.h"

#include <memory>

namespace dipwright {

class ArtworkPainter : public QObject {
    Q_OBJECT

public:
    explicit ArtworkPainter(QObject* parent = nullptr);

    // painted() tells.
    void paint(const std::shared_ptr<const TexturedMesh>& model, const Artwork& artwork);

signals:
    // `look`: `model` with the artwork on it.
    void painted(const std::shared_ptr<const dipwright::TexturedMesh>& model,
                 const std::shared_ptr<const dipwright::TexturedMesh>& look);

private:
    struct Wish {
        std::shared_ptr<const TexturedMesh> model;
        Artwork artwork;
        bool operator==(const Wish&) const = default;
    };
    void begin();

    Wish wanted_, begun_;
    bool isPainting_ = false;
    JobRunner jobs_;
};

} // namespace dipwright
