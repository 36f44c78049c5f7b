// Tests a ball under two films that a closed form lays from opposite sides: which dip paints what,
// and whether the seam shows.
#include "DippedByHand.h"
#include "base/Units.h"
#include "dip/Coverage.h"
#include "geometry/Shapes.h"
#include "marks/SurfaceMask.h"
#include "share/FadeOverlap.h"
#include "share/ShareMarks.h"
#include "share/UnpaintedPlaces.h"
#include "texture/Ink.h"
#include "texture/LinearLight.h"
#include "texture/ReverseTexture.h"

#include <QPainter>
#include <QtTest>

#include <cmath>
#include <random>

using namespace dipwright;

namespace {

constexpr double radius = 35;
constexpr double reach =
    115 * pi / 180;               // radians, of each film from the point that it touches first
const QSize a4Pixels(1240, 1754); // 150 dpi

using Films = std::array<std::shared_ptr<const LaidFilm>, 2>;

std::shared_ptr<const LaidFilm> laidFrom(const TexturedMesh& model, double turn) {
    return test::laidOnTurnedSphere(model.mesh, radius, reach, turn);
}

// Returns films from below and from above.
Films oppositeFilms(const TexturedMesh& model) {
    return {laidFrom(model, 0), laidFrom(model, 180)};
}

TexturedMesh ball(const QColor& colour) {
    return test::plainModel(sphereMesh(radius, 60, 120), colour);
}

BodyShare shared(const TexturedMesh& model, const Films& films,
                 const ShareSettings& settings = {}) {
    return shareBody(*shareStage(model, fineBody(model.mesh)), films, settings, {}, {});
}

double heightOf(const std::array<Eigen::Vector3f, 2>& piece) {
    return double(piece[0].y() + piece[1].y()) / 2;
}

// Returns the light of a sheet at a place of the flat film, interpolated between four pixels.
// Unprinted pixels are white.
LinearColour printedAt(const QImage& sheet, const solver::FilmGrid& grid,
                       const Eigen::Vector2f& rest) {
    const double x = (double(rest.x()) / grid.width + 0.5) * sheet.width() - 0.5;
    const double y = (double(rest.y()) / grid.depth + 0.5) * sheet.height() - 0.5;
    LinearColour sum = LinearColour::Zero();
    for (const int right : {0, 1}) {
        for (const int down : {0, 1}) {
            const int column = int(std::floor(x)) + right;
            const int row = int(std::floor(y)) + down;
            const double weight = (1 - std::abs(x - column)) * (1 - std::abs(y - row));
            const uchar* pixel = sheet.constScanLine(row) + 4 * column;
            for (int channel = 0; channel < 3; ++channel) {
                sum[channel] += float(weight) * (pixel[3] == 0 ? 1 : linearTable()[pixel[channel]]);
            }
        }
    }
    return sum;
}

// Returns the light that one film's sheet shows at a place of the body.
LinearColour shownBy(const LaidFilm& laid, const QImage& sheet, const SurfacePoint& point) {
    const std::optional<FilmPlace> place = laid.place(point);
    if (!place) {
        return LinearColour::Ones();
    }
    const float stretch = laid.areaStretch(*place);
    return InkCompensation({}).shown(printedAt(sheet, laid.film().grid, place->rest), stretch);
}

} // namespace

class BodyShareTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void shareBody_oppositeDips_shareABallEvenly();
    void shareBody_seam_liesInThePlainHalf();
    void reverseTexture_greyAcrossTheSeam_isRight();
    void reverseTexture_blackAndWhiteAcrossTheSeam_areRight();
    void reverseTexture_otherDipsShare_isNotPainted();
    void neededOverlap_isAsWideAsTheErrorNeeds_data();
    void neededOverlap_isAsWideAsTheErrorNeeds();
    void shareBody_overlap_isMeasuredOnTheFlatFilm();
    void shareBody_slippedFilm_doesNotShow();
    void shareBody_tooLittleRoom_isReportedAsNarrow();
    void shareBody_areaThatOneDipReaches_isThatDipsShare();
    void shareBody_areaOfOneDipAlone_doesNotFade();
    void shareBody_unreachedPlaces_areListed();
    void unpaintedPlaces_maskInTheMiddle_leavesTheRest();
    void shareBody_marks_areObeyed();
    void recommendedLastDip_lessStretchedFilm_isLast();
    void markOutline_roundMark_isACircle();
    void markOutline_ofAFace_followsTheFacesEdges();
    void shareBody_twice_givesTheSameBits();
};

