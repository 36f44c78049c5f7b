#include "Painting.h"
#include "Samples.h"
#include "geometry/Shapes.h"

#include <cmath>

namespace dipwright::samples {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double seamLongitude = 45; // degrees to the right of the front

// Returns the place's angle around the globe from the seam, as a share 0 … 1 of a full turn. It
// increases to the right as seen from outside.
double turn(const Eigen::Vector3f& place) {
    const double longitude = std::atan2(place.x(), place.z()) * 180 / pi;
    const double turns = (longitude - seamLongitude) / 360;
    return turns - std::floor(turns);
}

float height(const Eigen::Vector3f& place) {
    return float(0.5 + std::asin(std::clamp(place.normalized().y(), -1.0F, 1.0F)) / pi);
}

std::array<Eigen::Vector2f, 3> globeCoordinates(const std::array<Eigen::Vector3f, 3>& corners) {
    const double middle = turn(corners[0] + corners[1] + corners[2]);
    std::array<Eigen::Vector2f, 3> result;
    for (int i = 0; i < 3; ++i) {
        // A pole has no longitude, so it gets the longitude of the triangle's other corners. At the
        // seam, 0 and 1 are the same longitude.
        const bool pole = std::hypot(corners[i].x(), corners[i].z()) < 1e-3;
        const double own = pole ? middle : turn(corners[i]);
        result[i] = {float(own - std::round(own - middle)), height(corners[i])};
    }
    return result;
}

// Returns the place in the picture. Longitude 0 is the front.
QPointF onPicture(double longitude, double latitude) {
    const double turns = (longitude - seamLongitude) / 360;
    return {texturePixels * (turns - std::floor(turns)), texturePixels * (0.5 - latitude / 180)};
}

// Returns the factor by which drawings must be widened at this latitude, so that they look
// undistorted on the globe.
double widening(double latitude) {
    return 0.5 / std::cos(latitude * pi / 180);
}

constexpr int fieldDegrees = 15;
constexpr double fieldWidth = texturePixels * fieldDegrees / 360.0;
constexpr double fieldHeight = texturePixels * fieldDegrees / 180.0;
const QColor ink(24, 38, 66);

// Paints coloured fields around the globe, in all hues, alternately lighter and darker.
void paintFields(QPainter& painter) {
    for (int column = 0; column < 24; ++column) {
        for (int row = 0; row < 12; ++row) {
            const bool light = (column + row) % 2 == 0;
            const QColor colour = QColor::fromHsvF(float(std::fmod(0.52 + column / 24.0, 1.0)),
                                                   light ? 0.16F : 0.45F, light ? 0.99F : 0.92F);
            painter.fillRect(
                QRectF(column * fieldWidth, row * fieldHeight, fieldWidth, fieldHeight), colour);
        }
    }
}

// Paints meridians and parallels that have a constant width on the globe. In the picture, meridians
// widen towards the poles.
void paintGraticule(QPainter& painter) {
    for (int longitude = 0; longitude < 360; longitude += fieldDegrees) {
        const double x = onPicture(longitude, 0).x();
        const bool strong = longitude % 45 == 0;
        const double end = strong ? 85 : 75;
        for (int y = 0; y < texturePixels; ++y) {
            const double latitude = 90 - (y + 0.5) * 180 / texturePixels;
            if (std::abs(latitude) < end) {
                const double width = (strong ? 14 : 7) * widening(latitude);
                // Both ends of the picture show the meridian of the seam.
                for (const double wrap : {0, texturePixels}) {
                    painter.fillRect(QRectF(x - width / 2 + wrap, y, width, 1), ink);
                }
            }
        }
    }
    for (int latitude = -75; latitude <= 75; latitude += fieldDegrees) {
        const double width = latitude % 45 == 0 ? 14 : 7;
        painter.fillRect(QRectF(0, onPicture(0, latitude).y() - width / 2, texturePixels, width),
                         ink);
    }
    const double cap = texturePixels * 5 / 180.0;
    painter.fillRect(QRectF(0, 0, texturePixels, cap), ink);
    painter.fillRect(QRectF(0, texturePixels - cap, texturePixels, cap), ink);
}

// Names the light fields as on a map: a letter for the column and a number for the row.
void paintNames(QPainter& painter) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    for (int row = 2; row < 10; ++row) {
        for (int column = row % 2; column < 24; column += 2) {
            const QPointF centre((column + 0.5) * fieldWidth, (row + 0.5) * fieldHeight);
            const double latitude = 90 - (row + 0.5) * fieldDegrees;
            const double size = std::abs(latitude) > 50 ? 58 : 80;
            const QString name = QChar(char16_t('A' + column)) + QString::number(row - 1);
            paintLetters(painter, centre, size, name, 0.85 * widening(latitude));
        }
    }
}

} // namespace

TexturedMesh sphere() {
    TriangleMesh mesh = sphereMesh(35, 72, 144);
    std::vector<std::array<Eigen::Vector2f, 3>> coordinates;
    for (const auto& triangle : mesh.triangles) {
        coordinates.push_back(
            globeCoordinates({mesh.positions[triangle[0]], mesh.positions[triangle[1]],
                              mesh.positions[triangle[2]]}));
    }
    QImage picture(texturePixels, texturePixels, QImage::Format_ARGB32);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    paintFields(painter);
    paintGraticule(painter);
    paintNames(painter);
    painter.end();
    return textured(std::move(mesh), std::move(coordinates), picture);
}

} // namespace dipwright::samples
