// Tests which zone a place of a body belongs to, and the verdict on each zone.
#include "accuracy/tolerance/Zones.h"
#include "DippedByHand.h"
#include "JoinedMeshes.h"
#include "geometry/Shapes.h"

#include <QtTest>

using namespace dipwright;

namespace {

constexpr double radius = 30; // mm

ZoneMark markAt(Zone zone, MarkExtent extent, const Eigen::Vector3d& place, double size = 5) {
    ZoneMark mark;
    mark.zone = zone;
    mark.extent = extent;
    mark.radius = Millimetres(size);
    for (int axis = 0; axis < 3; ++axis) {
        mark.place[std::size_t(axis)] = Millimetres(place[axis]);
    }
    return mark;
}

double shareOf(Zone zone, const std::vector<Zone>& zones) {
    return double(std::count(zones.begin(), zones.end(), zone)) / double(zones.size());
}

// Returns the tolerances of a dip with the same spread (mm) everywhere, from one contributor.
DipTolerances evenTolerances(std::size_t places, float spread, Contributor contributor) {
    DipTolerances dip;
    Contribution contribution;
    contribution.contributor = contributor;
    dip.contributions = {contribution};
    dip.places.assign(places, spread);
    dip.squares = {std::vector<float>(places, spread * spread)};
    return dip;
}

std::vector<Zone> zonesOf(const std::shared_ptr<const TexturedMesh>& model,
                          const std::vector<ZoneMark>& marks,
                          const std::vector<SurfacePoint>& places) {
    ZonedBody body(model);
    body.setMarks(marks);
    std::vector<Zone> zones;
    for (const SurfacePoint& place : places) {
        zones.push_back(body.at(place));
    }
    return zones;
}

} // namespace

class ZonesTest : public QObject {
    Q_OBJECT

private slots:
    void zonedBody_withoutMarks_isZoneC() {
        const std::vector<SurfacePoint> places = tolerancePlaces(*ball_);
        QCOMPARE(shareOf(Zone::C, zonesOf(ball_, {}, places)), 1.0);
    }

    void spotMark_reachesItsRadiusAlongTheSurface() {
        const std::vector<SurfacePoint> places = tolerancePlaces(*ball_);
        const auto zones =
            zonesOf(ball_, {markAt(Zone::A, MarkExtent::Spot, {0, -radius, 0}, 20)}, places);
        const double cap = (1 - std::cos(20 / radius)) / 2; // share of the ball's surface
        QVERIFY2(std::abs(shareOf(Zone::A, zones) / cap - 1) < 0.05,
                 qPrintable(QStringLiteral("the zone is %1 of the cap, expected 1")
                                .arg(shareOf(Zone::A, zones) / cap)));
    }

    // A stroke of one point marks the cap within a straight distance.
    void strokeMark_ofOnePoint_marksLikeASpot() {
        const std::vector<SurfacePoint> places = tolerancePlaces(*ball_);
        const double angle = 20 / radius;
        ZoneMark stroke =
            markAt(Zone::A, MarkExtent::Stroke, {0, 0, 0}, 2 * radius * std::sin(angle / 2));
        stroke.path = {{{Millimetres(0), Millimetres(-radius), Millimetres(0)}, {0, -1, 0}}};
        const auto brushed = zonesOf(ball_, {stroke}, places);
        const double cap = (1 - std::cos(angle)) / 2; // share of the ball's surface
        QVERIFY(std::abs(shareOf(Zone::A, brushed) / cap - 1) < 0.02);
        ZoneMark eraser = stroke;
        eraser.zone = Zone::C;
        QCOMPARE(shareOf(Zone::C, zonesOf(ball_, {stroke, eraser}, places)), 1.0);
    }

