// Tests which surface brush strokes and masks cover, against areas of circles and caps.
#include "marks/SurfaceMask.h"
#include "geometry/Shapes.h"
#include "marks/StrokePatch.h"

#include <QtTest>

using namespace dipwright;

namespace {

std::shared_ptr<const TexturedMesh> modelOf(const TriangleMesh& mesh) {
    auto model = std::make_shared<TexturedMesh>();
    model->mesh = mesh;
    model->textureCoordinates.resize(mesh.triangles.size());
    model->material.resize(mesh.triangles.size());
    model->chart.resize(mesh.triangles.size());
    model->materials.resize(1);
    return model;
}

BrushPoint pointAt(const Eigen::Vector3d& place, const Eigen::Vector3d& outward) {
    BrushPoint point;
    for (int axis = 0; axis < 3; ++axis) {
        point.place[std::size_t(axis)] = Millimetres(place[axis]);
        point.outward[std::size_t(axis)] = outward[axis];
    }
    return point;
}

MaskMark strokeOf(const BrushPath& path, double radius, bool erases = false) {
    MaskMark mark;
    mark.path = path;
    mark.radius = Millimetres(radius);
    mark.erases = erases;
    return mark;
}

double areaOf(const std::vector<MarkedPiece>& pieces) {
    double area = 0;
    for (const MarkedPiece& piece : pieces) {
        const auto& [a, b, c] = piece.corners;
        area += double((b - a).cross(c - a).norm()) / 2;
    }
    return area;
}

bool isAbout(double value, double expected) {
    const bool isNear = std::abs(value / expected - 1) < 0.01;
    if (!isNear) {
        qWarning("%g, expected %g", value, expected);
    }
    return isNear;
}

const Eigen::Vector3d up(0, 1, 0);

} // namespace

class SurfaceMaskTest : public QObject {
    Q_OBJECT

private slots:
    // A sphere's cap whose rim is r away from its pole has the area π r².
    void surfaceMask_dabOnBall_coversItsCap() {
        const auto ball = modelOf(sphereMesh(25, 90, 180));
        const SurfaceMask mask(ball, {strokeOf({pointAt(25 * up, up)}, 10)});
        const MaskedAreas areas = maskedAreas(mask);
        QVERIFY(isAbout(areas.area, pi * 100));
        QCOMPARE(areas.count, std::size_t(1));
    }

    void surfaceMask_strokeOnTwoLargeTriangles_isExact() {
        const SurfaceMask mask(box_, {strokeOf({top(-20), top(15)}, 4)});
        QVERIFY(isAbout(maskedAreas(mask).area, 35 * 8 + pi * 16));
    }

    void surfaceMask_strokeOverEdge_goesRoundIt() {
        const SurfaceMask mask(box_, {strokeOf({top(50)}, 4)}); // on the edge of the upper face
        QVERIFY(isAbout(maskedAreas(mask).area, pi * 16));
    }

    void surfaceMask_thinWall_isMaskedOnOneSide() {
        const auto wall = modelOf(boxMesh({100, 1, 100}));
        const BrushPath front{pointAt({0, 0.5, 0}, up)};
        const BrushPath everySide{pointAt({0, 0.5, 0}, {0, 0, 0})};
        QVERIFY(isAbout(maskedAreas(SurfaceMask(wall, {strokeOf(front, 5)})).area, pi * 25));
        const double back = pi * (25 - 1);
        QVERIFY(
            isAbout(maskedAreas(SurfaceMask(wall, {strokeOf(everySide, 5)})).area, pi * 25 + back));
    }

    void surfaceMask_eraser_takesItsAreaOut() {
        const SurfaceMask mask(box_, {strokeOf({top(0)}, 10), strokeOf({top(0)}, 4, true)});
        QVERIFY(isAbout(maskedAreas(mask).area, pi * (100 - 16)));
        const SurfaceMask again(
            box_, {strokeOf({top(0)}, 10), strokeOf({top(0)}, 4, true), strokeOf({top(0)}, 4)});
        QVERIFY(isAbout(maskedAreas(again).area, pi * 100));
    }

    void surfaceMask_faceOfBox_coversIt() {
        MaskMark face;
        face.extent = MarkExtent::Face;
        face.place = {Millimetres(3), Millimetres(20), Millimetres(1)};
        QVERIFY(isAbout(maskedAreas(SurfaceMask(box_, {face})).area, 100 * 60));
        face.extent = MarkExtent::Material;
        QVERIFY(isAbout(maskedAreas(SurfaceMask(box_, {face})).area, surfaceArea(box_->mesh)));
    }

    void maskedAreas_twoDabs_areTwo() {
        const SurfaceMask mask(box_, {strokeOf({top(-20)}, 4), strokeOf({top(20)}, 4)});
        QCOMPARE(maskedAreas(mask).count, std::size_t(2));
        const SurfaceMask joined(box_, {strokeOf({top(-20)}, 4), strokeOf({top(20)}, 4),
                                        strokeOf({top(-20), top(20)}, 1)});
        QCOMPARE(maskedAreas(joined).count, std::size_t(1));
    }

