// Colours the body in the view as it comes out of the dips, on a worker thread. A new request
// replaces the one that is running.
#pragma once

#include "results/Results.h"
#include "workbench/appearance/BodyAppearance.h"
#include "workbench/jobs/JobRunner.h"

namespace dipwright {

class FinishedPartPreview : public QObject {
    Q_OBJECT

public:
    explicit FinishedPartPreview(QObject* parent = nullptr);

    // Computes the colours that `films` leave on `model` over the bare surface `ground`. Emits
    // printed() with the result.
    void print(const std::shared_ptr<const TexturedMesh>& model, std::vector<FilmAppearance> films,
               const InkSettings& ink, const Ground& ground);

signals:
    void printed(const std::shared_ptr<const dipwright::TexturedMesh>& model,
                 const dipwright::BodyAppearance& appearance);

private:
    // A model, and a mesh of it that is fine enough to show the image by its triangles.
    struct Paper {
        std::shared_ptr<const TexturedMesh> model;
        std::shared_ptr<const RefinedMesh> mesh;
        std::shared_ptr<const TexturedMesh> body;
    };
    struct Print {
        Paper paper;
        std::vector<QRgb> colours;
    };
    static Paper meshedModel(const std::shared_ptr<const TexturedMesh>& model);

    Paper paper_; // from the last request
    JobRunner jobs_;
};

} // namespace dipwright