    void zoneVerdicts_zoneByBrush_equalTheSameZoneByMaterial() {
        const std::vector<SurfacePoint> places = tolerancePlaces(*ball_);
        ZoneMark stroke = markAt(Zone::A, MarkExtent::Stroke, {0, 0, 0}, radius);
        stroke.path = {{{Millimetres(-1), Millimetres(0), Millimetres(0)}, {}},
                       {{Millimetres(1), Millimetres(0), Millimetres(0)}, {}}};
        const DipTolerances dip = evenTolerances(places.size(), 0.5f, Contributor::TurnX);
        ToleranceSettings brushed, whole;
        brushed.marks = {stroke};
        whole.marks = {markAt(Zone::A, MarkExtent::Material, {0, radius, 0})};
        const auto byBrush = zoneVerdicts(ball_, {&dip}, {{}}, brushed);
        const auto byMaterial = zoneVerdicts(ball_, {&dip}, {{}}, whole);
        QCOMPARE(byBrush.size(), std::size_t(1));
        QCOMPARE(byMaterial.size(), std::size_t(1));
        QCOMPARE(byBrush[0].zone, Zone::A);
        QCOMPARE(byBrush[0].area, byMaterial[0].area);
        QCOMPARE(byBrush[0].together, byMaterial[0].together);
        QCOMPARE(byBrush[0].holds(), byMaterial[0].holds());
    }

    void zoneVerdicts_maskedPlaces_doNotCount() {
        const std::vector<SurfacePoint> places = tolerancePlaces(*ball_);
        MaskMark mask;
        mask.path = {{{Millimetres(0), Millimetres(-radius), Millimetres(0)}, {0, -1, 0}}};
        mask.radius = Millimetres(20);
        const DipTolerances dip = evenTolerances(places.size(), 0.5f, Contributor::TurnX);
        const auto verdicts =
            zoneVerdicts(ball_, {&dip}, {{}}, {}, surfaceMask(ball_, {mask}).get());
        const double open =
            surfaceArea(ball_->mesh) - maskedAreas(*surfaceMask(ball_, {mask})).area;
        QCOMPARE(verdicts.size(), std::size_t(1));
        QVERIFY(std::abs(verdicts[0].area / open - 1) < 0.01);
    }

    void faceMark_reachesTheEdges() {
        const auto box = std::make_shared<const TexturedMesh>(
            test::plainModel(boxMesh({40, 20, 60}), Qt::white));
        const std::vector<SurfacePoint> places = tolerancePlaces(*box);
        const auto zones = zonesOf(box, {markAt(Zone::B, MarkExtent::Face, {5, -10, 3})}, places);
        for (std::size_t place = 0; place < places.size(); ++place) {
            const bool isBelow = triangleNormal(box->mesh, places[place].triangle).y() < -0.9f;
            QCOMPARE(zones[place], isBelow ? Zone::B : Zone::C);
        }
    }

    void zoneVerdicts_flushBoxes_haveTheAreaOfOneBox_data() {
        QTest::addColumn<float>("away");
        QTest::newRow("at the origin") << 0.F;
        QTest::newRow("1 km away") << 1e6F;
    }

    // Every second place is painted. The faces at which the boxes touch are no surface to judge,
    // not even if a mark makes a zone of them.
    void zoneVerdicts_flushBoxes_haveTheAreaOfOneBox() {
        QFETCH(float, away);
        const TriangleMesh half = boxMesh({20, 20, 60});
        const TriangleMesh left = test::joined({}, half, {away - 10, 0, 0});
        const auto pair = std::make_shared<const TexturedMesh>(
            test::plainModel(test::joined(left, half, {away + 10, 0, 0}), Qt::white));
        DipTolerances dip = evenTolerances(tolerancePlaces(*pair).size(), 0.5f, Contributor::TurnX);
        for (std::size_t place = 0; place < dip.places.size(); place += 2) {
            dip.places[place] = unpaintedPlace;
        }
        ToleranceSettings settings;
        settings.marks = {markAt(Zone::A, MarkExtent::Face, {away, 0, 0}),
                          markAt(Zone::B, MarkExtent::Face, {away - 10, -10, 0})};
        const auto verdicts = zoneVerdicts(pair, {&dip}, {{}}, settings);
        const std::array<Zone, 2> zones{Zone::B, Zone::C};
        const double under = 20 * 60, whole = surfaceArea(boxMesh({40, 20, 60}));
        const std::array<double, 2> areas{under, whole - under};
        QCOMPARE(verdicts.size(), zones.size());
        for (std::size_t zone = 0; zone < zones.size(); ++zone) {
            QCOMPARE(verdicts[zone].zone, zones[zone]);
            QVERIFY(std::abs(verdicts[zone].area / areas[zone] - 0.5) < 0.01);
            QVERIFY(std::abs(verdicts[zone].unpainted / areas[zone] - 0.5) < 0.01);
        }
    }

