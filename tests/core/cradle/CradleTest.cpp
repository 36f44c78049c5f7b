// Tests cradles against exact values for simple bodies. The films are laid on the bodies by
// formulas, without a solver.
#include "cradle/Cradle.h"
#include "DippedByHand.h"
#include "cradle/CradleFiles.h"
#include "cradle/ReducedSurface.h"
#include "dip/JigModel.h"
#include "geometry/DistanceField.h"
#include "geometry/Shapes.h"
#include "geometry/SurfaceSamples.h"
#include "import/trusted/ImportModel.h"
#include "marks/SurfaceMask.h"
#include "parallel/Threads.h"
#include "settings/FilmSettings.h"
#include "sheet/page/Sheet.h"

#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace dipwright;

namespace {

constexpr double radius = 25;
const QString hash = QStringLiteral("0a1b2c3d4e5f");

// Returns coarse settings for a small cradle, so that the tests are fast.
CradleSettings settings() {
    CradleSettings result;
    result.pinSpan = Millimetres(80);
    result.reach = Millimetres(10);
    return result;
}

TexturedMesh ball() {
    return test::plainModel(sphereMesh(radius, 90, 180), Qt::white);
}

// Returns film up to the ball's equator.
std::shared_ptr<const LaidFilm> halfPainted() {
    static const auto laid =
        test::laid(ball().mesh, test::viscousOnSphere(test::a4Grid(), radius, pi / 2));
    return laid;
}

ProcessSettings deep(std::optional<Millimetres> depth) {
    ProcessSettings process;
    process.depth = depth;
    return process;
}

// Returns the same film on a ball that moves on a path.
std::shared_ptr<const LaidFilm> halfPaintedOn(const DipPath& path,
                                              std::optional<Millimetres> depth = {}) {
    Immersion immersion;
    immersion.path = path;
    const ProcessSettings process = deep(depth);
    return layFilm(std::make_shared<const PosedBody>(posedBody(ball().mesh, immersion, process)),
                   test::viscousOnSphere(test::a4Grid(), radius, pi / 2), process);
}

// Returns an earlier dip with the ball the other way up. Its film lies round the ball's top, up to
// `angle` from the pole.
LaidFilm paintedFromAbove(double angle) {
    Immersion turned;
    turned.rotation[0] = Degrees(180);
    const auto body = std::make_shared<const PosedBody>(posedBody(ball().mesh, turned));
    const auto laid = layFilm(body, test::viscousOnSphere(test::a4Grid(), radius, angle), {});
    return {body, laid->film(), laid->contact()};
}

Cradle cradleOf(const LaidFilm& laid, const CradleSettings& wanted = settings(),
                const ProcessSettings& process = {}, std::vector<const LaidFilm*> earlier = {},
                const Progress& progress = {}, const SurfaceMask* mask = nullptr) {
    const Immersion immersion;
    const TriangleMesh inModel = transformed(laid.body().mesh, laid.body().modelToPose.inverse());
    const DistanceField field = buildDistanceField(inModel, 96, {});
    const DatumPins pins = datumPins(Sheet(), FilmSettings(), wanted.pinSpan);
    return makeCradle({laid, std::move(earlier), field, immersion, process, pins, 1, hash, mask},
                      wanted, progress);
}

// Returns the cradle of the half painted ball with the settings above.
const Cradle& ballsCradle() {
    static const Cradle cradle = cradleOf(*halfPainted());
    return cradle;
}

void isSound(const Cradle& cradle) {
    QVERIFY(cradle.check.isClosed);
    QCOMPARE(cradle.check.parts, 1);
    QVERIFY(cradle.check.volume > 0);
    QVERIFY2(cradle.check.leastGap >= cradle.clearance - cradle.cell / 2,
             qPrintable(QStringLiteral("smallest gap %1 mm, expected the clearance of %2 mm")
                            .arg(cradle.check.leastGap)
                            .arg(cradle.clearance)));
    QVERIFY(cradle.check.comesOut);
}

} // namespace

