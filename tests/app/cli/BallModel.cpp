#include "BallModel.h"

#include "TestFiles.h"
#include "base/Units.h"

#include <QImage>
#include <QTextStream>
#include <cmath>

namespace dipwright::test {
namespace {

constexpr int rings = 24;
constexpr int segments = 48;
constexpr double radius = 20;

QString ballObj() {
    QString text = QStringLiteral("mtllib ball.mtl\nusemtl ball\n");
    QTextStream obj(&text);
    for (int ring = 0; ring <= rings; ++ring) {
        for (int segment = 0; segment <= segments; ++segment) {
            const double polar = pi * ring / rings;
            const double reach = ring % rings == 0 ? 0 : radius * std::sin(polar);
            // The two edges of the texture seam coincide, and so do all points of a pole.
            const double turn = 2 * pi * (segment % segments) / segments;
            obj << "v " << reach * std::cos(turn) << ' ' << radius * std::cos(polar) << ' '
                << -reach * std::sin(turn) << "\nvt " << double(segment) / segments << ' '
                << 1 - double(ring) / rings << '\n';
        }
    }
    const auto corner = [](int ring, int segment) {
        return QStringLiteral("%1/%1").arg(ring * (segments + 1) + segment + 1);
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int segment = 0; segment < segments; ++segment) {
            obj << "f " << corner(ring, segment) << ' ' << corner(ring + 1, segment) << ' '
                << corner(ring + 1, segment + 1) << ' ' << corner(ring, segment + 1) << '\n';
        }
    }
    return text;
}

QImage stripes() {
    QImage image(96, 48, QImage::Format_RGB888);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            image.setPixelColor(x, y, QColor(x / 8 % 2 * 200, 40 + 4 * y, 255 - 2 * x));
        }
    }
    return image;
}

} // namespace

QString writeBall(const QString& folder) {
    writeFile(folder + QStringLiteral("/ball.obj"), ballObj().toUtf8());
    writeFile(folder + QStringLiteral("/ball.mtl"), "newmtl ball\nKd 1 1 1\nmap_Kd ball.png\n");
    stripes().save(folder + QStringLiteral("/ball.png"));
    return folder + QStringLiteral("/ball.obj");
}

} // namespace dipwright::test