void BodyShareTest::shareBody_oppositeDips_shareABallEvenly() {
    const TexturedMesh model = ball(QColor(120, 120, 120));
    const BodyShare share = shared(model, oppositeFilms(model));
    const double whole = surfaceArea(model.mesh);
    QVERIFY(std::abs(share.areas.total() - whole) < 1e-3 * whole);
    QVERIFY2(std::abs(share.areas.first - share.areas.second) < 0.01 * whole,
             qPrintable(QStringLiteral("dip 1 paints %1 mm² alone, dip 2 %2 mm²")
                            .arg(share.areas.first)
                            .arg(share.areas.second)));
    QCOMPARE(share.areas.none, 0.0);
    QVERIFY(share.unpainted.empty());
    QVERIFY(!share.join.empty());
    for (const auto& piece : share.join) {
        QVERIFY2(std::abs(heightOf(piece)) < 1,
                 qPrintable(QStringLiteral("the seam is at y = %1 mm").arg(heightOf(piece))));
    }
    QVERIFY2(std::abs(share.cost.length - 2 * pi * radius) < 0.02 * 2 * pi * radius,
             qPrintable(QStringLiteral("the seam is %1 mm long, expected %2 mm")
                            .arg(share.cost.length)
                            .arg(2 * pi * radius)));
}

void BodyShareTest::shareBody_seam_liesInThePlainHalf() {
    QImage picture(1200, 600, QImage::Format_RGBA8888);
    picture.fill(QColor(230, 230, 230));
    QPainter painter(&picture);
    for (int row = 300; row < 600; row += 10) { // the southern half of the map
        for (int column = 0; column < 1200; column += 20) {
            painter.fillRect(column + row % 20, row, 10, 10, Qt::black);
        }
    }
    painter.end();
    const TexturedMesh model = test::globe(radius, 60, 120, picture);
    const BodyShare share = shared(model, oppositeFilms(model));
    for (const auto& piece : share.join) {
        QVERIFY2(heightOf(piece) > 0,
                 qPrintable(QStringLiteral("the seam is at y = %1 mm").arg(heightOf(piece))));
    }
    QVERIFY2(share.cost.cost < 0.7 * share.equator.cost,
             qPrintable(QStringLiteral("cost of the seam %1, of the equator %2")
                            .arg(share.cost.cost)
                            .arg(share.equator.cost)));
}

void BodyShareTest::reverseTexture_greyAcrossTheSeam_isRight() {
    const TexturedMesh model = ball(QColor(120, 120, 120));
    const Films films = oppositeFilms(model);
    const BodyShare share = shared(model, films);
    std::array<QImage, 2> sheets;
    for (std::size_t dip = 0; dip < 2; ++dip) {
        sheets[dip] =
            reverseTexture(*films[dip], model, {a4Pixels, 2, {}, share.of(dip)}, {}).image;
    }
    const float wanted = linearColour(QColor(120, 120, 120))[0];
    std::size_t inBand = 0;
    for (std::uint32_t triangle = 0; triangle < share.painters.size(); ++triangle) {
        const SurfacePoint point = share.fade.mesh->middle(triangle);
        inBand += share.painters[triangle] == Painter::Both ? 1 : 0;
        const LinearColour shown =
            shownBy(*films[0], sheets[0], point) * shownBy(*films[1], sheets[1], point);
        QVERIFY2(std::abs(shown[0] - wanted) < 0.01f,
                 qPrintable(QStringLiteral("light %1, expected %2; %3 overlaps from the seam")
                                .arg(double(shown[0]))
                                .arg(double(wanted))
                                .arg(double(share.fade.at(point)))));
    }
    QVERIFY(inBand > 100);
}