    void materialMark_marksAllOfTheMaterial() {
        TexturedMesh two = *ball_;
        two.materials.push_back(two.materials.front());
        for (std::size_t triangle = 0; triangle < two.material.size(); ++triangle) {
            const bool isFar = position(two.mesh, middleOf(std::uint32_t(triangle))).x() > 10;
            two.material[triangle] = isFar ? 1 : 0;
        }
        const std::vector<SurfacePoint> places = tolerancePlaces(two);
        const auto zones = zonesOf(std::make_shared<const TexturedMesh>(two),
                                   {markAt(Zone::A, MarkExtent::Material, {radius, 0, 0})}, places);
        for (std::size_t place = 0; place < places.size(); ++place) {
            QCOMPARE(zones[place], two.material[places[place].triangle] == 1 ? Zone::A : Zone::C);
        }
    }

    void setMarks_markRemoved_restoresEarlierZones() {
        const std::vector<ZoneMark> marks{markAt(Zone::B, MarkExtent::Spot, {0, -radius, 0}, 20),
                                          markAt(Zone::A, MarkExtent::Spot, {radius, 0, 0}, 10)};
        ZonedBody body(ball_), again(ball_);
        body.setMarks(marks);
        body.setMarks({marks[0]});
        again.setMarks({marks[0]});
        QCOMPARE(body.zones(), again.zones());
        body.setMarks(marks);
        again.setMarks({});
        again.setMarks(marks);
        QCOMPARE(body.zones(), again.zones());
    }

    void laterMark_overEarlierOne_wins() {
        const std::vector<SurfacePoint> places = tolerancePlaces(*ball_);
        const Eigen::Vector3d below(0, -radius, 0);
        const auto zones = zonesOf(ball_,
                                   {markAt(Zone::A, MarkExtent::Material, below),
                                    markAt(Zone::B, MarkExtent::Material, below)},
                                   places);
        QCOMPARE(shareOf(Zone::B, zones), 1.0);
    }

    void zoneVerdicts_percentile95AboveLimit_doesNotHold() {
        const std::vector<SurfacePoint> places = tolerancePlaces(*ball_);
        ToleranceSettings settings;
        settings.marks = {markAt(Zone::A, MarkExtent::Spot, {0, -radius, 0}, 20)};
        DipTolerances dip = evenTolerances(places.size(), 0.5f, Contributor::TurnX);
        const auto verdicts = zoneVerdicts(ball_, {&dip}, {{}}, settings);
        QCOMPARE(verdicts.size(), std::size_t(2)); // zone A and the rest
        QCOMPARE(verdicts[0].zone, Zone::A);
        QVERIFY(!verdicts[0].holds()); // 0.3 mm
        QCOMPARE(verdicts[0].within, 0.0);
        QCOMPARE(verdicts[0].contributor, Contributor::TurnX);
        QCOMPARE(verdicts[0].worst.spread, 0.5);
        QCOMPARE(verdicts[1].zone, Zone::C);
        QVERIFY(verdicts[1].holds()); // 1.5 mm
        QVERIFY(std::abs(verdicts[0].area + verdicts[1].area - surfaceArea(ball_->mesh)) < 1);
    }

    void zoneVerdicts_twoDips_takeTheWorseAndReportUnpaintedArea() {
        const std::vector<SurfacePoint> places = tolerancePlaces(*ball_);
        DipTolerances one = evenTolerances(places.size(), 0.2f, Contributor::Swell);
        DipTolerances other = evenTolerances(places.size(), 1, Contributor::FilmTurn);
        for (std::size_t place = 0; place < places.size(); place += 2) {
            one.places[place] = other.places[place] = unpaintedPlace;
        }
        const auto verdicts = zoneVerdicts(ball_, {&one, &other}, {{}, {}}, {});
        QCOMPARE(verdicts.size(), std::size_t(1));
        QCOMPARE(verdicts[0].spread.median, 1.0);
        QCOMPARE(verdicts[0].contributor, Contributor::FilmTurn);
        QVERIFY(std::abs(verdicts[0].unpainted / verdicts[0].area - 1) < 0.01);
    }

private:
    const std::shared_ptr<const TexturedMesh> ball_ = std::make_shared<const TexturedMesh>(
        test::plainModel(sphereMesh(radius, 60, 120), Qt::white));
};

QTEST_APPLESS_MAIN(ZonesTest)
#include "ZonesTest.moc"
