// Makes proof.glb: the body as a glTF 2 model that shows how it comes out (docs/proof.md).
#pragma once

#include "base/Progress.h"
#include "geometry/TriangleMesh.h"

#include <QByteArray>
#include <QRgb>
#include <QString>
#include <functional>
#include <vector>

namespace dipwright {

// One appearance of the body. Each is a variant of the model (KHR_materials_variants).
struct ProofLayer {
    QString key;  // for links and programs, such as "stretch"
    QString name; // for the user
    // Returns the colour at a place of the body. Called from several threads.
    std::function<QRgb(const SurfacePoint&)> colour;
    bool isMap = false; // colours stand for values: fewer texels, drawn without light
};

struct ProofModel {
    QByteArray glb;
    double tolerance = 0; // largest distance between this model and the body, mm
};

// The triangles and the tolerance, as a share of the body's longest edge, of a large body's model.
inline constexpr std::size_t mostProofTriangles = 40'000;
inline constexpr double proofTolerance = 5e-4;
inline constexpr int mostProofTexels = 2048; // along each side of a layer's picture

// Makes the model. The first of `layers` (at least one) is shown by programs without variants.
// Coordinates are the body's, in mm; a node scales them to metres. Bodies with more than
// mostProofTriangles are reduced within proofTolerance. Uses all cores. Equal input gives equal
// bytes. Throws Cancelled.
ProofModel proofModel(const QString& name, const TriangleMesh& body,
                      const std::vector<ProofLayer>& layers, const Progress& progress);

} // namespace dipwright
