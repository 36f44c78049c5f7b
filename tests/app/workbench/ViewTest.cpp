// Tests the 3D view with a real OpenGL context: drawing, camera, rays, rings and arrows.
#include "WindowDriver.h"
#include "geometry/Shapes.h"
#include "viewport/SpaceMouse.h"
#include "workbench/appearance/ViewTheme.h"
#include "workbench/document/PoseEdits.h"
#include "workbench/view/DipScene.h"
#include "workbench/view/MeasureTool.h"
#include "workbench/view/TypedDrag.h"

#include <QApplication>
#include <QMouseEvent>
#include <QRegularExpression>

using namespace dipwright;

namespace {

std::shared_ptr<TexturedMesh> redSphere() {
    auto model = std::make_shared<TexturedMesh>();
    model->mesh = sphereMesh(30, 24, 48);
    const std::size_t count = model->mesh.triangles.size();
    model->textureCoordinates.resize(count);
    for (auto& corners : model->textureCoordinates) {
        corners.fill(Eigen::Vector2f::Constant(std::numeric_limits<float>::quiet_NaN()));
    }
    model->material.resize(count, 0);
    model->materials = {Material{QStringLiteral("red"), QColor(220, 30, 30), -1}};
    model->chart.resize(count, 0);
    return model;
}

bool isReddish(QRgb pixel) {
    return qRed(pixel) > 2 * qGreen(pixel) && qRed(pixel) > 60;
}

// Counts reddish pixels, without the right quarter, where the direction cube has a red ball for X.
int countReddish(const QImage& picture) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width() * 3 / 4; ++x) {
            count += isReddish(picture.pixel(x, y));
        }
    }
    return count;
}

} // namespace

class ViewTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        view_ = std::make_unique<DipView>();
        if (!view_->isUsable()) {
            if (qEnvironmentVariableIsSet("CI")) {
                QFAIL("No OpenGL context can be made here; tests of the view need one");
            }
            QSKIP("No OpenGL context can be made here");
        }
        view_->resize(480, 360);
        view_->setColours(viewColours(false));
        view_->setTank({210, 297}, 60);
        view_->setBody(redSphere());
        Eigen::Isometry3d lifted = Eigen::Isometry3d::Identity();
        lifted.translation() = Eigen::Vector3d(0, 30, 0);
        view_->setBodyTransform(lifted);
        view_->show();
        QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
        view_->picture();
    }
    void cleanup() { view_.reset(); }

    void view_body_isDrawn() {
        const int red = countReddish(view_->picture());
        QVERIFY2(red > 500,
                 qPrintable(QStringLiteral("%1 red pixels, expected more than 500").arg(red)));
        view_->setBodyVisible(false);
        QCOMPARE(countReddish(view_->picture()), 0);
    }

    void view_film_isDrawnAtItsPlace() {
        view_->setBodyVisible(false);
        view_->look(ViewDirection::Top);
        QImage half(2, 1, QImage::Format_RGB32); // left half red, right half green
        half.setPixel(0, 0, qRgb(230, 0, 0));
        half.setPixel(1, 0, qRgb(0, 200, 0));
        view_->setFilm({{{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {{0, 2, 1}, {1, 2, 3}}},
                       std::vector<float>{-100, 0, -140, 100, 0, -140, -100, 0, 140, 100, 0, 140});
        view_->setFilmPicture(half.scaled(64, 64));
        const QImage picture = view_->picture();
        const auto at = [&](float x, float z) {
            return picture.pixel(view_->positionOf({x, 0, z}).toPoint());
        };
        QVERIFY(isReddish(at(-60, 0)));
        QVERIFY(!isReddish(at(60, 0)));
        QVERIFY(qGreen(at(60, 0)) > 80);
    }

    void view_filmColours_areDrawn() {
        view_->setBodyVisible(false);
        view_->look(ViewDirection::Top);
        view_->setFilm({{{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {{0, 2, 1}, {1, 2, 3}}},
                       std::vector<float>{-100, 0, -140, 100, 0, -140, -100, 0, 140, 100, 0, 140});
        view_->setFilmColours(std::vector<QRgb>(4, qRgb(230, 0, 0)));
        QVERIFY(countReddish(view_->picture()) > 5000);
        view_->setFilmColours({});
        QCOMPARE(countReddish(view_->picture()), 0);
    }

    void view_tornFilm_isNotDrawn() {
        view_->setBodyVisible(false);
        view_->look(ViewDirection::Top);
        FilmShape shape{{{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {{0, 2, 1}, {1, 2, 3}}, 130};
        std::vector<float> positions{-40, 0, -40, 40, 0, -40, -40, 0, 40, 40, 0, 40};
        view_->setFilm(shape, positions);
        view_->setFilmColours(std::vector<QRgb>(4, qRgb(230, 0, 0)));
        const int whole = countReddish(view_->picture());
        positions[11] = 140; // stretches the film at its last point by 100 mm
        view_->setFilmPositions(positions);
        const int torn = countReddish(view_->picture());
        QVERIFY2(torn > 0.4 * whole && torn < 0.6 * whole,
                 qPrintable(QStringLiteral("%1 of %2 red pixels remain, expected 40 to 60 %")
                                .arg(torn)
                                .arg(whole)));
        positions[11] = 40;
        view_->setFilmPositions(positions);
        QCOMPARE(countReddish(view_->picture()), whole);
    }

    void view_section_cutsBodyOpen() {
        view_->look(ViewDirection::Front);
        const int whole = countReddish(view_->picture());
        SectionPlane plane;
        plane.axis = 1;
        plane.place = 30;
        plane.extent = BoundingBox(Eigen::Vector3f(-30, -60, -30), Eigen::Vector3f(30, 60, 30));
        view_->setSection(plane); // the lower half remains
        const int half = countReddish(view_->picture());
        QVERIFY2(half > 0.35 * whole && half < 0.65 * whole,
                 qPrintable(QStringLiteral("%1 of %2 red pixels remain, expected 35 to 65 %")
                                .arg(half)
                                .arg(whole)));
        view_->look(ViewDirection::Top); // the cut surface is filled
        const QImage filled = view_->picture();
        QVERIFY(!isReddish(filled.pixel(view_->positionOf({0, 30, 0}).toPoint())));
        plane.after = true;
        view_->setSection(plane);
        QVERIFY(countReddish(view_->picture()) > 500);
        // A ray begins at the section plane, because everything above it is hidden.
        plane.after = false;
        view_->setSection(plane);
        view_->picture();
        const ViewRay ray = view_->rayAt(view_->positionOf({0, 0, 0}));
        QVERIFY2(std::abs(ray.origin.y() - 30) < 0.01f,
                 qPrintable(QStringLiteral("the ray begins at y = %1 mm, expected 30 ± 0.01 mm")
                                .arg(double(ray.origin.y()))));
        view_->setSection({});
        view_->look(ViewDirection::Front);
        QCOMPARE(countReddish(view_->picture()), whole);
    }

    void view_dragSectionFrame_emitsPlace() {
        view_->look(ViewDirection::Oblique);
        SectionPlane plane;
        plane.axis = 0;
        plane.extent = BoundingBox(Eigen::Vector3f(-40, 0, -40), Eigen::Vector3f(40, 60, 40));
        view_->setSection(plane);
        view_->picture();
        QSignalSpy dragged(view_.get(), &DipView::sectionDragged);
        const QPointF from = view_->positionOf({0, 60, 10}), to = view_->positionOf({15, 60, 10});
        QTest::mousePress(view_.get(), Qt::LeftButton, {}, from.toPoint());
        QTest::mouseMove(view_.get(), to.toPoint());
        QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, to.toPoint());
        QVERIFY(!dragged.empty());
        const double place = dragged.back().front().toDouble();
        QVERIFY2(
            std::abs(place - 15) < 2,
            qPrintable(QStringLiteral("the section was dragged to x = %1 mm, expected 15 ± 2 mm")
                           .arg(place)));
    }

    void view_filmOpacity_showsBodyBelow() {
        view_->look(ViewDirection::Top);
        view_->setFilm(
            {{{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {{0, 2, 1}, {1, 2, 3}}},
            std::vector<float>{-100, 70, -140, 100, 70, -140, -100, 70, 140, 100, 70, 140});
        view_->setFilmColours(std::vector<QRgb>(4, qRgb(240, 240, 240)));
        QCOMPARE(countReddish(view_->picture()), 0);
        view_->setFilmOpacity(0.2);
        QVERIFY(countReddish(view_->picture()) > 500);
        view_->setFilmOpacity(1);
        QCOMPARE(countReddish(view_->picture()), 0);
    }

    void topView_axes_xRightZDown() {
        view_->look(ViewDirection::Top);
        view_->picture();
        const QPointF middle = view_->positionOf({0, 0, 0});
        QVERIFY(view_->positionOf({50, 0, 0}).x() > middle.x() + 10);
        QVERIFY(view_->positionOf({0, 0, 50}).y() > middle.y() + 10);
    }

    void rayAt_positionOfPlace_passesThroughIt() {
        const Eigen::Vector3f place(20, 5, -30);
        const ViewRay ray = view_->rayAt(view_->positionOf(place));
        const Eigen::Vector3f beside =
            (place - ray.origin) - ray.direction * ray.direction.dot(place - ray.origin);
        QVERIFY(beside.norm() < 0.1f);
    }

    void camera_drag_turnsAndStaysUpright() {
        const QPointF before = view_->positionOf({50, 0, 0});
        drag({240, 300}, {300, 280});
        const QPointF after = view_->positionOf({50, 0, 0});
        QVERIFY(QLineF(before, after).length() > 5);
        // Upright means that a vertical line is shown vertical.
        const QPointF low = view_->positionOf({0, 0, 0}), high = view_->positionOf({0, 60, 0});
        QVERIFY(std::abs(low.x() - high.x()) < 1.5);
        QVERIFY(high.y() < low.y());
    }

    void camera_viewResized_keepsTankInView() {
        const auto showsTheTank = [this] {
            view_->picture();
            const QRectF view = view_->rect();
            return view.contains(view_->positionOf({-105, 0, 148})) &&
                   view.contains(view_->positionOf({105, 0, 148})) &&
                   view.contains(view_->positionOf({105, 0, -148}));
        };
        QVERIFY(showsTheTank());
        view_->resize(260, 520);
        QVERIFY(showsTheTank());
        QTest::keyClick(view_.get(), Qt::Key_Plus); // from now on, the user controls the camera
        view_->picture();
        const double near =
            QLineF(view_->positionOf({0, 0, 0}), view_->positionOf({50, 0, 0})).length();
        view_->resize(520, 520); // the same height, so the zoom stays
        view_->picture();
        const double then =
            QLineF(view_->positionOf({0, 0, 0}), view_->positionOf({50, 0, 0})).length();
        QVERIFY(std::abs(near - then) < 1);
    }

    void camera_fitBody_showsBodyLargerAlsoAfterResize() {
        const auto bodyHeight = [this] {
            view_->picture();
            return QLineF(view_->positionOf({0, 0, 0}), view_->positionOf({0, 60, 0})).length();
        };
        const double withFilm = bodyHeight();
        view_->fitBody();
        const double alone = bodyHeight();
        QVERIFY2(alone > 1.5 * withFilm,
                 qPrintable(QStringLiteral("%1 px, with film %2 px").arg(alone).arg(withFilm)));
        view_->resize(960, 720);
        QVERIFY(bodyHeight() > 1.8 * alone);
        view_->resize(480, 360);
        view_->fit();
        QVERIFY(std::abs(bodyHeight() - withFilm) < 1);
    }

    void camera_fitBodyToHandle_showsRingsAndArrows() {
        view_->setRotationRings(true, {0, 30, 0}, 40);
        view_->setMoveArrows({true, false, true}, {0, 30, 0}, 45, 60);
        view_->fitBodyToHandle();
        for (const ViewDirection side : {ViewDirection::Oblique, ViewDirection::Front}) {
            view_->look(side); // fits the same places
            view_->picture();
            for (const Eigen::Vector3f& place :
                 {Eigen::Vector3f(0, 70, 0), Eigen::Vector3f(0, -10, 0), Eigen::Vector3f(60, 30, 0),
                  Eigen::Vector3f(0, 30, 60)}) {
                QVERIFY(QRectF(view_->rect()).contains(view_->positionOf(place)));
            }
            QVERIFY(!QRectF(view_->rect()).contains(view_->positionOf({105, 0, 148})));
        }
    }

    void press_onRing_leavesThePlaceUnderTheCursor() {
        view_->look(ViewDirection::Top);
        view_->setRotationRings(true, {0, 30, 0}, 60);
        const QImage before = view_->picture();
        connect(view_.get(), &DipView::hoverLeft, view_.get(), [this] { view_->setMarker({}); });
        view_->setMarker(Eigen::Vector3f(0, 65, 0));
        QVERIFY(view_->picture() != before);
        const QPoint onRing = view_->positionOf({42.4f, 30, 42.4f}).toPoint();
        QTest::mousePress(view_.get(), Qt::LeftButton, {}, onRing);
        QCOMPARE(view_->picture(), before);
        QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, onRing);
    }

    void coverageLook_tornFilm_isMarked() {
        DipScene scene(*view_);
        Project project;
        project.model = redSphere();
        scene.setProject(project, 0);
        auto coverage = std::make_shared<Coverage>();
        const std::size_t count = project.model->mesh.triangles.size();
        coverage->covered.assign(count, 1);
        coverage->marks.assign(count, 0);
        auto result = std::make_shared<JobResult>();
        result->project = project;
        result->immersions.resize(1);
        const auto show = [&](std::uint8_t marks) {
            coverage->marks.assign(count, marks);
            coverage->marked = {};
            coverage->marked.add(marks, 100);
            result->immersions[0].coverage = std::make_shared<const Coverage>(*coverage);
            scene.setResult(std::make_shared<const JobResult>(*result), nullptr);
        };
        scene.setShowHandles(false); // a red handle would be counted
        show(0);
        scene.setBodyLook(BodyLook::Coverage);
        QCOMPARE(countReddish(view_->picture()), 0);
        const QImage unmarked = view_->grab().toImage();
        show(std::uint8_t(solver::PointMark::Torn));
        QVERIFY(countReddish(view_->picture()) > 500);
        // The legend has one more line.
        const QRect corner(0, 200, 130, 160);
        QVERIFY(countReddish(view_->grab().toImage().copy(corner)) >
                countReddish(unmarked.copy(corner)) + 100);
        scene.setBodyLook(BodyLook::Own);
        QCOMPARE(countReddish(view_->grab().toImage().copy(corner)), 0);
    }

    void stroke_drag_leavesCamera() {
        std::vector<ViewRay> stroke;
        int finished = 0;
        const auto along = connect(view_.get(), &DipView::stroked,
                                   [&](const ViewRay& ray) { stroke.push_back(ray); });
        const auto end = connect(view_.get(), &DipView::strokeFinished, [&] { ++finished; });
        const QPointF before = view_->positionOf({50, 0, 0});
        bool begins = true;
        view_->addStroke([&](const ViewRay&) { return begins; });
        WindowDriver::drag(*view_, {0.4, 0.4}, {0.6, 0.5});
        view_->picture();
        QCOMPARE(view_->positionOf({50, 0, 0}), before);
        QVERIFY(stroke.size() > 5);
        QCOMPARE(finished, 1);
        stroke.clear();
        begins = false;
        WindowDriver::drag(*view_, {0.4, 0.4}, {0.6, 0.5});
        view_->picture();
        QVERIFY(QLineF(before, view_->positionOf({50, 0, 0})).length() > 2);
        QVERIFY(stroke.empty());
        disconnect(along);
        disconnect(end);
    }

    void camera_arrowKey_turns() {
        const QPointF before = view_->positionOf({50, 0, 0});
        QTest::keyClick(view_.get(), Qt::Key_Left);
        view_->picture();
        QVERIFY(QLineF(before, view_->positionOf({50, 0, 0})).length() > 2);
    }

    void view_letterKeys_changeNothing() {
        const QImage before = view_->picture();
        for (const Qt::Key key : {Qt::Key_W, Qt::Key_3, Qt::Key_R, Qt::Key_S, Qt::Key_F}) {
            QTest::keyClick(view_.get(), key);
        }
        QCOMPARE(view_->picture(), before);
    }

    void turned_threeTurns_areAboutWorldAxes() {
        Immersion immersion;
        immersion = turned(immersion, 0, 40);
        QCOMPARE(immersion.rotation[0].value(), 40);
        immersion = turned(immersion, 1, -25);
        immersion = turned(immersion, 2, 70);
        const TriangleMesh body = redSphere()->mesh;
        using Eigen::AngleAxisd, Eigen::Vector3d;
        const auto about = [](double degrees, const Vector3d& axis) {
            return AngleAxisd(radians(Degrees(degrees)), axis);
        };
        const Eigen::Matrix3d wanted =
            (about(70, Vector3d::UnitZ()) * about(-25, Vector3d::UnitY()) *
             about(40, Vector3d::UnitX()))
                .toRotationMatrix();
        QVERIFY((poseTransform(body, immersion).linear() - wanted).norm() < 0.01); // 0.1° steps
    }

    void turned_secondTurn_keepsAnglesNear() {
        const Immersion immersion = turned(Immersion{}, 2, -30);
        QCOMPARE(immersion.rotation, (std::array{Degrees(0), Degrees(0), Degrees(-30)}));
        QCOMPARE(turned(immersion, 2, -170).rotation[2].value(), -200);
        // −370° is out of range; −10° is the same angle.
        QCOMPARE(turned(turned(immersion, 2, -170), 2, -170).rotation[2].value(), -10);
    }

    void dragOfTheBody_by0_changesNothing() {
        Immersion immersion;
        immersion.rotation = {Degrees(12.34567), Degrees(1), Degrees(2)};
        immersion.offset = {Millimetres(2.54), Millimetres(0.123456789)};
        QCOMPARE(turned(immersion, 1, 0), immersion);
        QCOMPARE(moved(immersion, 0, 0, {}), immersion);
        QCOMPARE(moved(immersion, 0, 3.175, {}).offset[0].value(), 5.715); // 1/8 inch
    }

    void rotationRing_drag_turnsBody() {
        view_->look(ViewDirection::Top);
        view_->setRotationRings(true, {0, 30, 0}, 60);
        view_->picture();
        QSignalSpy dragged(view_.get(), &DipView::rotationDragged);
        QSignalSpy finished(view_.get(), &DipView::rotationFinished);
        // A quarter turn along the ring round Y, which looks like a circle from above.
        const float diagonal = 60 * std::sqrt(0.5f);
        const QPointF from = view_->positionOf({diagonal, 30, diagonal});
        const QPointF to = view_->positionOf({diagonal, 30, -diagonal});
        drag(from.toPoint(), to.toPoint());
        QCOMPARE(finished.count(), 1);
        QVERIFY(!dragged.isEmpty());
        QCOMPARE(dragged.last()[0].toInt(), 1);
        QVERIFY(std::abs(dragged.last()[1].toDouble() - 90) < 3);
    }

    void moveArrow_drag_movesBody() {
        view_->look(ViewDirection::Top);
        view_->setMoveArrows({true, true, true}, {0, 30, 0}, 20, 40);
        view_->picture();
        QSignalSpy moved(view_.get(), &DipView::moveDragged);
        QSignalSpy finished(view_.get(), &DipView::moveFinished);
        const QPoint from = view_->positionOf({30, 30, 0}).toPoint();
        const QPoint to = view_->positionOf({42, 30, 9}).toPoint();
        drag(from, to);
        QCOMPARE(finished.count(), 1);
        QCOMPARE(moved.last()[0].toInt(), 0);
        QVERIFY(std::abs(moved.last()[1].toDouble() - 12) < 1);
        drag(from, to, Qt::ShiftModifier);
        QCOMPARE(moved.last()[1].toDouble(), 2 * arrowStep);
        // The arrow along Y points at the camera and cannot be dragged.
        moved.clear();
        drag(view_->positionOf({0, 65, 0}).toPoint(), to);
        QVERIFY(moved.isEmpty());
    }

    void drag_typedNumber_isTaken() {
        const TypedDrag typed(*view_);
        QSignalSpy turned(view_.get(), &DipView::rotationDragged);
        QSignalSpy finished(view_.get(), &DipView::rotationFinished);
        QSignalSpy clicked(view_.get(), &DipView::clicked);
        const QPoint onRing = pressRing();
        QTest::keyClicks(view_.get(), QStringLiteral("-305"));
        QTest::keyClick(view_.get(), Qt::Key_Backspace);
        QCOMPARE(turned.last()[0].toInt(), 1);
        QCOMPARE(turned.last()[1].toDouble(), -30.0);
        QTest::mouseMove(view_.get(), onRing + QPoint(30, 30)); // no longer turns the part
        QCOMPARE(turned.last()[1].toDouble(), -30.0);
        QTest::keyClick(view_.get(), Qt::Key_Return);
        QCOMPARE(finished.count(), 1);
        QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, onRing);
        QCOMPARE(finished.count(), 1);
        QVERIFY(clicked.isEmpty());
    }

    void drag_escape_takesItBack() {
        const TypedDrag typed(*view_);
        QSignalSpy turned(view_.get(), &DipView::rotationDragged);
        QSignalSpy finished(view_.get(), &DipView::rotationFinished);
        const QPoint onRing = pressRing();
        QTest::keyClicks(view_.get(), QStringLiteral("45"));
        QTest::keyClick(view_.get(), Qt::Key_Escape);
        QCOMPARE(turned.last()[1].toDouble(), 0.0);
        QCOMPARE(finished.count(), 1);
        QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, onRing);
    }

    void dragArrow_typedInches_areMillimetres() {
        const TypedDrag typed(*view_);
        view_->look(ViewDirection::Top);
        view_->setMoveArrows({true, true, true}, {0, 30, 0}, 20, 40);
        view_->picture();
        QSignalSpy moved(view_.get(), &DipView::moveDragged);
        const QPoint onArrow = view_->positionOf({30, 30, 0}).toPoint();
        QTest::mousePress(view_.get(), Qt::LeftButton, {}, onArrow);
        QTest::keyClicks(view_.get(), QStringLiteral("2in"));
        QCOMPARE(moved.last()[0].toInt(), 0);
        QCOMPARE(moved.last()[1].toDouble(), 50.8);
        QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, onArrow);
    }

    void pin_clicked_isNoClickOnTheBody() {
        view_->setPins({{{0, 60, 0}, {0, 1, 0}, Qt::red, QStringLiteral("Torn film")}});
        view_->picture();
        QSignalSpy pins(view_.get(), &DipView::pinClicked);
        QSignalSpy clicked(view_.get(), &DipView::clicked);
        const QPoint pin = view_->positionOf({0, 60, 0}).toPoint();
        QVERIFY(isReddish(view_->grab().toImage().pixel(pin + QPoint(4, 0))));
        QTest::mouseClick(view_.get(), Qt::LeftButton, {}, pin);
        QCOMPARE(pins.count(), 1);
        QVERIFY(clicked.isEmpty());
        QTest::mouseClick(view_.get(), Qt::LeftButton, {}, pin + QPoint(40, 0));
        QCOMPARE(pins.count(), 1);
        QCOMPARE(clicked.count(), 1);
        view_->setCatchPins(false); // as while the user measures
        QTest::mouseClick(view_.get(), Qt::LeftButton, {}, pin);
        QCOMPARE(pins.count(), 1);
        QCOMPARE(clicked.count(), 2);
        view_->setCatchPins(true);
    }

    void cradle_shown_coversTheBodyTranslucently() {
        const QImage bare = view_->picture();
        auto cradle = std::make_shared<TriangleMesh>(sphereMesh(33, 24, 48));
        view_->setCradle(cradle);
        Eigen::Isometry3d lifted = Eigen::Isometry3d::Identity();
        lifted.translation() = Eigen::Vector3d(0, 30, 0);
        view_->setCradleTransform(lifted);
        const QImage covered = view_->picture();
        const QPoint middle = view_->positionOf({0, 30, 0}).toPoint();
        QVERIFY(covered.pixel(middle) != bare.pixel(middle));
        QVERIFY(isReddish(covered.pixel(middle))); // the body is seen through it
        view_->setCradle(nullptr);
        QCOMPARE(view_->picture(), bare);
    }

    void measure_twoPlaces_saysStraightAndAlongTheSurface() {
        DipScene scene(*view_);
        scene.setShowHandles(false); // they would catch the clicks
        Project project;
        project.model = redSphere();
        scene.setProject(project, 0);
        Messages messages;
        MeasureTool tool(*view_, scene, messages);
        tool.setActive(true);
        QSignalSpy said(&messages, &Messages::said);
        view_->look(ViewDirection::Front);
        view_->picture();
        for (const float x : {-18.0f, 18.0f}) {
            const Eigen::Vector3f place = scene.toWorld({x, 0, 24});
            QTest::mouseClick(view_.get(), Qt::LeftButton, {}, view_->positionOf(place).toPoint());
        }
        QTRY_COMPARE(said.count(), 3); // the second place, the distance, the way along the surface
        const QStringList numbers = said.last()[0].toString().split(
            QRegularExpression(QStringLiteral("[^0-9.]+")), Qt::SkipEmptyParts);
        const double straight = numbers.front().toDouble(), along = numbers.back().toDouble();
        QVERIFY2(std::abs(straight - 36) < 1, qPrintable(said.last()[0].toString()));
        QVERIFY2(std::abs(along - 38.6) < 1.2, qPrintable(said.last()[0].toString()));
    }

    void spaceMouse_motion_movesTheBodyWithThePuck() {
        view_->look(ViewDirection::Front);
        view_->picture();
        const auto fly = [this](const PuckMotion& motion) {
            view_->fly(motion);
            view_->picture();
        };
        const QPointF middle = view_->positionOf({0, 30, 0});
        fly({{0.1, 0, 0}, Eigen::Vector3d::Zero()}); // pushed to the right
        QVERIFY(view_->positionOf({0, 30, 0}).x() > middle.x() + 5);
        const double width =
            QLineF(view_->positionOf({-30, 30, 0}), view_->positionOf({30, 30, 0})).length();
        fly({{0, 0, 0.2}, Eigen::Vector3d::Zero()}); // pushed away
        QVERIFY(QLineF(view_->positionOf({-30, 30, 0}), view_->positionOf({30, 30, 0})).length() <
                0.95 * width);
        const QPointF front = view_->positionOf({0, 30, 30});
        fly({Eigen::Vector3d::Zero(), {0, 0.2, 0}}); // turned
        QVERIFY(std::abs(view_->positionOf({0, 30, 30}).x() - front.x()) > 3);
    }

    void wheel_zoom_keepsPlaceUnderCursor() {
        view_->look(ViewDirection::Top);
        view_->setParallelProjection(true);
        view_->picture();
        const QPointF cursor = view_->positionOf({50, 0, 0}), other = view_->positionOf({0, 0, 0});
        QWheelEvent wheel(cursor, view_->mapToGlobal(cursor), {}, {0, 240}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(view_.get(), &wheel);
        view_->picture();
        QVERIFY(QLineF(cursor, view_->positionOf({50, 0, 0})).length() < 0.5);
        QVERIFY(QLineF(cursor, view_->positionOf({0, 0, 0})).length() >
                1.4 * QLineF(cursor, other).length());
    }

    void view_drag_isNoClick() {
        QSignalSpy clicked(view_.get(), &DipView::clicked);
        QTest::mouseClick(view_.get(), Qt::LeftButton, {}, {240, 180});
        QCOMPARE(clicked.count(), 1);
        drag({240, 180}, {280, 200});
        QCOMPARE(clicked.count(), 1);
    }

    void parallelProjection_equalLengths_lookEqual() {
        view_->look(ViewDirection::Top);
        view_->setParallelProjection(true);
        view_->picture();
        const double low =
            QLineF(view_->positionOf({0, 0, 0}), view_->positionOf({50, 0, 0})).length();
        const double high =
            QLineF(view_->positionOf({0, 60, 0}), view_->positionOf({50, 60, 0})).length();
        QVERIFY(std::abs(low - high) < 0.5);
    }

private:
    // Presses the left button on the ring about Y. Returns the place.
    QPoint pressRing() {
        view_->look(ViewDirection::Top);
        view_->setRotationRings(true, {0, 30, 0}, 60);
        view_->picture();
        const QPoint onRing = view_->positionOf({42.4f, 30, 42.4f}).toPoint();
        QTest::mousePress(view_.get(), Qt::LeftButton, {}, onRing);
        return onRing;
    }

    void drag(QPoint from, QPoint to, Qt::KeyboardModifiers keys = Qt::NoModifier) {
        QTest::mousePress(view_.get(), Qt::LeftButton, {}, from);
        for (int step = 1; step <= 4; ++step) {
            const QPoint place = from + (to - from) * step / 4;
            QMouseEvent move(QEvent::MouseMove, place, view_->mapToGlobal(place), Qt::NoButton,
                             Qt::LeftButton, keys);
            QApplication::sendEvent(view_.get(), &move);
        }
        QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, to);
        view_->picture();
    }

    std::unique_ptr<DipView> view_;
};

int main(int argc, char* argv[]) {
    QApplication application(argc, argv);
    ViewTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "ViewTest.moc"
