// Finds what a camera sees of a mesh, by rasterising its triangles.
#pragma once

#include "geometry/TriangleMesh.h"

#include <QSize>

#include <vector>

namespace dipwright {

// A position of a mesh as a camera shows it.
struct ViewedPoint {
    double x = 0, y = 0; // in a grid of sample points, from its upper left corner
    double nearness = 0; // larger values hide smaller ones; linear on the picture
    double weight = 1;   // 1/depth for a perspective camera, 1 for a parallel one
};

// The nearest triangle at each sample point of a picture. Sample point (i, j) lies at
// (i + ½, j + ½). Immutable after construction; any thread may read. Takes 8 bytes per sample
// point.
class SeenBody {
public:
    // `points` are the positions of `mesh`. Shows both sides of a triangle. Keeps a reference to
    // the mesh. Uses all cores; deterministic.
    SeenBody(const TriangleMesh& mesh, std::vector<ViewedPoint> points, QSize size);

    // Returns the place that is seen at a sample point; invalid if the mesh is not seen there.
    SurfacePoint at(int column, int row) const;
    // Returns the nearness of that place; −infinity if there is none.
    float nearness(int column, int row) const { return nearness_[index(column, row)]; }

private:
    std::size_t index(int column, int row) const {
        return std::size_t(row) * std::size_t(size_.width()) + std::size_t(column);
    }
    void drawRows(const std::vector<std::uint32_t>& triangles, int begin, int end);
    void draw(std::uint32_t triangle, int begin, int end);

    const TriangleMesh& mesh_;
    std::vector<ViewedPoint> points_;
    QSize size_;
    std::vector<std::uint32_t> triangle_; // SurfacePoint::noTriangle: nothing is seen
    std::vector<float> nearness_;
};

} // namespace dipwright