void BodyShareTest::reverseTexture_blackAndWhiteAcrossTheSeam_areRight() {
    for (const QColor& colour : {QColor(Qt::black), QColor(Qt::white)}) {
        const TexturedMesh model = ball(colour);
        const Films films = oppositeFilms(model);
        const BodyShare share = shared(model, films);
        const QImage first =
            reverseTexture(*films[0], model, {a4Pixels, 2, {}, share.of(0)}, {}).image;
        const QImage second =
            reverseTexture(*films[1], model, {a4Pixels, 2, {}, share.of(1)}, {}).image;
        for (std::uint32_t triangle = 0; triangle < share.painters.size(); triangle += 7) {
            const SurfacePoint point = share.fade.mesh->middle(triangle);
            const LinearColour shown =
                shownBy(*films[0], first, point) * shownBy(*films[1], second, point);
            QVERIFY2(std::abs(shown[0] - linearColour(colour)[0]) < 0.02f,
                     qPrintable(QStringLiteral("light %1, expected %2")
                                    .arg(double(shown[0]))
                                    .arg(double(linearColour(colour)[0]))));
        }
    }
}

void BodyShareTest::reverseTexture_otherDipsShare_isNotPainted() {
    const TexturedMesh model = ball(QColor(40, 90, 160));
    const Films films = oppositeFilms(model);
    const BodyShare share = shared(model, films);
    for (std::size_t dip = 0; dip < 2; ++dip) {
        const QImage sheet =
            reverseTexture(*films[dip], model, {a4Pixels, 2, {}, share.of(dip)}, {}).image;
        for (std::uint32_t triangle = 0; triangle < share.painters.size(); triangle += 3) {
            const Painter other = dip == 0 ? Painter::Second : Painter::First;
            const SurfacePoint point = share.fade.mesh->middle(triangle);
            const bool isFar = share.of(dip).allWithin(1, point).has_value();
            const std::optional<FilmPlace> place = films[dip]->place(point);
            if (share.painters[triangle] != other || !isFar || !place) {
                continue;
            }
            const int column = int((double(place->rest.x()) / 210 + 0.5) * sheet.width());
            const int row = int((double(place->rest.y()) / 297 + 0.5) * sheet.height());
            QCOMPARE(qAlpha(sheet.pixel(column, row)), 0);
        }
    }
}

void BodyShareTest::neededOverlap_isAsWideAsTheErrorNeeds_data() {
    QTest::addColumn<double>("light");
    QTest::addColumn<double>("error");
    for (const double light : {0.01, 0.1, 0.32, 0.5, 0.85, 0.95}) {
        for (const double error : {0.3, 0.7, 2.0}) {
            QTest::addRow("%g, %g mm", light, error) << light << error;
        }
    }
}

void BodyShareTest::neededOverlap_isAsWideAsTheErrorNeeds() {
    QFETCH(double, light);
    QFETCH(double, error);
    const double wide = neededOverlap(LinearColour::Constant(float(light)), error, 0);
    const auto step = [&](double overlap) {
        const double share = std::min(1.0, error / overlap);
        return std::max(std::pow(light, 1 - share) - light, light - std::pow(light, 1 + share));
    };
    QVERIFY(step(wide) <= 0.1 + 1e-6);
    QVERIFY(step(0.98 * wide) > 0.1 || wide <= error);
    QCOMPARE(neededOverlap(LinearColour::Constant(float(light)), 0, 1.5), 1.5);
}

void BodyShareTest::shareBody_overlap_isMeasuredOnTheFlatFilm() {
    const TexturedMesh model = ball(QColor(120, 120, 120));
    const BodyShare share = shared(model, oppositeFilms(model));
    // Viscous film that rested at R = 2ρ·sin(θ/2) is stretched by √2 at the equator.
    const double needed = neededOverlap(linearColour(QColor(120, 120, 120)), 0.7, 0);
    const double wide = share.overlap.middle / (needed * std::sqrt(2));
    QVERIFY2(
        wide > 1.05 && wide < 1.3,
        qPrintable(
            QStringLiteral("overlap over the needed width: %1, expected 1.05 to 1.3").arg(wide)));
    QVERIFY(share.overlap.least <= share.overlap.middle);
    QVERIFY(share.overlap.middle <= share.overlap.most);
    // White needs no more overlap than the settings ask for.
    const TexturedMesh white = ball(Qt::white);
    const BodyShare plain = shared(white, oppositeFilms(white));
    QVERIFY2(
        std::abs(plain.overlap.middle - 1.5) < 0.3,
        qPrintable(QStringLiteral("overlap %1 mm, expected 1.5 mm").arg(plain.overlap.middle)));
}

