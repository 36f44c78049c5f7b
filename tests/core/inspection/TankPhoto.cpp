#include "TankPhoto.h"

#include "sheet/page/WatchPage.h"

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

// Returns the reflectance of ink, paper or the grey tank at a place on the water.
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

// Returns the camera's axes in the tank's frame, as columns: right, down and forward in the
// picture.
Eigen::Matrix3d axesOf(const TankCamera& camera) {
    return (Eigen::AngleAxisd(camera.tiltDegrees * pi / 180, Eigen::Vector3d::UnitX()) *
            Eigen::AngleAxisd(camera.rollDegrees * pi / 180, Eigen::Vector3d::UnitZ()))
        .toRotationMatrix();
}

// Returns the camera's place in the tank's frame: x right, y down, z into the water. The camera
// looks along +z.
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
    return pixelOf(axesOf(*this).transpose() *
                   (Eigen::Vector3d(water.x(), water.y(), -above) - placeOf(*this)));
}

QImage tankPhoto(const std::vector<FloatingPage>& pages, const TankCamera& camera,
                 const PhotoLight& light) {
    constexpr int samples = 3;
    const Eigen::Matrix3d axes = axesOf(camera);
    const Eigen::Vector3d from = placeOf(camera);
    const LightFrom lightFrom = [&](const Eigen::Vector3d& sight) {
        const Eigen::Vector3d ray = axes * sight;
        return reflected(pages, (from - ray * (from.z() / ray.z())).head<2>());
    };
    return photograph(camera, samples, lightFrom, light);
}

double GrowingFilm::times(double seconds) const {
    return 1 + limit * (1 - std::exp(-rate * (seconds - begin) / limit));
}

QImage tankPhoto(const GrowingFilm& growing, double seconds, int jpegQuality) {
    FloatingPage film = filmPage(), card = cardPage();
    const double times = growing.times(seconds);
    film.turn = turned(-3, growing.swellX * times, growing.swellY * times);
    film.middle = {-90, 0};
    card.turn = turned(12);
    card.middle = {125, -10};
    TankCamera camera;
    camera.size = {1600, 1200};
    camera.k1 = -0.05;
    camera.tiltDegrees = 5;
    return tankPhoto({card, film}, camera, {.jpegQuality = jpegQuality, .seed = unsigned(seconds)});
}

FloatingPage filmPage() {
    const WatchPage page;
    static const QImage print = printed(page);
    FloatingPage film;
    film.print = print;
    film.size = page.paper;
    return film;
}

FloatingPage cardPage() {
    WatchPage page;
    page.kind = BoardKind::Card;
    page.paper = {148, 210};
    static const QImage print = printed(page);
    FloatingPage card;
    card.print = print;
    card.size = page.paper;
    return card;
}

Eigen::Matrix2d turned(double degrees, double scaleX, double scaleY) {
    return Eigen::Rotation2Dd(degrees * pi / 180).toRotationMatrix() *
           Eigen::Vector2d(scaleX, scaleY).asDiagonal();
}

} // namespace dipwright::test