class CradleTest : public QObject {
    Q_OBJECT

private slots:
    void makeCradle_jig_notesThatEachPartNeedsAHolder() {
        const auto ball = [](double ofRadius, double x, double height) {
            JigPart part;
            part.model = std::make_shared<const TexturedMesh>(
                test::plainModel(sphereMesh(ofRadius, 40, 80), Qt::white));
            part.placed.offset[0] = Millimetres(x);
            part.height = Millimetres(height);
            return part;
        };
        const TexturedMesh jig = jigModel({ball(radius, 0, 0), ball(5, -32, 38), ball(5, 32, 38)});
        CradleSettings coarse = settings();
        coarse.cell = Millimetres(1);
        const Cradle cradle = cradleOf(
            *test::laid(jig.mesh, test::viscousOnSphere(test::a4Grid(), radius, pi / 2)), coarse);
        QVERIFY(!cradle.mesh.triangles.empty());
        QCOMPARE(cradle.notes.filter("3 separate parts").size(), qsizetype(1));
    }

    // In the pose frame, the ball's centre is at (0, radius, 0).
    void makeCradle_ball_hasAPocketOfItsForm() {
        const Cradle& cradle = ballsCradle();
        isSound(cradle);
        QVERIFY(cradle.notes.isEmpty());
        const Eigen::Vector3f middle(0, float(radius), 0);
        std::size_t pocket = 0;
        for (const Eigen::Vector3f& place : cradle.mesh.positions) {
            const Eigen::Vector3f from = place - middle;
            const double away = double(from.norm()) - radius;
            QVERIFY(away > 0.2);
            // Away from the edges of the bore and the rim, the cradle's surface near the ball is
            // the pocket.
            const double aside = std::hypot(double(from.x()), double(from.z()));
            if (away < 0.8 && aside > 5 && from.y() > radius - 9) {
                QVERIFY2(std::abs(away - 0.3) < 0.1,
                         qPrintable(QStringLiteral("gap %1 mm, expected 0.3 mm").arg(away)));
                ++pocket;
            }
        }
        QVERIFY(pocket > 2000);
        QVERIFY(std::abs(cradle.check.leastGap - 0.3) < 0.1);
    }

    // The seat is a cap 10 mm deep; its area is 2πρh less the area of the bore. The ball tips over
    // at the tilt whose tangent is the rim's radius over the rim's distance from the ball's centre.
    void cradleCheck_ball_hasSeatAreaAndTiltOfTheCap() {
        const CradleCheck& check = ballsCradle().check;
        const double cap = 2 * pi * radius * 10 - pi * 16;
        QVERIFY2(
            std::abs(check.seatArea / cap - 1) < 0.05,
            qPrintable(
                QStringLiteral("the seat is %1 of the cap, expected 1").arg(check.seatArea / cap)));
        const double rim = std::sqrt(radius * radius - 15 * 15);
        const double tilt = std::atan2(rim, 15) * 180 / pi;
        QVERIFY(std::abs(check.standing.tiltDegrees - tilt) < 2);
        // At the rim, the seat is as steep as the ball.
        QVERIFY(std::abs(check.standing.sideHoldDegrees - tilt) < 2);
        QCOMPARE(check.paddedArea, 0.0);
    }

    // The ball holds film up to 20° past the equator. The cradle keeps a distance of 4 mm from the
    // film, even if its reach is larger.
    void makeCradle_deepReach_keepsAwayFromThePaint() {
        CradleSettings deep = settings();
        deep.reach = Millimetres(40);
        const Cradle cradle = cradleOf(*halfPainted(), deep);
        isSound(cradle);
        QVERIFY(cradle.check.paintGap > 4 - cradle.cell / 2);
        const double edge = radius * std::sin(radians(Degrees(20)));
        for (const Eigen::Vector3f& place : cradle.mesh.positions) {
            QVERIFY(double(place.y()) > radius + edge);
        }
    }

    void makeCradle_flatTop_notesThatItCanSlide() {
        const Eigen::Vector3d size(40, 30, 40);
        const TexturedMesh box = test::plainModel(boxMesh(size), Qt::white);
        const auto laid = test::laid(box.mesh, test::flatUnderBox(test::a4Grid(), size));
        const Cradle cradle = cradleOf(*laid);
        isSound(cradle);
        QVERIFY(cradle.check.standing.tiltDegrees > 30);
        QVERIFY(cradle.check.standing.sideHoldDegrees < 1);
        QVERIFY(cradle.notes.join(u' ').contains(QStringLiteral("slide sideways")));
    }