// The second film is shifted by the registration error. Each place then gets the ink of another
// place, which changes the sum of both densities.
void BodyShareTest::shareBody_slippedFilm_doesNotShow() {
    const TexturedMesh model = ball(QColor(120, 120, 120));
    const BodyShare share = shared(model, oppositeFilms(model));
    QCOMPARE(share.narrow, 0.0);
    const auto light = double(linearColour(QColor(120, 120, 120))[0]);
    const SurfaceQuery query(model.mesh);
    const double slip = ShareSettings().registrationError.value();
    int joined = 0;
    for (std::uint32_t triangle = 0; triangle < share.painters.size(); triangle += 3) {
        if (share.painters[triangle] != Painter::Both) {
            continue;
        }
        const SurfacePoint point = share.fade.mesh->middle(triangle);
        const Eigen::Vector3d place = position(model.mesh, point).cast<double>();
        // Distance from the middle of the second film, whose pole is on top.
        const double rest = 2 * radius * std::sin(std::acos(place.y() / radius) / 2);
        const Eigen::Vector3d outwards = Eigen::Vector3d(place.x(), 0, place.z()).normalized();
        for (const double off : {-slip, slip}) {
            const double angle = 2 * std::asin((rest + off) / (2 * radius));
            const Eigen::Vector3d from =
                radius * (std::sin(angle) * outwards + std::cos(angle) * Eigen::Vector3d::UnitY());
            const SurfacePoint other = query.closest(from.cast<float>()).point;
            const auto given = double(share.of(0).at(point) + share.of(1).at(other));
            const double shown = std::pow(light, given);
            QVERIFY2(std::abs(shown - light) < 0.1,
                     qPrintable(QStringLiteral("light %1, expected %2").arg(shown).arg(light)));
        }
        ++joined;
    }
    QVERIFY(joined > 100);
}

void BodyShareTest::shareBody_tooLittleRoom_isReportedAsNarrow() {
    const TexturedMesh model = ball(QColor(120, 120, 120));
    // Both films reach 4 mm past the equator.
    const double end = pi / 2 + 4 / radius;
    const Films films{test::laidOnTurnedSphere(model.mesh, radius, end, 0),
                      test::laidOnTurnedSphere(model.mesh, radius, end, 180)};
    ShareSettings settings;
    settings.registrationError = Millimetres(0.2);
    QCOMPARE(shared(model, films, settings).narrow, 0.0);
    settings.registrationError = Millimetres(3);
    const BodyShare share = shared(model, films, settings);
    QVERIFY2(
        share.narrow > 0.9,
        qPrintable(QStringLiteral("share of narrow overlap %1, expected > 0.9").arg(share.narrow)));
    QVERIFY2(share.overlap.most < 10,
             qPrintable(QStringLiteral("overlap %1 mm, expected < 10 mm").arg(share.overlap.most)));
}

void BodyShareTest::shareBody_areaThatOneDipReaches_isThatDipsShare() {
    const TexturedMesh model = ball(QColor(120, 120, 120));
    const Films films = oppositeFilms(model);
    const BodyShare share = shared(model, films);
    for (std::uint32_t triangle = 0; triangle < share.painters.size(); ++triangle) {
        const SurfacePoint point = share.fade.mesh->middle(triangle);
        const double height = double(position(model.mesh, point).y());
        if (height < -radius / 2) {
            QCOMPARE(share.painters[triangle], Painter::First);
        } else if (height > radius / 2) {
            QCOMPARE(share.painters[triangle], Painter::Second);
        }
    }
}

void BodyShareTest::shareBody_areaOfOneDipAlone_doesNotFade() {
    const TexturedMesh model = ball(QColor(120, 120, 120));
    // There is a bare ring between the two films. They do not fade towards their ends.
    const Films films{test::laidOnTurnedSphere(model.mesh, radius, 1.3, 0),
                      test::laidOnTurnedSphere(model.mesh, radius, 1.3, 180)};
    const BodyShare share = shared(model, films);
    QVERIFY(share.areas.none > 0.2 * share.areas.total());
    std::array<int, 2> tried{};
    for (std::uint32_t triangle = 0; triangle < share.painters.size(); ++triangle) {
        for (const std::size_t dip : {std::size_t(0), std::size_t(1)}) {
            const Painter own = dip == 0 ? Painter::First : Painter::Second;
            if (share.painters[triangle] == own) {
                const SurfacePoint point = share.fade.mesh->middle(triangle);
                QVERIFY2(share.of(dip).at(point) > 0.999f,
                         qPrintable(QStringLiteral("weight of the dip %1, expected 1")
                                        .arg(double(share.of(dip).at(point)))));
                ++tried[dip];
            }
        }
    }
    QVERIFY(tried[0] > 5000 && tried[1] > 5000);
}

