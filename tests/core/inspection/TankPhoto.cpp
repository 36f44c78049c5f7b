#include "TankPhoto.h"

#include "parallel/ParallelFor.h"
#include "sheet/WatchPage.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <QPainter>
#include <cmath>
#include <vector>

namespace dipwright::test {

namespace {

constexpr double pageDpi = 300;

QImage printed(const WatchPage& page) {
    const double unit = pageDpi / millimetresPerInch;
    QImage image((page.paper * unit).toSize(), QImage::Format_Grayscale8);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(image.width() / page.paper.width(), image.height() / page.paper.height());
    paintWatchPage(painter, page);
    return image;
}

double sampled(const QImage& image, double x, double y) {
    x = std::clamp(x - 0.5, 0.0, image.width() - 1.001);
    y = std::clamp(y - 0.5, 0.0, image.height() - 1.001);
    const int i = int(x), j = int(y);
    const double u = x - i, v = y - j;
    const uchar *upper = image.constScanLine(j), *lower = image.constScanLine(j + 1);
    return ((1 - v) * ((1 - u) * upper[i] + u * upper[i + 1]) +
            v * ((1 - u) * lower[i] + u * lower[i + 1])) /
           255;
}

// Reflectance of ink and paper on a grey tank.
double reflected(const std::vector<FloatingPage>& pages, const Eigen::Vector2d& water) {
    for (const FloatingPage& page : pages) {
        const Eigen::Matrix2d back = page.turn.inverse();
        const Eigen::Vector2d place = back * (water - page.middle);
        const double x = place.x() / page.size.width() + 0.5;
        const double y = place.y() / page.size.height() + 0.5;
        if (x >= 0 && x < 1 && y >= 0 && y < 1) {
            return 0.04 +
                   0.8 * sampled(page.print, x * page.print.width(), y * page.print.height());
        }
    }
    return 0.2 + 0.03 * std::sin(water.x() / 9) * std::sin(water.y() / 13);
}

std::vector<float> reflected(const std::vector<FloatingPage>& pages, const TankCamera& camera) {
    constexpr int samples = 3;
    const int width = camera.size.width(), height = camera.size.height();
    std::vector<float> plane(std::size_t(width) * std::size_t(height));
    parallelFor(0, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            // Within a pixel a lens is straight.
            const Eigen::Vector2d corner = camera.looksAt(Eigen::Vector2d(x, y));
            const Eigen::Vector2d right = camera.looksAt(Eigen::Vector2d(x + 1, y)) - corner;
            const Eigen::Vector2d down = camera.looksAt(Eigen::Vector2d(x, y + 1)) - corner;
            double sum = 0;
            for (int i = 0; i < samples * samples; ++i) {
                const double u = (i % samples + 0.5) / samples, v = (i / samples + 0.5) / samples;
                sum += reflected(pages, corner + u * right + v * down) / (samples * samples);
            }
            plane[std::size_t(y) * std::size_t(width) + std::size_t(x)] = float(sum);
        }
    });
    return plane;
}

// The camera's axes in the tank's frame, by columns: right, down and forward in the picture.
Eigen::Matrix3d axesOf(const TankCamera& camera) {
    return (Eigen::AngleAxisd(camera.tiltDegrees * pi / 180, Eigen::Vector3d::UnitX()) *
            Eigen::AngleAxisd(camera.rollDegrees * pi / 180, Eigen::Vector3d::UnitZ()))
        .toRotationMatrix();
}

// x right, y down, z into the water: forward is +z.
Eigen::Vector3d placeOf(const TankCamera& camera) {
    const Eigen::Vector3d forward = axesOf(camera).col(2);
    return Eigen::Vector3d(camera.over.x(), camera.over.y(), 0) -
           forward * (camera.height / forward.z());
}

} // namespace

Eigen::Vector2d FloatingPage::onWater(const Eigen::Vector2d& onPage) const {
    return middle + turn * onPage + (aside ? aside(onPage) : Eigen::Vector2d::Zero());
}

Eigen::Vector2d TankCamera::seen(const Eigen::Vector2d& water, double above) const {
    const Eigen::Vector3d from = axesOf(*this).transpose() *
                                 (Eigen::Vector3d(water.x(), water.y(), -above) - placeOf(*this));
    const Eigen::Vector2d plain = focalLength * from.head<2>() / from.z();
    const double r2 = plain.squaredNorm();
    const Eigen::Vector2d middle(size.width() / 2.0, size.height() / 2.0);
    return middle + middle.norm() * plain * (1 + k1 * r2 + k2 * r2 * r2);
}

Eigen::Vector2d TankCamera::looksAt(const Eigen::Vector2d& pixel, double above) const {
    const Eigen::Vector2d middle(size.width() / 2.0, size.height() / 2.0);
    const Eigen::Vector2d target = (pixel - middle) / middle.norm();
    Eigen::Vector2d plain = target;
    for (int round = 0; round < 12; ++round) {
        const double r2 = plain.squaredNorm();
        plain = target / (1 + k1 * r2 + k2 * r2 * r2);
    }
    const Eigen::Vector3d ray =
        axesOf(*this) * Eigen::Vector3d(plain.x() / focalLength, plain.y() / focalLength, 1);
    const Eigen::Vector3d from = placeOf(*this);
    return (from + ray * ((-above - from.z()) / ray.z())).head<2>();
}

QImage tankPhoto(const std::vector<FloatingPage>& pages, const TankCamera& camera,
                 const PhotoLight& light) {
    return developed(reflected(pages, camera), camera.size, light);
}

FloatingPage filmPage() {
    WatchPage page;
    FloatingPage film;
    film.print = printed(page);
    film.size = page.paper;
    return film;
}

FloatingPage cardPage() {
    WatchPage page;
    page.kind = BoardKind::Card;
    page.paper = {148, 210};
    FloatingPage card;
    card.print = printed(page);
    card.size = page.paper;
    return card;
}

Eigen::Matrix2d turned(double degrees, double scaleX, double scaleY) {
    return Eigen::Rotation2Dd(degrees * pi / 180).toRotationMatrix() *
           Eigen::Vector2d(scaleX, scaleY).asDiagonal();
}

} // namespace dipwright::test
