#include "geometry/Shapes.h"

#include "base/Units.h"

#include <cmath>

namespace dipwright {

namespace {

using Index = std::uint32_t;

Eigen::Vector3f point(double x, double y, double z) {
    return Eigen::Vector3d(x, y, z).cast<float>();
}

// Adds a fan of triangles between `hub` and the ring of `segments` positions that starts at
// `first`, in the ring's direction or against it.
void addFan(TriangleMesh& mesh, Index hub, Index first, Index segments, bool alongRing) {
    for (Index s = 0; s < segments; ++s) {
        const Index a = first + s;
        const Index b = first + (s + 1) % segments;
        mesh.triangles.push_back(alongRing ? std::array{hub, a, b} : std::array{hub, b, a});
    }
}

// Adds the band between two rings of `segments` positions each. Seen from outside the body and
// facing the direction in which the rings are numbered, the ring `from` is on the left of the ring
// `to`.
void addBand(TriangleMesh& mesh, Index from, Index to, Index segments) {
    for (Index s = 0; s < segments; ++s) {
        const Index next = (s + 1) % segments;
        mesh.triangles.push_back({from + s, to + s, to + next});
        mesh.triangles.push_back({from + s, to + next, from + next});
    }
}

double ringAngle(int segment, int segments) {
    return 2 * pi * segment / segments;
}

} // namespace

TriangleMesh ellipsoidMesh(const Eigen::Vector3d& radii, int rings, int segments) {
    TriangleMesh mesh;
    const Index count = Index(segments);
    mesh.positions.push_back(point(0, radii.y(), 0));
    for (int ring = 1; ring < rings; ++ring) {
        const double polar = pi * ring / rings;
        for (int segment = 0; segment < segments; ++segment) {
            const double azimuth = ringAngle(segment, segments);
            mesh.positions.push_back(point(radii.x() * std::sin(polar) * std::sin(azimuth),
                                           radii.y() * std::cos(polar),
                                           radii.z() * std::sin(polar) * std::cos(azimuth)));
        }
    }
    const Index lastRing = 1 + Index(rings - 2) * count;
    const Index southPole = Index(mesh.positions.size());
    mesh.positions.push_back(point(0, -radii.y(), 0));

    addFan(mesh, 0, 1, count, true);
    for (Index ring = 1; ring < lastRing; ring += count) {
        addBand(mesh, ring, ring + count, count);
    }
    addFan(mesh, southPole, lastRing, count, false);
    return mesh;
}

TriangleMesh sphereMesh(double radius, int rings, int segments) {
    return ellipsoidMesh({radius, radius, radius}, rings, segments);
}

TriangleMesh coneMesh(double halfAngleRadians, double height, int segments) {
    TriangleMesh mesh;
    const double radius = height * std::tan(halfAngleRadians);
    mesh.positions.push_back(point(0, 0, 0));
    mesh.positions.push_back(point(0, height, 0));
    for (int segment = 0; segment < segments; ++segment) {
        const double azimuth = ringAngle(segment, segments);
        mesh.positions.push_back(
            point(radius * std::sin(azimuth), height, radius * std::cos(azimuth)));
    }
    addFan(mesh, 0, 2, Index(segments), false);
    addFan(mesh, 1, 2, Index(segments), true);
    return mesh;
}

TriangleMesh boxMesh(const Eigen::Vector3d& size) {
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
        mesh.positions.push_back(point(size.x() * ((corner & 1) - 0.5),
                                       size.y() * ((corner >> 1 & 1) - 0.5),
                                       size.z() * ((corner >> 2 & 1) - 0.5)));
    }
    mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    return mesh;
}

TriangleMesh cylinderMesh(double radius, double length, int segments) {
    TriangleMesh mesh;
    for (const double z : {-length / 2, length / 2}) {
        mesh.positions.push_back(point(0, 0, z));
        for (int segment = 0; segment < segments; ++segment) {
            const double angle = ringAngle(segment, segments);
            mesh.positions.push_back(point(radius * std::cos(angle), radius * std::sin(angle), z));
        }
    }
    const Index count = Index(segments);
    const Index back = 1;
    const Index frontCentre = count + 1;
    const Index front = count + 2;
    addFan(mesh, 0, back, count, false);
    addBand(mesh, front, back, count);
    addFan(mesh, frontCentre, front, count, true);
    return mesh;
}

TriangleMesh torusMesh(double circleRadius, double tubeRadius, int rings, int segments) {
    TriangleMesh mesh;
    const Index count = Index(segments);
    for (int ring = 0; ring < rings; ++ring) {
        // angle around the tube: 0 at the outermost ring, increasing over the top
        const double round = ringAngle(ring, rings);
        const double distance = circleRadius + tubeRadius * std::cos(round);
        for (int segment = 0; segment < segments; ++segment) {
            const double azimuth = ringAngle(segment, segments);
            mesh.positions.push_back(point(distance * std::sin(azimuth),
                                           tubeRadius * std::sin(round),
                                           distance * std::cos(azimuth)));
        }
    }
    for (int ring = 0; ring < rings; ++ring) {
        addBand(mesh, Index((ring + 1) % rings) * count, Index(ring) * count, count);
    }
    return mesh;
}

TriangleMesh tetrahedronMesh(double edge) {
    TriangleMesh mesh;
    const double height = edge * std::sqrt(2.0 / 3);
    const double circumradius = edge / std::sqrt(3.0); // circumradius of a face
    for (int corner = 0; corner < 3; ++corner) {
        const double angle = ringAngle(corner, 3);
        mesh.positions.push_back(
            point(circumradius * std::sin(angle), -height / 4, circumradius * std::cos(angle)));
    }
    mesh.positions.push_back(point(0, height * 3 / 4, 0));
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    return mesh;
}

} // namespace dipwright