void BodyShareTest::shareBody_unreachedPlaces_areListed() {
    const TexturedMesh model = ball(QColor(120, 120, 120));
    // Both dips are from below, so that the cap on top stays bare.
    const BodyShare share = shared(model, {laidFrom(model, 0), laidFrom(model, 0)});
    const double cap = surfaceArea(model.mesh) - coverage(*laidFrom(model, 0)).paintedArea;
    QVERIFY2(
        std::abs(share.areas.none - cap) < 0.01 * cap,
        qPrintable(
            QStringLiteral("%1 mm² unpainted, expected %2 mm²").arg(share.areas.none).arg(cap)));
    QCOMPARE(share.unpainted.size(), std::size_t(1));
    QVERIFY(std::abs(share.unpainted[0].area - share.areas.none) < 0.01 * share.areas.none);
    QVERIFY((share.unpainted[0].place - Eigen::Vector3f(0, float(radius), 0)).norm() < 2);
}

// Tape on the middle of bare surface must not hide the bare surface around it.
void BodyShareTest::unpaintedPlaces_maskInTheMiddle_leavesTheRest() {
    const TexturedMesh model = ball(QColor(120, 120, 120));
    const auto film = laidFrom(model, 0);
    const BodyShare share = shared(model, {film, film});
    BrushPoint top;
    top.place[1] = Millimetres(radius);
    top.outward = {0, 1, 0};
    MaskMark mark;
    mark.extent = MarkExtent::Stroke;
    mark.radius = Millimetres(10);
    mark.path = {top};
    const auto mask = surfaceMask(std::make_shared<TexturedMesh>(model), {mark}, nullptr);
    const std::vector<UnpaintedPlace> places = unpaintedPlaces(share, film->body(), mask.get());
    QCOMPARE(places.size(), std::size_t(1));
    // Surface within the chord c of a sphere's point has the area πc².
    const double rest = share.unpainted[0].area - pi * 10 * 10;
    QVERIFY2(std::abs(places[0].area - rest) < 0.03 * rest,
             qPrintable(QString::number(places[0].area)));
    const auto closest = (places[0].place - Eigen::Vector3f(0, float(radius), 0)).norm();
    QVERIFY2(closest > 9, qPrintable(QString::number(closest)));
    QCOMPARE(unpaintedPlaces(share, film->body(), nullptr).size(), std::size_t(1));
}

void BodyShareTest::shareBody_marks_areObeyed() {
    const TexturedMesh model = ball(QColor(120, 120, 120));
    const Films films = oppositeFilms(model);
    const auto painterAt = [&](const BodyShare& share, const Eigen::Vector3f& place) {
        const SurfacePoint point = SurfaceQuery(model.mesh).closest(place).point;
        return share.painters[share.fade.mesh->onFine(point).triangle];
    };
    // A place a little above the equator, in the share of dip 2.
    const Eigen::Vector3f above = 35 * Eigen::Vector3f(0, 0.2f, 1).normalized();
    QCOMPARE(painterAt(shared(model, films), above), Painter::Second);
    ShareSettings settings;
    ShareMark mark{ShareMarkKind::First, {}, Millimetres(12)};
    for (int axis = 0; axis < 3; ++axis) {
        mark.place[std::size_t(axis)] = Millimetres(double(above[axis]));
    }
    settings.marks = {mark};
    QCOMPARE(painterAt(shared(model, films, settings), above), Painter::First);
    settings.marks.push_back(mark);
    settings.marks.back().kind = ShareMarkKind::Second;
    QCOMPARE(painterAt(shared(model, films, settings), above), Painter::Second);
    // A brush stroke marks like a spot, and an eraser takes the mark out.
    ShareMark stroke{ShareMarkKind::First, {}, Millimetres(12)};
    stroke.path = {{mark.place, {0, 0.2, 0.98}}};
    settings.marks = {stroke};
    QCOMPARE(painterAt(shared(model, films, settings), above), Painter::First);
    settings.marks.push_back(stroke);
    settings.marks.back().kind = ShareMarkKind::None;
    QCOMPARE(painterAt(shared(model, films, settings), above), Painter::Second);
    // The first dip reaches the bottom, but not the top.
    settings.marks = {mark};
    settings.marks[0].place = {Millimetres(0), Millimetres(-radius), Millimetres(0)};
    QCOMPARE(shared(model, films, settings).misassigned, 0.0);
    settings.marks[0].place[1] = Millimetres(radius);
    QCOMPARE(shared(model, films, settings).misassigned, 1.0);
    // The seam goes round a spot that it must avoid.
    settings.marks = {mark};
    settings.marks[0].kind = ShareMarkKind::Avoid;
    settings.marks[0].place = {Millimetres(0), Millimetres(0), Millimetres(radius)};
    settings.marks[0].radius = Millimetres(5);
    const BodyShare round = shared(model, films, settings);
    for (const auto& piece : round.join) {
        QVERIFY((piece[0] - Eigen::Vector3f(0, 0, float(radius))).norm() > 3);
    }
}