    // Sides that stay above the water may touch the cradle.
    void makeCradle_partlyDippedBox_holdsItsSides() {
        const Eigen::Vector3d size(40, 30, 40);
        const TexturedMesh box = test::plainModel(boxMesh(size), Qt::white);
        const auto laid = test::laid(box.mesh, test::flatUnderBox(test::a4Grid(), size));
        ProcessSettings process;
        process.depth = Millimetres(10);
        const Cradle cradle = cradleOf(*laid, settings(), process);
        isSound(cradle);
        QVERIFY(cradle.check.standing.sideHoldDegrees > 80);
        for (const Eigen::Vector3f& place : cradle.mesh.positions) {
            QVERIFY(place.y() > 10 + 3);
        }
    }

    // In a slanted dip, the ball meets the film as in a straight dip.
    void makeCradle_slantedDip_isTheSame() {
        DipPath path;
        path.kind = PathKind::Slanted;
        const auto laid = halfPaintedOn(path);
        QCOMPARE(cradleStl(cradleOf(*laid)), cradleStl(ballsCradle()));
    }

    // Where the cradle goes under water, the ball is below it.
    void makeCradle_tiltedEntry_staysClearOfTheFilm() {
        DipPath path;
        path.kind = PathKind::Tilt;
        path.angle = Degrees(12);
        const auto laid = halfPaintedOn(path);
        const Cradle cradle = cradleOf(*laid);
        QVERIFY2(!cradle.mesh.triangles.empty(), qPrintable(cradle.notes.join(u'\n')));
        isSound(cradle);
        std::size_t underWater = 0;
        for (const PathMoment& moment : momentsOf(laid->body().path, 2)) {
            const Eigen::Vector3d middle = moment.poseToWorld * Eigen::Vector3d(0, radius, 0);
            for (const Eigen::Vector3f& place : cradle.mesh.positions) {
                const Eigen::Vector3d at = moment.poseToWorld * place.cast<double>();
                if (at.y() <= 0) {
                    const double aside = std::hypot(at.x() - middle.x(), at.z() - middle.z());
                    QVERIFY2(aside < radius, qPrintable(QString::number(aside)));
                    ++underWater;
                }
            }
        }
        QVERIFY(underWater > 1000);
        path.angle = Degrees(40);
        const Cradle none = cradleOf(*halfPaintedOn(path));
        QVERIFY(none.mesh.triangles.empty());
        QVERIFY(none.notes.front().contains(QStringLiteral("no cradle")));
    }

    // The box rolls from 8° to level, 32 mm deep. So the plate is highest over the box where its
    // outer corner stays 10 mm above the water while it is tilted.
    void makeCradle_smallRoll_raisesThePlate() {
        const Eigen::Vector3d size(40, 30, 40);
        const TexturedMesh box = test::plainModel(boxMesh(size), Qt::white);
        Immersion immersion;
        immersion.path.kind = PathKind::Roll;
        immersion.path.angle = Degrees(8);
        const auto laid = layFilm(
            std::make_shared<const PosedBody>(posedBody(box.mesh, immersion, ProcessSettings())),
            test::flatUnderBox(test::a4Grid(), size), {});
        const Cradle cradle = cradleOf(*laid);
        QVERIFY2(!cradle.mesh.triangles.empty(), qPrintable(cradle.notes.join(u'\n')));
        isSound(cradle);
        const double tilt = radians(Degrees(8));
        const double outer = 40 * 99 / 142.5 + 9.1; // the pins along X, and their rims
        const double middle = 20 * std::sin(tilt) + 15 * std::cos(tilt) - 32; // over the water
        const double bottom =
            15 + (10 - middle + outer * std::sin(tilt)) / std::cos(tilt); // over the box's bottom
        const double top = double(boundingBox(cradle.mesh).max().y());
        QVERIFY2(std::abs(top - 5 - bottom) < 0.1,
                 qPrintable(QStringLiteral("%1, expected %2").arg(top - 5).arg(bottom)));
        QVERIFY(bottom > 43 + 1); // in a straight dip
    }

