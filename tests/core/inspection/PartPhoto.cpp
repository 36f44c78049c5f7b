#include "PartPhoto.h"

#include "geometry/SurfaceQuery.h"
#include "parallel/ParallelFor.h"

#include <cmath>

namespace dipwright::test {

Eigen::Vector2d PhotoCamera::seen(const Eigen::Vector3d& place) const {
    const Eigen::Vector3d from = pose * place;
    const Eigen::Vector2d plain = focalLength * from.head<2>() / from.z();
    const double r2 = plain.squaredNorm();
    const Eigen::Vector2d middle(size.width() / 2.0, size.height() / 2.0);
    return middle + middle.norm() * plain * (1 + k1 * r2 + k2 * r2 * r2);
}

Eigen::Vector3d PhotoCamera::sight(const Eigen::Vector2d& pixel) const {
    const Eigen::Vector2d middle(size.width() / 2.0, size.height() / 2.0);
    const Eigen::Vector2d target = (pixel - middle) / middle.norm();
    Eigen::Vector2d plain = target;
    for (int round = 0; round < 12; ++round) {
        const double r2 = plain.squaredNorm();
        plain = target / (1 + k1 * r2 + k2 * r2 * r2);
    }
    return pose.linear().transpose() *
           Eigen::Vector3d(plain.x() / focalLength, plain.y() / focalLength, 1);
}

PhotoCamera cameraFrom(const Eigen::Vector3d& from, const Eigen::Vector3d& at,
                       const Eigen::Vector3d& up) {
    const Eigen::Vector3d forward = (at - from).normalized();
    const Eigen::Vector3d right = forward.cross(up).normalized();
    PhotoCamera camera;
    camera.pose.linear() << right.transpose(), forward.cross(right).transpose(),
        forward.transpose();
    camera.pose.translation() = -(camera.pose.linear() * from);
    return camera;
}

QImage partPhoto(const TriangleMesh& body, const Print& print, const PhotoCamera& camera,
                 const PhotoLight& light) {
    constexpr int samples = 4;
    constexpr double background = 0.3;
    const SurfaceQuery query(body);
    const Eigen::Vector3f eye = camera.eye().cast<float>();
    const int width = camera.size.width();
    std::vector<float> plane(std::size_t(width) * std::size_t(camera.size.height()));
    parallelFor(0, camera.size.height(), [&](int y) {
        for (int x = 0; x < width; ++x) {
            // Within a pixel a lens is straight.
            const Eigen::Vector3d corner = camera.sight(Eigen::Vector2d(x, y));
            const Eigen::Vector3d right = camera.sight(Eigen::Vector2d(x + 1, y)) - corner;
            const Eigen::Vector3d down = camera.sight(Eigen::Vector2d(x, y + 1)) - corner;
            double sum = 0;
            for (int i = 0; i < samples * samples; ++i) {
                const double u = (i % samples + 0.5) / samples, v = (i / samples + 0.5) / samples;
                const Eigen::Vector3d sight = corner + u * right + v * down;
                const SurfacePoint hit = query.hit(eye, sight.cast<float>()).point;
                sum += hit.isValid() ? print(hit) : background;
            }
            plane[std::size_t(y) * std::size_t(width) + std::size_t(x)] =
                float(sum / (samples * samples));
        }
    });
    return developed(std::move(plane), camera.size, light);
}

} // namespace dipwright::test