void BodyShareTest::recommendedLastDip_lessStretchedFilm_isLast() {
    const TexturedMesh model = ball(QColor(120, 120, 120));
    BodyShare share = shared(model, oppositeFilms(model));
    // At the equator, viscous film is stretched by 1/cos(45°) along the meridian.
    for (const double stretch : share.seamStretch) {
        QVERIFY2(std::abs(stretch - std::sqrt(2)) < 0.05,
                 qPrintable(QStringLiteral("stretch %1, expected √2").arg(stretch)));
    }
    QVERIFY(!recommendedLastDip(share));
    share.seamStretch = {1.2, 1.5};
    QCOMPARE(recommendedLastDip(share), std::optional<std::size_t>(0));
    share.seamStretch = {1.5, 1.2};
    QCOMPARE(recommendedLastDip(share), std::optional<std::size_t>(1));
}

void BodyShareTest::markOutline_roundMark_isACircle() {
    const TriangleMesh mesh = sphereMesh(radius, 120, 240);
    const SurfaceQuery query(mesh);
    ShareMark mark;
    mark.place = {Millimetres(radius), Millimetres(0), Millimetres(0)};
    mark.radius = Millimetres(8);
    double length = 0;
    for (const auto& [from, to] : markOutline(mesh, query, mark)) {
        length += double((to - from).norm());
        const double away = radius * std::acos(double(from.normalized().x()));
        // The measured radius is a few per cent too large, because the front is round
        // (SurfaceDistance.h).
        QVERIFY2(std::abs(away - 8) < 0.08 * 8,
                 qPrintable(QStringLiteral("radius %1 mm, expected 8 mm").arg(away)));
    }
    const double circle = 2 * pi * radius * std::sin(8 / radius);
    QVERIFY2(std::abs(length - circle) < 0.06 * circle,
             qPrintable(QStringLiteral("length %1 mm, expected %2 mm").arg(length).arg(circle)));
}

void BodyShareTest::markOutline_ofAFace_followsTheFacesEdges() {
    const TriangleMesh box = boxMesh({10, 20, 30});
    const SurfaceQuery query(box);
    ShareMark mark;
    const Eigen::Vector3f top = boundingBox(box).center() + Eigen::Vector3f(1, 10, 2);
    mark.place = {Millimetres(double(top.x())), Millimetres(double(top.y())),
                  Millimetres(double(top.z()))};
    mark.radius = Millimetres(0);
    double length = 0;
    for (const auto& [from, to] : markOutline(box, query, mark)) {
        length += double((to - from).norm());
    }
    QCOMPARE(length, 80.0);
}

void BodyShareTest::shareBody_twice_givesTheSameBits() {
    const TexturedMesh model = ball(QColor(120, 120, 120));
    const Films films = oppositeFilms(model);
    QCOMPARE(shared(model, films).fade.values, shared(model, films).fade.values);
}

QTEST_GUILESS_MAIN(BodyShareTest)
#include "BodyShareTest.moc"