    void makeCradle_farRoll_isEmptyAndNoted() {
        DipPath path;
        path.kind = PathKind::Roll;
        path.angle = Degrees(150);
        const Cradle cradle =
            cradleOf(*halfPaintedOn(path, Millimetres(20)), settings(), deep(Millimetres(20)));
        QVERIFY(cradle.mesh.triangles.empty());
        QCOMPARE(cradle.notes.size(), 1);
        QVERIFY(cradle.notes.front().contains(QStringLiteral("no cradle")));
    }

    // The upper half of a lying ring overhangs the ring's hole, but the ring still comes out of the
    // cradle.
    void makeCradle_undercutRing_comesOut() {
        const TexturedMesh ring = test::plainModel(torusMesh(20, 8, 48, 96), Qt::white);
        const auto laid =
            test::laid(ring.mesh, test::flatUnderBox(test::a4Grid(), Eigen::Vector3d(1, 1, 1)));
        CradleSettings deep = settings();
        deep.reach = Millimetres(16);
        const Cradle cradle = cradleOf(*laid, deep);
        isSound(cradle);
    }

    void makeCradle_earlierPaint_isNotTouched() {
        const LaidFilm earlier = paintedFromAbove(radians(Degrees(20)));
        const Cradle cradle = cradleOf(*halfPainted(), settings(), {}, {&earlier});
        isSound(cradle);
        QCOMPARE(cradle.check.paddedArea, 0.0);
        QVERIFY(cradle.check.paintGap > 4 - cradle.cell / 2);
        const double capHeight = radius * (1 + std::cos(radians(Degrees(20))));
        for (const Eigen::Vector3f& place : cradle.mesh.positions) {
            const bool isOverCap =
                std::hypot(place.x(), place.z()) < radius * std::sin(radians(Degrees(20)));
            QVERIFY(!isOverCap || place.y() > capHeight + 3.5);
        }
    }

    // An earlier dip has painted the whole upper side, except for the tape on its top.
    void makeCradle_maskOnEarlierPaint_restsOnTheMask() {
        const LaidFilm earlier = paintedFromAbove(radians(Degrees(120)));
        QVERIFY(cradleOf(*halfPainted(), settings(), {}, {&earlier}).mesh.triangles.empty());
        const auto model = std::make_shared<const TexturedMesh>(ball());
        MaskMark top;
        top.path = {{{Millimetres(0), Millimetres(radius), Millimetres(0)}, {0, 1, 0}}};
        top.radius = Millimetres(16);
        const SurfaceMask mask(model, {top});
        const Cradle cradle = cradleOf(*halfPainted(), settings(), {}, {&earlier}, {}, &mask);
        isSound(cradle);
        QVERIFY(cradle.check.seatArea > 100);
        QVERIFY(cradle.check.seatArea < maskedAreas(mask).area);
        QCOMPARE(cradle.check.paddedArea, 0.0);
    }

    void makeCradle_onPaintAllowed_padsEarlierPaint() {
        const LaidFilm earlier = paintedFromAbove(radians(Degrees(120)));
        const Cradle without = cradleOf(*halfPainted(), settings(), {}, {&earlier});
        QVERIFY(without.mesh.triangles.empty());
        QVERIFY(without.notes.join(u' ').contains(QStringLiteral("cradle.on_paint")));

        CradleSettings allowed = settings();
        allowed.onPaint = true;
        const Cradle cradle = cradleOf(*halfPainted(), allowed, {}, {&earlier});
        isSound(cradle);
        QVERIFY2(
            std::abs(cradle.check.leastGap - 1.8) < 0.1,
            qPrintable(
                QStringLiteral("smallest gap %1 mm, expected 1.8 mm").arg(cradle.check.leastGap)));
        QCOMPARE(cradle.check.paddedArea, cradle.check.seatArea);
        QVERIFY(cradle.notes.join(u' ').contains(QStringLiteral("1.5 mm")));
    }

