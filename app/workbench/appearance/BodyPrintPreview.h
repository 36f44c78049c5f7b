// Colours the body in the view as it comes out of the dips, beside the user interface: of what is
// asked for while it works, the last is done.
#pragma once

#include "results/Results.h"
#include "workbench/appearance/BodyAppearance.h"
#include "workbench/jobs/JobRunner.h"

namespace dipwright {

class BodyPrintPreview : public QObject {
    Q_OBJECT

public:
    explicit BodyPrintPreview(QObject* parent = nullptr);

    // What `films` give `model` on `ground`; printed() tells.
    void print(const std::shared_ptr<const TexturedMesh>& model, std::vector<FilmAppearance> films,
               const InkSettings& ink, const Ground& ground);

signals:
    void printed(const std::shared_ptr<const dipwright::TexturedMesh>& model,
                 const dipwright::BodyAppearance& appearance);

private:
    // A model cut finely enough to show a print by.
    struct Paper {
        std::shared_ptr<const TexturedMesh> model;
        std::shared_ptr<const RefinedMesh> mesh;
        std::shared_ptr<const TexturedMesh> body;
    };
    struct Print {
        Paper paper;
        std::vector<QRgb> colours;
    };
    static Paper paperOf(const std::shared_ptr<const TexturedMesh>& model);

    Paper paper_; // of the last print
    JobRunner jobs_;
};

} // namespace dipwright
