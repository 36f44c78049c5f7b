// Paints artwork on the body in the view, at low resolution and on a worker thread. While a request
// is painted, only the newest further request is kept, so that a dragged layer follows the cursor.
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

    // Starts or queues a request. Emits painted() when the request is painted.
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