    // Two parallel faces at 45°, 5 mm apart: their boxes overlap, the faces are two areas.
    void maskedAreas_bothSidesOfSlantedPlate_areTwo() {
        TriangleMesh plate = boxMesh({60, 5, 60});
        const Eigen::AngleAxisf turn(float(pi / 4), Eigen::Vector3f(1, 0, 1).normalized());
        for (Eigen::Vector3f& place : plate.positions) {
            place = turn * place;
        }
        std::vector<MaskMark> faces(2);
        for (std::size_t side = 0; side < 2; ++side) {
            const Eigen::Vector3f middle = turn * Eigen::Vector3f(1, side == 0 ? 2.5f : -2.5f, 2);
            faces[side].extent = MarkExtent::Face;
            faces[side].place = {Millimetres(double(middle.x())), Millimetres(double(middle.y())),
                                 Millimetres(double(middle.z()))};
        }
        const MaskedAreas areas = maskedAreas(SurfaceMask(modelOf(plate), faces));
        QCOMPARE(areas.count, std::size_t(2));
        QVERIFY(isAbout(areas.area, 2 * 60 * 60));
    }

    void maskedAreas_bothSidesOfFoil_areOne() {
        MaskMark face;
        face.extent = MarkExtent::Face;
        face.place[1] = Millimetres(1);
        MaskMark back = face;
        back.place[1] = Millimetres(-1);
        QCOMPARE(maskedAreas(SurfaceMask(modelOf(boxMesh({60, 0.4, 60})), {face, back})).count,
                 std::size_t(1));
    }

    void surfaceMask_laterFaceOrMaterial_replacesEarlierMarks() {
        MaskMark upper;
        upper.extent = MarkExtent::Face;
        upper.place = {Millimetres(3), Millimetres(20), Millimetres(1)};
        MaskMark open = upper;
        open.erases = true;
        MaskMark all = upper;
        all.extent = MarkExtent::Material;
        const auto areaAfter = [&](const std::vector<MaskMark>& marks) {
            return maskedAreas(SurfaceMask(box_, marks)).area;
        };
        QCOMPARE(areaAfter({strokeOf({top(0)}, 10), open}), 0.0);
        QVERIFY(isAbout(areaAfter({all, open}), surfaceArea(box_->mesh) - 100 * 60));
        QVERIFY(isAbout(areaAfter({open, all}), surfaceArea(box_->mesh)));
        QVERIFY(isAbout(areaAfter({upper, open, strokeOf({top(0)}, 10)}), pi * 100));
    }

    void pieces_strokesAcrossTheWholePart_areLimited() {
        BrushPath path;
        for (int point = 0; point < 2000; ++point) {
            const double side = point % 2 == 0 ? -30 : 30;
            path.push_back(pointAt({0.04 * point - 40, 20, side}, up));
        }
        const SurfaceMask mask(box_, std::vector<MaskMark>(5, strokeOf(path, 0.1)));
        QVERIFY(mask.pieces().size() < 2'000'000);
    }

    void covers_places_agreeWithTheStroke() {
        const SurfaceMask mask(box_, {strokeOf({top(-20), top(15)}, 4)});
        const auto isCovered = [&](float x, float z) {
            const SurfaceQuery query(box_->mesh);
            return mask.covers(query.closest({x, 20, z}).point);
        };
        QVERIFY(isCovered(0, 3.99f));
        QVERIFY(!isCovered(0, 4.01f));
        QVERIFY(isCovered(18.99f, 0));
        QVERIFY(!isCovered(19.01f, 0));
    }

    void surfaceMask_marksAdded_equalsOneOfAll() {
        const std::vector<MaskMark> marks{strokeOf({top(0)}, 10), strokeOf({top(5)}, 3, true)};
        const auto first = surfaceMask(box_, {marks[0]});
        const auto both = surfaceMask(box_, marks, first);
        QCOMPARE(areaOf(both->pieces()), areaOf(surfaceMask(box_, marks)->pieces()));
        QCOMPARE(surfaceMask(box_, marks, both), both);
        QVERIFY(!surfaceMask(box_, {}, both));
    }

    void strokePatch_drawnPointByPoint_equalsTheMask() {
        const TriangleMesh ball = sphereMesh(25, 60, 120);
        const SurfaceQuery query(ball);
        StrokePatch patch(ball, query, Millimetres(6));
        for (int step = 0; step <= 20; ++step) {
            const double angle = 0.08 * step;
            const Eigen::Vector3d outward(std::sin(angle), std::cos(angle), 0);
            patch.add(pointAt(25 * outward, outward));
        }
        const SurfaceMask mask(modelOf(ball), {strokeOf(patch.path(), 6)});
        QVERIFY(isAbout(areaOf(patch.pieces()), maskedAreas(mask).area));
    }

private:
    // A point of the upper face, at z = 0.
    static BrushPoint top(double x) { return pointAt({x, 20, 0}, up); }

    const std::shared_ptr<const TexturedMesh> box_ = modelOf(boxMesh({100, 40, 60}));
};

QTEST_GUILESS_MAIN(SurfaceMaskTest)
#include "SurfaceMaskTest.moc"
