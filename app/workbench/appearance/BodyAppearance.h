// What the body wears in the 3D view: its colours, what they mean, and the lines on it.
#pragma once

#include "pipeline/JobResult.h"
#include "viewport/DipView.h"

#include <QRgb>

namespace dipwright {

struct BodyAppearance {
    std::shared_ptr<const TexturedMesh> model; // shown as the body: itself, or cut finer
    std::vector<QRgb> colours;                 // a triangle each; empty: the model's own look
    std::vector<ViewLegendEntry> legend = {};
    std::vector<ViewLine> lines = {};
};

// `mesh` as a body of one plain colour.
std::shared_ptr<const TexturedMesh> plainBody(const RefinedMesh& mesh);

// The same of a mesh that is cut already.
std::shared_ptr<const TexturedMesh> plainBody(const TriangleMesh& mesh);

// What a dip would paint, a triangle of `body` each.
BodyAppearance previewAppearance(std::shared_ptr<const TexturedMesh> body,
                                 const std::vector<std::uint8_t>& covered);
// What one dip paints of `model`, and how that is marked.
BodyAppearance coverageAppearance(std::shared_ptr<const TexturedMesh> model,
                                  const Coverage& coverage);
// Who paints what of a body that is shared out, and the join; `body` is plainBody() of the share's
// mesh.
BodyAppearance shareAppearance(std::shared_ptr<const TexturedMesh> body, const JobResult& result);

} // namespace dipwright