    void makeCradle_filmAllRound_isEmptyAndNoted() {
        ProcessSettings clinging; // film that also adheres to faces that turn up
        clinging.overhang = Degrees(90);
        const Cradle cradle = cradleOf(*halfPainted(), settings(), clinging);
        QVERIFY(cradle.mesh.triangles.empty());
        QVERIFY(cradle.notes.join(u' ').contains(QStringLiteral("no cradle")));
    }

    // The holes have the pins' diameter plus clearance. They lie where the sheet's marks float, or
    // between that place and the centre.
    // The bore leaves nothing of the seat, which is about 40 mm wide.
    void makeCradle_boreWiderThanTheSeat_isEmptyAndNoted() {
        CradleSettings wide = settings();
        wide.bore = Millimetres(60);
        const Cradle cradle = cradleOf(*halfPainted(), wide);
        QVERIFY(cradle.mesh.triangles.empty());
        QVERIFY(cradle.notes.join(QLatin1Char(' ')).contains(QStringLiteral("cradle.bore_mm")));
    }

    void datumPins_areInLineWithTheSheetsMarks() {
        FilmSettings film;
        film.swellX = 1.1;
        const DatumPins wide = datumPins(Sheet(), film, Millimetres(1000));
        QCOMPARE(wide.share, 1.0);
        // An A4 sheet with marks 6 mm from its edges.
        QVERIFY((wide.pins[0] - Eigen::Vector2d(-99 * 1.1, -142.5)).norm() < 1e-9);
        QVERIFY((wide.pins[1] - Eigen::Vector2d(99 * 1.1, -142.5)).norm() < 1e-9);
        QVERIFY((wide.pins[2] - Eigen::Vector2d(-99 * 1.1, 142.5)).norm() < 1e-9);

        // A printer with margins of 5 mm prints the marks farther inside.
        Sheet sheet;
        sheet.clearance = Millimetres(5);
        QVERIFY(
            (datumPins(sheet, film, Millimetres(1000)).pins[2] - Eigen::Vector2d(-97 * 1.1, 140.5))
                .norm() < 1e-9);
        // Marks on the paper round the film are cut off, so the film's corners count.
        sheet.settings.paper = QStringLiteral("A3");
        QVERIFY((datumPins(sheet, film, Millimetres(1000)).marks[2] -
                 Eigen::Vector2d(-105 * 1.1, 148.5))
                    .norm() < 1e-9);

        const DatumPins pins = datumPins(Sheet(), FilmSettings(), settings().pinSpan);
        QVERIFY(std::abs(pins.share - 80 / 285.0) < 1e-9);
        const Cradle& cradle = ballsCradle();
        for (const Eigen::Vector2d& pin : pins.pins) {
            double nearest = 1e3, farthest = 0;
            for (const Eigen::Vector3f& place : cradle.mesh.positions) {
                const double away = std::hypot(place.x() - pin.x(), place.z() - pin.y());
                nearest = std::min(nearest, away);
                farthest = away < 3.4 ? std::max(farthest, away) : farthest;
            }
            QVERIFY2(std::abs(nearest - 3.1) < 0.05,
                     qPrintable(
                         QStringLiteral("radius of the hole %1 mm, expected 3.1 mm").arg(nearest)));
            QVERIFY(farthest < 3.4);
        }
    }

    // The file's frame is the printer's bed: everything is at z ≥ 0, with the plate's face down.
    void cradleFile_readAgain_hasItsVolumeAndExtent_data() {
        QTest::addColumn<QString>("suffix");
        QTest::newRow("stl") << QStringLiteral("stl");
        QTest::newRow("3mf") << QStringLiteral("3mf");
    }

