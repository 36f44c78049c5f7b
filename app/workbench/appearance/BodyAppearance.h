// The appearance of the body in the 3D view: its colours, their legend, and the lines on it.
#pragma once

#include "pipeline/JobResult.h"
#include "viewport/DipView.h"

#include <QRgb>

namespace dipwright {

struct BodyAppearance {
    std::shared_ptr<const TexturedMesh> model; // the body, or a finer mesh of it
    std::vector<QRgb> colours; // one for each triangle; empty: the model's own colours
    std::vector<ViewLegendEntry> legend = {};
    std::vector<ViewLine> lines = {};
};

// Returns `mesh` as a body of one plain colour.
std::shared_ptr<const TexturedMesh> plainBody(const RefinedMesh& mesh);

// Returns `mesh`, which is fine enough already, as a body of one plain colour.
std::shared_ptr<const TexturedMesh> plainBody(const TriangleMesh& mesh);

// Shows `model` in one colour, as it is where no film paints it. `base` is the body's own colour;
// none: light grey.
BodyAppearance bareAppearance(std::shared_ptr<const TexturedMesh> model,
                              const std::optional<QColor>& base);
// Colours the area that a dip would paint. `covered`: one value for each triangle of `body`; not 0:
// the dip would paint it.
BodyAppearance previewAppearance(std::shared_ptr<const TexturedMesh> body,
                                 const std::vector<std::uint8_t>& covered);
// Colours the painted area of `model` after one dip. Triangles with torn, released or unconverged
// film have their own colours.
BodyAppearance coverageAppearance(std::shared_ptr<const TexturedMesh> model,
                                  const Coverage& coverage);
// Colours the shares of two dips and draws the seam. `body` must be plainBody() of the share's
// mesh.
BodyAppearance shareAppearance(std::shared_ptr<const TexturedMesh> body, const JobResult& result);

} // namespace dipwright
