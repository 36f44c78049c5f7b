#include "PartPhoto.h"

#include "geometry/SurfaceQuery.h"

#include <cmath>

namespace dipwright::test {

Eigen::Vector2d PhotoCamera::seen(const Eigen::Vector3d& place) const {
    return pixelOf(pose * place);
}

bool PhotoCamera::faces(const Eigen::Vector3d& place, const Eigen::Vector3d& outward) const {
    constexpr double leastCosine = 0.35;
    return (eye() - place).normalized().dot(outward) > leastCosine;
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

Print chessboardPrint(const LaidFilm& laid, QSizeF sheet, double square) {
    const Eigen::Vector2d squares(sheet.width() / laid.film().grid.width / square,
                                  sheet.height() / laid.film().grid.depth / square);
    return [&laid, squares](const SurfacePoint& point) {
        const auto place = laid.place(point);
        if (!place) {
            return 0.6;
        }
        const Eigen::Vector2d at = place->rest.cast<double>().cwiseProduct(squares);
        return (int(std::floor(at.x())) + int(std::floor(at.y()))) % 2 == 0 ? 0.05 : 0.85;
    };
}

QImage partPhoto(const TriangleMesh& body, const Print& print, const PhotoCamera& camera,
                 const PhotoLight& light) {
    constexpr int samples = 4;
    constexpr double background = 0.3;
    const SurfaceQuery query(body);
    const Eigen::Vector3f eye = camera.eye().cast<float>();
    const Eigen::Matrix3d toModel = camera.pose.linear().transpose();
    const LightFrom lightFrom = [&](const Eigen::Vector3d& sight) {
        const SurfacePoint hit = query.hit(eye, (toModel * sight).cast<float>()).point;
        return hit.isValid() ? print(hit) : background;
    };
    return photograph(camera, samples, lightFrom, light);
}

} // namespace dipwright::test
