#include "Painting.h"
#include "Samples.h"
#include "geometry/Shapes.h"

#include <QPainterPath>

namespace dipwright::samples {

namespace {

constexpr double edge = 60;                              // mm
constexpr double faceHeight = edge * 0.8660254037844386; // mm
constexpr double pixelsPerMillimetre = texturePixels / 128.0;

// Returns the origin of the face's quarter of the picture, in mm from the picture's lower left
// corner.
Eigen::Vector2d quarter(std::size_t face) {
    const auto column = double(face % 2);
    const double row = face < 2 ? 0 : 1;
    return {2 + 64 * column, 6 + 64 * row};
}

// Returns the texture coordinates of the face in its quarter. The first corner is at the lower
// left.
std::array<Eigen::Vector2f, 3> faceCoordinates(std::size_t face) {
    const std::array<Eigen::Vector2d, 3> corners{{{0, 0}, {edge, 0}, {edge / 2, faceHeight}}};
    std::array<Eigen::Vector2f, 3> result;
    for (int i = 0; i < 3; ++i) {
        result[i] = ((quarter(face) + corners[i]) / 128).cast<float>();
    }
    return result;
}

// Rotates the order of a triangle's corners so that the triangle stands on its lowest edge. The
// letter is then upright.
std::array<std::uint32_t, 3> standing(const TriangleMesh& mesh,
                                      const std::array<std::uint32_t, 3>& corners) {
    const auto height = [&](int i) { return mesh.positions[corners[i % 3]].y(); };
    int top = 0;
    for (int i = 1; i < 3; ++i) {
        top = height(i) > height(top) + 1e-3F ? i : top;
    }
    return {corners[(top + 1) % 3], corners[(top + 2) % 3], corners[top]};
}

void paintGrid(QPainter& painter, const QColor& ink) {
    for (int step = 0; step <= 12; ++step) {
        painter.setPen(QPen(ink, step % 2 == 0 ? 0.5 : 0.2));
        painter.drawLine(QPointF(0, 5.0 * step), QPointF(64, 5.0 * step));
        painter.drawLine(QPointF(5.0 * step, 0), QPointF(5.0 * step, 64));
    }
}

// Paints one face in millimetres; y points up from the face's lower left corner.
void paintFace(QPainter& painter, std::size_t face) {
    const std::array<QColor, 4> grounds{QColor(0xf2, 0xb1, 0x34), QColor(0x3f, 0xa7, 0xa0),
                                        QColor(0xd9, 0x5d, 0x59), QColor(0x5b, 0x7d, 0xb8)};
    const QColor ground = grounds[face];
    painter.fillRect(QRectF(-2, -6, 64, 64), ground);
    paintGrid(painter, ground.darker(135));

    QPainterPath frame;
    const QPointF middle(edge / 2, faceHeight / 3);
    for (const QPointF corner : {QPointF(0, 0), QPointF(edge, 0), QPointF(edge / 2, faceHeight)}) {
        const QPointF inner = middle + (corner - middle) * 0.84;
        frame.elementCount() == 0 ? frame.moveTo(inner) : frame.lineTo(inner);
    }
    frame.closeSubpath();
    painter.setPen(QPen(Qt::white, 1.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(frame);

    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::white);
    painter.drawEllipse(middle, 11.5, 11.5);
    painter.setBrush(ground.darker(220));
    painter.save();
    painter.translate(middle);
    painter.scale(1, -1);
    // Letters that look wrong when they are mirrored or rotated.
    constexpr std::array<char16_t, 4> letters{u'F', u'G', u'P', u'R'};
    paintLetters(painter, QPointF(0, 0), 14, QChar(letters[face]));
    painter.restore();
}

} // namespace

TexturedMesh tetrahedron() {
    TriangleMesh mesh = tetrahedronMesh(edge);
    std::vector<std::array<Eigen::Vector2f, 3>> coordinates;
    QImage picture(texturePixels, texturePixels, QImage::Format_ARGB32);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
        mesh.triangles[face] = standing(mesh, mesh.triangles[face]);
        coordinates.push_back(faceCoordinates(face));
        painter.resetTransform();
        painter.translate(0, texturePixels);
        painter.scale(pixelsPerMillimetre, -pixelsPerMillimetre);
        painter.translate(quarter(face).x(), quarter(face).y());
        paintFace(painter, face);
    }
    painter.end();
    return textured(std::move(mesh), std::move(coordinates), picture);
}

} // namespace dipwright::samples