    void cradleFile_readAgain_hasItsVolumeAndExtent() {
        QFETCH(QString, suffix);
        const Cradle& cradle = ballsCradle();
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("cradle.") + suffix);
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(suffix == QLatin1String("stl")
                       ? cradleStl(cradle)
                       : cradle3mf(cradle, QStringLiteral("Ball & <base>")));
        file.close();
        const ImportedModel read = importModel(path, {}, {});
        QVERIFY(read.report.closed);
        const TriangleMesh& mesh = read.model.mesh;
        QVERIFY(std::abs(volume(mesh) / cradle.check.volume - 1) < 1e-4);
        const BoundingBox box = boundingBox(mesh);
        QVERIFY(box.min().cwiseAbs().maxCoeff() < 0.01F);
        // The width is 80 mm plus the rims round the pins. The height is from the plate's face to
        // 10 mm below the ball's top.
        QVERIFY(std::abs(box.max().y() - (80 + 2 * 9.1F)) < 0.01F);
        QVERIFY(std::abs(box.max().z() - (5 + 13 + 10)) < 0.3F);
    }

    void makeCradle_engravingDepth_engravesTheJob() {
        const Cradle& cradle = ballsCradle();
        CradleSettings plain = settings();
        plain.engravingDepth = Millimetres(0);
        const Cradle bare = cradleOf(*halfPainted(), plain);
        // Expected: about 0.8 mm times the area of the letters, the arrow and the symbol of the
        // dip, in mm³.
        const double taken = bare.check.volume - cradle.check.volume;
        QVERIFY2(taken > 100 && taken < 400,
                 qPrintable(
                     QStringLiteral("engraved volume %1 mm³, expected 100 to 400 mm³").arg(taken)));
        const double top = double(boundingBox(cradle.mesh).max().y());
        const auto isFloor = [&](const Eigen::Vector3f& place) {
            return std::abs(double(place.y()) - (top - 0.8)) < 0.02;
        };
        QVERIFY(std::count_if(cradle.mesh.positions.begin(), cradle.mesh.positions.end(), isFloor) >
                100);
    }

    // The distance is measured here from the ball's exact surface.
    void reducedSurface_ball_staysWithinTheTolerance() {
        const TriangleMesh fine = sphereMesh(radius, 300, 600);
        const ReducedSurface reduced = reducedSurface(fine, 0.02, 0.5, {});
        QVERIFY(reduced.mesh.triangles.size() < fine.triangles.size() / 4);
        QVERIFY(isClosedSurface(reduced.mesh));
        QVERIFY(reduced.distance > 0 && reduced.distance <= 0.02);
        for (const SurfacePoint& point : evenSamples(reduced.mesh, 0.1)) {
            QVERIFY(std::abs(double(position(reduced.mesh, point).norm()) - radius) < 0.021);
        }
    }

    void reducedSurface_tooRoughForTheTolerance_isUnchanged() {
        TriangleMesh rough = sphereMesh(radius, 100, 200);
        for (std::size_t i = 0; i < rough.positions.size(); ++i) {
            rough.positions[i] *= 1 + 0.01F * float(i * i % 7); // up to 1.5 mm
        }
        const ReducedSurface same = reducedSurface(rough, 0.02, 0.5, {});
        QCOMPARE(same.mesh.triangles.size(), rough.triangles.size());
        QVERIFY(same.distance < 1e-4);
    }

    void crossesItself_twoBalls_onlyIfTheyOverlap() {
        const TriangleMesh one = sphereMesh(radius, 20, 40);
        const auto withBallAt = [&](float x) {
            TriangleMesh two = one;
            for (const Eigen::Vector3f& place : one.positions) {
                two.positions.emplace_back(place + Eigen::Vector3f(x, 0.3F, 0.2F));
            }
            const auto first = std::uint32_t(one.positions.size());
            for (const auto& [a, b, c] : one.triangles) {
                two.triangles.push_back({a + first, b + first, c + first});
            }
            return crossesItself(two, SurfaceQuery(two));
        };
        QVERIFY(withBallAt(49));
        QVERIFY(!withBallAt(51));
    }

    void makeCradle_anyNumberOfThreads_giveTheSameBytes() {
        const QByteArray once = cradleStl(ballsCradle());
        const ThreadLimit limit(1);
        QCOMPARE(cradleStl(cradleOf(*halfPainted())), once);
    }

    void makeCradle_cancelled_throws() {
        Progress progress;
        progress.report = [&](double share, const QString&) {
            if (share > 0.3) {
                progress.cancelToken.cancel();
            }
        };
        QVERIFY_EXCEPTION_THROWN(cradleOf(*halfPainted(), settings(), {}, {}, progress), Cancelled);
    }
};

QTEST_MAIN(CradleTest)
#include "CradleTest.moc"
