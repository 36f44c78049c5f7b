// Tests pictures, text and patterns on bodies: charts, lengths, order and colours.
#include "JoinedMeshes.h"
#include "artwork/EditArtwork.h"
#include "artwork/LayerPicture.h"
#include "artwork/LayerPlane.h"
#include "artwork/PaintArtwork.h"
#include "artwork/Patterns.h"
#include "artwork/Unwrap.h"
#include "base/WideGamut.h"
#include "geometry/Shapes.h"
#include "texture/SurfaceColours.h"

#include <QFontDatabase>
#include <QtTest>

#include <cmath>

using namespace dipwright;

namespace {

TexturedMesh bodyOf(TriangleMesh mesh) {
    TexturedMesh body;
    const std::size_t triangles = mesh.triangles.size();
    const float none = std::numeric_limits<float>::quiet_NaN();
    body.mesh = std::move(mesh);
    body.textureCoordinates.assign(
        triangles,
        {Eigen::Vector2f(none, none), Eigen::Vector2f(none, none), Eigen::Vector2f(none, none)});
    body.material.assign(triangles, 0);
    body.materials.resize(1);
    body.chart = findCharts(body);
    return body;
}

// Returns a ramp of two turns. Its upper turn lies over its lower turn, with the same normals.
TriangleMesh spiralRamp() {
    TriangleMesh mesh;
    constexpr int steps = 120;
    for (int k = 0; k <= steps; ++k) {
        const double angle = 4 * pi * k / steps; // twice round
        const auto c = float(std::cos(angle)), s = float(std::sin(angle));
        const float y = 0.2F * float(k);
        mesh.positions.push_back({10 * c, y, 10 * s});
        mesh.positions.push_back({30 * c, y, 30 * s});
    }
    for (std::uint32_t k = 0; k < steps; ++k) {
        mesh.triangles.push_back({2 * k, 2 * k + 2, 2 * k + 1});
        mesh.triangles.push_back({2 * k + 1, 2 * k + 2, 2 * k + 3});
    }
    return mesh;
}

SurfacePoint placeAt(const TexturedMesh& body, const Eigen::Vector3d& position) {
    return SurfaceQuery(body.mesh).closest(position.cast<float>()).point;
}

QColor colourAt(const TexturedMesh& body, const Eigen::Vector3d& position) {
    const SurfacePoint place = placeAt(body, position);
    const Eigen::Vector2f uv = body.textureCoordinate(place);
    const QImage picture = inSrgb(body.textures.front());
    return picture.pixelColor(
        std::clamp(int(uv.x() * float(picture.width())), 0, picture.width() - 1),
        std::clamp(int((1 - uv.y()) * float(picture.height())), 0, picture.height() - 1));
}

QImage plain(const QColor& colour, QSize size = {40, 40}) {
    QImage image(size, QImage::Format_RGBA8888);
    image.fill(colour);
    return image;
}

ArtworkLayer pictureLayer(const QImage& image, const Eigen::Vector3d& place, double size) {
    ArtworkLayer layer = newLayer(LayerKind::Picture, QStringLiteral("picture"));
    layer.picture = artworkPicture(image);
    layer.place = {Millimetres(place.x()), Millimetres(place.y()), Millimetres(place.z())};
    layer.size = {Millimetres(size), Millimetres(size)};
    return layer;
}

TexturedMesh paintedBox(const Artwork& artwork) {
    return paintArtwork(bodyOf(boxMesh({60, 60, 60})), artwork, 0.2, Progress());
}

bool isNear(const QColor& a, const QColor& b, int within = 2) {
    return std::abs(a.red() - b.red()) <= within && std::abs(a.green() - b.green()) <= within &&
           std::abs(a.blue() - b.blue()) <= within;
}

// Returns one period of `pixels` with a black line over 10 % of its width.
QImage grid(int pixels) {
    QImage image = plain(Qt::white, {pixels, pixels});
    for (int k = 0; k < pixels; ++k) {
        for (int line = 0; line < pixels / 10; ++line) {
            image.setPixelColor(line, k, Qt::black);
        }
    }
    return image;
}

// Returns lines around the Z axis, one for each 10 mm, or as near to this as a whole number allows.
Artwork repeatedRoundZ() {
    Artwork artwork;
    artwork.base = Qt::white;
    artwork.layers = {pictureLayer(grid(100), {0, 0, 0}, 60)};
    artwork.layers.front().placement = LayerPlacement::Cylinder;
    artwork.layers.front().axis = LayerAxis::Z;
    artwork.layers.front().repeat = Millimetres(10);
    return artwork;
}

// Returns a text of at most 40 mm × 40 mm in the middle of the top of paintedBox().
Artwork textOnTop(const QString& text) {
    Artwork artwork;
    artwork.base = Qt::white;
    artwork.layers = {newLayer(LayerKind::Text, QStringLiteral("text"))};
    ArtworkLayer& layer = artwork.layers.front();
    layer.text = text;
    layer.place = {Millimetres(0), Millimetres(0), Millimetres(30)};
    layer.size = {Millimetres(40), Millimetres(40)};
    return artwork;
}

} // namespace

class ArtworkTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void layerNotes_oneSpotInkInTwoOrders_saysWhichCounts();
    void unwrapped_charts_coverEachTriangleOnceWithoutOverlap_data();
    void unwrapped_charts_coverEachTriangleOnceWithoutOverlap();
    void unwrapped_fineTexel_staysWithinTheAllowedPixels();
    void painted_withoutArtwork_returnsTheModel();
    void pictureLayer_hasItsPlaceAndSize();
    void pictureLayer_widePicture_keepsItsProportions();
    void decal_acrossAnEdge_continuesOnTheNextFace();
    void layers_overlapping_coverEachOtherInOrder();
    void opacity_half_mixesLinearLight();
    void baseColour_unset_keepsTheModelsOwnColour();
    void layerTurn_isCounterclockwiseSeenFromOutside();
    void decal_gridOnCylinder_hasEvenStraightLines();
    void cylinderLayer_repeatRoundTube_isAWholeNumber();
    void patternRepeat_bordersMatchOppositeBorders();
    void patternRepeat_otherSeed_makesAnotherPattern();
    void planeLayer_paintsOnlyFacesTowardsIt();
    void boxLayer_betweenItsSides_showsNoLine();
    void textLayer_readsCorrectlyFromOutside();
    void cylinderLayer_onCup_hasItsLengthOutside();
    void cutOffWarnings_longerThanATurn_nameIt();
    void cutOffWarnings_decalThatReachesAnotherBody_tellHowMuchIsLost();
    void paintArtwork_overlappingLetters_leaveNoGap();
    void fontWarnings_missingFont_nameIt();
    void fontWarnings_charactersThatNoFontHas_nameThem();
    void fontWarnings_scriptThatNoFontShapes_nameIt();
    void paintArtwork_wideColour_staysWide();
    void paintArtwork_twice_givesTheSameBits();
};

void ArtworkTest::unwrapped_charts_coverEachTriangleOnceWithoutOverlap_data() {
    QTest::addColumn<TriangleMesh>("mesh");
    QTest::newRow("box") << boxMesh({10, 20, 30});
    QTest::newRow("sphere") << sphereMesh(30, 40, 80);
    QTest::newRow("cylinder") << cylinderMesh(20, 60, 64);
    QTest::newRow("torus") << torusMesh(30, 10, 60, 120);
    QTest::newRow("tetrahedron") << tetrahedronMesh(40);
    QTest::newRow("spiral") << spiralRamp();
}

void ArtworkTest::unwrapped_charts_coverEachTriangleOnceWithoutOverlap() {
    QFETCH(TriangleMesh, mesh);
    const auto last = std::uint32_t(mesh.triangles.size() - 1);
    const Unwrapping charts = unwrapped(mesh, {last, 0, last}, 0.25, 4'000'000, Progress());
    QCOMPARE(charts.chart[last], 0U);
    QCOMPARE(charts.corners.size(), mesh.triangles.size());
    std::vector<int> claims(
        charts.owner.size()); // per pixel: number of triangles whose inside contains its middle
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const auto& [a, b, c] = charts.corners[triangle];
        const Eigen::Vector2d u = (b - a).cast<double>(), v = (c - a).cast<double>();
        const double area = u.x() * v.y() - u.y() * v.x();
        QVERIFY(std::abs(area) > 0);
        const double whole = triangleArea(mesh, triangle) / (charts.texel * charts.texel);
        QVERIFY(std::abs(area) / 2 > 0.6 * whole && std::abs(area) / 2 < 1.01 * whole);
        for (const Eigen::Vector2f& corner : {a, b, c}) {
            QVERIFY(corner.minCoeff() >= 1 && corner.x() <= float(charts.width - 1) &&
                    corner.y() <= float(charts.height - 1));
        }
        const Eigen::AlignedBox2f box(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c));
        for (int row = int(box.min().y()); row <= int(box.max().y()); ++row) {
            for (int column = int(box.min().x()); column <= int(box.max().x()); ++column) {
                const Eigen::Vector2d p =
                    Eigen::Vector2d(column + 0.5, row + 0.5) - a.cast<double>();
                const double s = (p.x() * v.y() - p.y() * v.x()) / area;
                const double t = (u.x() * p.y() - u.y() * p.x()) / area;
                if (s > 1e-3 && t > 1e-3 && s + t < 1 - 1e-3) {
                    ++claims[std::size_t(row) * std::size_t(charts.width) + std::size_t(column)];
                }
            }
        }
    }
    QCOMPARE(*std::max_element(claims.begin(), claims.end()), 1);
    const auto used = std::count(claims.begin(), claims.end(), 1);
    QVERIFY(double(used) > 0.25 * double(claims.size())); // and the picture is not mostly empty
}

void ArtworkTest::unwrapped_fineTexel_staysWithinTheAllowedPixels() {
    const TriangleMesh mesh = sphereMesh(100, 30, 60);
    const Unwrapping charts = unwrapped(mesh, {}, 0.001, 500'000, Progress());
    QVERIFY(qint64(charts.width) * charts.height <= 500'000);
    QVERIFY(qint64(charts.width) * charts.height > 200'000);
}

void ArtworkTest::painted_withoutArtwork_returnsTheModel() {
    const auto model = std::make_shared<const TexturedMesh>(bodyOf(boxMesh({10, 10, 10})));
    QCOMPARE(painted(model, {}, 0.1, Progress()), model);
}

void ArtworkTest::pictureLayer_hasItsPlaceAndSize() {
    Artwork artwork;
    artwork.base = Qt::white;
    for (const int pixels : {40, 1}) { // a single pixel has edges as sharp
        artwork.layers = {pictureLayer(plain(Qt::red, {pixels, pixels}), {10, 5, 30}, 20)};
        const TexturedMesh body = paintedBox(artwork);
        QCOMPARE(body.textures.size(), std::size_t(1));
        QCOMPARE(body.mesh.triangles.size(), std::size_t(12));
        for (const double edge : {-9.7, 0.0, 9.7}) {
            QVERIFY(isNear(colourAt(body, {10 + edge, 5, 30}), Qt::red));
            QVERIFY(isNear(colourAt(body, {10, 5 + edge, 30}), Qt::red));
        }
        for (const double beyond : {-10.3, 10.3}) {
            QVERIFY(isNear(colourAt(body, {10 + beyond, 5, 30}), Qt::white));
            QVERIFY(isNear(colourAt(body, {10, 5 + beyond, 30}), Qt::white));
        }
        QVERIFY(isNear(colourAt(body, {10, 5, -30}), Qt::white));
    }
}

void ArtworkTest::pictureLayer_widePicture_keepsItsProportions() {
    Artwork artwork;
    artwork.base = Qt::white;
    artwork.layers = {pictureLayer(plain(Qt::red, {80, 40}), {0, 0, 30}, 20)};
    const TexturedMesh body = paintedBox(artwork);
    QVERIFY(isNear(colourAt(body, {9.6, 0, 30}), Qt::red));
    QVERIFY(isNear(colourAt(body, {0, 4.6, 30}), Qt::red));
    QVERIFY(isNear(colourAt(body, {0, 5.4, 30}), Qt::white));
}

void ArtworkTest::decal_acrossAnEdge_continuesOnTheNextFace() {
    Artwork artwork;
    artwork.base = Qt::white;
    artwork.layers = {pictureLayer(plain(Qt::blue), {25, 0, 30}, 20)};
    const TexturedMesh body = paintedBox(artwork);
    // 10 mm to the right of the middle: 5 on the front and 5 round the edge.
    QVERIFY(isNear(colourAt(body, {30, 0, 30 - 4.6}), Qt::blue));
    QVERIFY(isNear(colourAt(body, {30, 9.6, 30 - 4.6}), Qt::blue));
    QVERIFY(isNear(colourAt(body, {30, 0, 30 - 5.4}), Qt::white));
    QVERIFY(isNear(colourAt(body, {30, 10.4, 30 - 4.6}), Qt::white));
}

void ArtworkTest::layers_overlapping_coverEachOtherInOrder() {
    Artwork artwork;
    artwork.base = Qt::white;
    artwork.layers = {pictureLayer(plain(Qt::red), {0, 0, 30}, 20),
                      pictureLayer(plain(Qt::blue), {5, 0, 30}, 10)};
    QVERIFY(isNear(colourAt(paintedBox(artwork), {5, 0, 30}), Qt::blue));
    QVERIFY(isNear(colourAt(paintedBox(artwork), {-5, 0, 30}), Qt::red));
    std::swap(artwork.layers[0], artwork.layers[1]);
    QVERIFY(isNear(colourAt(paintedBox(artwork), {5, 0, 30}), Qt::red));
    artwork.layers[1].visible = false;
    QVERIFY(isNear(colourAt(paintedBox(artwork), {5, 0, 30}), Qt::blue));
    QVERIFY(isNear(colourAt(paintedBox(artwork), {-5, 0, 30}), Qt::white));
}

void ArtworkTest::opacity_half_mixesLinearLight() {
    Artwork artwork;
    artwork.base = Qt::white;
    artwork.layers = {pictureLayer(plain(Qt::black), {0, 0, 30}, 20)};
    artwork.layers.front().opacity = 0.5;
    QVERIFY(isNear(colourAt(paintedBox(artwork), {0, 0, 30}),
                   QColor(188, 188, 188))); // half of the light
    QColor seeThrough(Qt::black);
    seeThrough.setAlpha(128);
    artwork.layers = {pictureLayer(plain(seeThrough), {0, 0, 30}, 20)};
    QVERIFY(isNear(colourAt(paintedBox(artwork), {0, 0, 30}), QColor(187, 187, 187)));
}

void ArtworkTest::baseColour_unset_keepsTheModelsOwnColour() {
    TexturedMesh model = bodyOf(boxMesh({60, 60, 60}));
    model.materials.front().colour = QColor(10, 120, 200);
    Artwork artwork;
    artwork.layers = {pictureLayer(plain(Qt::red), {0, 0, 30}, 20)};
    const TexturedMesh own = paintArtwork(model, artwork, 0.3, Progress());
    QVERIFY(isNear(colourAt(own, {20, 20, 30}), QColor(10, 120, 200), 1));
    artwork.base = QColor(250, 240, 0);
    const TexturedMesh based = paintArtwork(model, artwork, 0.3, Progress());
    QVERIFY(isNear(colourAt(based, {20, 20, 30}), QColor(250, 240, 0), 1));

    // The model's own texture stays, with the layer drawn on it.
    model.textures = {plain(QColor(60, 160, 60))};
    model.materials.front().texture = 0;
    for (auto& corners : model.textureCoordinates) {
        corners = {Eigen::Vector2f(0.1F, 0.1F), Eigen::Vector2f(0.9F, 0.1F),
                   Eigen::Vector2f(0.1F, 0.9F)};
    }
    model.chart = findCharts(model);
    artwork.base.reset();
    const TexturedMesh textured = paintArtwork(model, artwork, 0.3, Progress());
    QVERIFY(isNear(colourAt(textured, {20, 20, 30}), QColor(60, 160, 60), 1));
    QVERIFY(isNear(colourAt(textured, {0, 0, 30}), Qt::red));
}

void ArtworkTest::layerTurn_isCounterclockwiseSeenFromOutside() {
    QImage halves = plain(Qt::red);
    for (int y = 0; y < 40; ++y) {
        for (int x = 20; x < 40; ++x) {
            halves.setPixelColor(x, y, Qt::blue); // the right half
        }
    }
    for (const LayerPlacement placement :
         {LayerPlacement::Decal, LayerPlacement::Plane, LayerPlacement::Box}) {
        Artwork artwork;
        artwork.base = Qt::white;
        artwork.layers = {pictureLayer(halves, {0, 0, 30}, 20)};
        artwork.layers.front().placement = placement;
        QVERIFY(isNear(colourAt(paintedBox(artwork), {5, 0, 30}), Qt::blue));
        artwork.layers.front().turn = Degrees(90);
        QVERIFY(isNear(colourAt(paintedBox(artwork), {0, 5, 30}), Qt::blue));
        QVERIFY(isNear(colourAt(paintedBox(artwork), {0, -5, 30}), Qt::red));
    }
}

// Returns where a scan round a tube crosses dark lines, mm from the scan's beginning.
static std::vector<double> linesAround(const TexturedMesh& body, double radius, double z,
                                       double from, double to) {
    std::vector<double> found;
    bool wasDark = true;
    for (double angle = from; angle < to; angle += 0.02 / radius) {
        const bool isDark =
            colourAt(body, {radius * std::cos(angle), radius * std::sin(angle), z}).lightness() <
            128;
        if (isDark && !wasDark) {
            found.push_back(angle * radius);
        }
        wasDark = isDark;
    }
    return found;
}

void ArtworkTest::decal_gridOnCylinder_hasEvenStraightLines() {
    constexpr double radius = 25;
    constexpr int sides = 256;
    const TexturedMesh tube = bodyOf(cylinderMesh(radius, 80, sides));
    QImage lines = grid(100);
    lines = lines.transformed(QTransform().rotate(90)); // lines along the tube
    Artwork artwork;
    artwork.base = Qt::white;
    artwork.layers = {pictureLayer(lines, {radius, 0, 0}, 60)};
    artwork.layers.front().repeat = Millimetres(10);
    const TexturedMesh body = paintArtwork(tube, artwork, 0.1, Progress());
    const std::vector<double> middle = linesAround(body, radius, 0, -1.1, 1.1);
    QVERIFY(middle.size() >= 5);
    for (std::size_t k = 1; k < middle.size(); ++k) {
        QVERIFY2(std::abs(middle[k] - middle[k - 1] - 10) < 0.15,
                 qPrintable(QStringLiteral("lines are %1 mm apart, expected 10 mm")
                                .arg(middle[k] - middle[k - 1])));
    }
    QVERIFY(std::abs((middle.back() - middle.front()) / double(middle.size() - 1) - 10) < 0.03);
    for (const double z :
         {-20.0, 17.0}) { // the lines are straight: at the same places elsewhere along the tube
        const std::vector<double> there = linesAround(body, radius, z, -1.1, 1.1);
        QCOMPARE(there.size(), middle.size());
        for (std::size_t k = 0; k < there.size(); ++k) {
            QVERIFY(std::abs(there[k] - middle[k]) < 0.15);
        }
    }
}

void ArtworkTest::cylinderLayer_repeatRoundTube_isAWholeNumber() {
    constexpr double radius = 25; // 157 mm round
    const TexturedMesh tube = bodyOf(cylinderMesh(radius, 60, 128));
    const TexturedMesh body = paintArtwork(tube, repeatedRoundZ(), 0.15, Progress());
    const std::vector<double> lines = linesAround(body, radius, 3, 0.01, 0.01 + 2 * pi);
    QCOMPARE(lines.size(), std::size_t(16));
    for (std::size_t k = 1; k < lines.size(); ++k) {
        QVERIFY(std::abs(lines[k] - lines[k - 1] - 2 * pi * radius / 16) < 0.25);
    }
}

// The wall of a cup has an inner side, which is nearer to the axis.
void ArtworkTest::cylinderLayer_onCup_hasItsLengthOutside() {
    constexpr double radius = 25;
    TriangleMesh cup = cylinderMesh(radius, 60, 128);
    const TriangleMesh hole = cylinderMesh(radius - 4, 50, 128);
    const auto outside = std::uint32_t(cup.positions.size());
    cup.positions.insert(cup.positions.end(), hole.positions.begin(), hole.positions.end());
    for (const auto& corners : hole.triangles) { // look towards the axis
        cup.triangles.push_back({outside + corners[0], outside + corners[2], outside + corners[1]});
    }
    const TexturedMesh body = paintArtwork(bodyOf(cup), repeatedRoundZ(), 0.15, Progress());
    QCOMPARE(linesAround(body, radius, 3, 0.01, 0.01 + 2 * pi).size(), std::size_t(16));
}

void ArtworkTest::cutOffWarnings_longerThanATurn_nameIt() {
    const TriangleMesh tube = cylinderMesh(10, 60, 128); // 62.8 mm round
    Artwork artwork;
    artwork.layers = {pictureLayer(grid(100), {0, 0, 0}, 60)};
    ArtworkLayer& layer = artwork.layers.front();
    layer.placement = LayerPlacement::Cylinder;
    QVERIFY(cutOffWarnings(artwork, tube).isEmpty());
    layer.size = {Millimetres(70), Millimetres(70)};
    QCOMPARE(cutOffWarnings(artwork, tube).size(), 1);
    QVERIFY2(cutOffWarnings(artwork, tube).front().contains(QStringLiteral("70.0")),
             qPrintable(cutOffWarnings(artwork, tube).front()));
    layer.repeat = Millimetres(10); // repeats continue past the layer's size
    QVERIFY(cutOffWarnings(artwork, tube).isEmpty());
}

// The decal lies on the left body and should continue on the right one.
void ArtworkTest::cutOffWarnings_decalThatReachesAnotherBody_tellHowMuchIsLost() {
    const auto boxAt = [](double x, double length) {
        const Eigen::Isometry3d shift(Eigen::Translation3d(x, 0, 0));
        return transformed(boxMesh({length, 30, 30}), shift);
    };
    Artwork artwork;
    artwork.layers = {pictureLayer(grid(100), {-10, 0, 15}, 16)};
    const TriangleMesh apart = test::joined(boxAt(-16, 28), boxAt(20, 28));
    QVERIFY(cutOffWarnings(artwork, apart).isEmpty()); // ends before the edge
    artwork.layers[0].size = {Millimetres(20), Millimetres(20)};
    QVERIFY(cutOffWarnings(artwork, boxAt(-16, 32)).isEmpty()); // one body: goes round its edge
    const TriangleMesh flush = test::joined(boxAt(-14, 28), boxAt(14, 28));
    QVERIFY(cutOffWarnings(artwork, flush).isEmpty()); // ends at the edge
    artwork.layers[0].place = {Millimetres(-4), Millimetres(0), Millimetres(15)};
    for (const TriangleMesh& bodies : {flush, test::joined(boxAt(-14, 28), boxAt(13, 28))}) {
        const QStringList warnings = cutOffWarnings(artwork, bodies);
        QCOMPARE(warnings.size(), 1); // 6 of 20 mm
        static const QRegularExpression share(QStringLiteral("about (\\d+) %"));
        const double lost = share.match(warnings.front()).captured(1).toDouble();
        QVERIFY2(std::abs(lost - 30) < 4, qPrintable(warnings.front()));
        QVERIFY(warnings.front().contains(artwork.layers[0].name));
    }
    artwork.layers[0].visible = false;
    QVERIFY(cutOffWarnings(artwork, flush).isEmpty());
}

void ArtworkTest::patternRepeat_bordersMatchOppositeBorders() {
    for (const LayerKind kind : {LayerKind::Carbon, LayerKind::Camouflage, LayerKind::Wood}) {
        const QImage repeat = patternRepeat(newLayer(kind, {}), 200);
        if (const QString folder = qEnvironmentVariable("DIPWRIGHT_PICTURES"); !folder.isEmpty()) {
            repeat.save(QStringLiteral("%1/pattern-%2.png").arg(folder).arg(int(kind)));
        }
        // Across the border, neighbouring pixels differ on average no more than they do inside.
        const auto difference = [&](int a, int b, bool isColumn) {
            double sum = 0;
            for (int k = 0; k < 200; ++k) {
                const QColor one = isColumn ? repeat.pixelColor(a, k) : repeat.pixelColor(k, a);
                const QColor other = isColumn ? repeat.pixelColor(b, k) : repeat.pixelColor(k, b);
                sum += std::abs(one.lightness() - other.lightness());
            }
            return sum / 200;
        };
        for (const bool isColumn : {true, false}) {
            double most = 0;
            for (int k = 1; k < 200; ++k) {
                most = std::max(most, difference(k - 1, k, isColumn));
            }
            QVERIFY(difference(199, 0, isColumn) <= 1.3 * most);
        }
    }
}

void ArtworkTest::patternRepeat_otherSeed_makesAnotherPattern() {
    ArtworkLayer layer = newLayer(LayerKind::Camouflage, {});
    const QImage one = patternRepeat(layer, 100);
    QCOMPARE(patternRepeat(layer, 100), one);
    layer.seed = 2;
    QVERIFY(patternRepeat(layer, 100) != one);
}

// Tests soft waves that six sides of a box project onto a ball. They blend into each other between
// the sides.
void ArtworkTest::boxLayer_betweenItsSides_showsNoLine() {
    QImage waves(64, 64, QImage::Format_RGBA8888);
    for (int column = 0; column < 64; ++column) {
        const int grey = 128 + int(std::lround(90 * std::sin(2 * pi * column / 64)));
        for (int row = 0; row < 64; ++row) {
            waves.setPixelColor(column, row, QColor(grey, grey, grey));
        }
    }
    Artwork artwork;
    artwork.layers = {pictureLayer(waves, {1, 2, 3}, 50)};
    artwork.layers[0].placement = LayerPlacement::Box;
    artwork.layers[0].repeat = Millimetres(17);
    const double radius = 30;
    const TexturedMesh body =
        paintArtwork(bodyOf(sphereMesh(radius, 90, 180)), artwork, 0.2, Progress());
    int last = -1, most = 0;
    for (double angle = 25; angle <= 65;
         angle += 0.5) { // across the line between two sides at 45°, 0.26 mm a step
        const double turn = angle * pi / 180;
        const QColor colour = colourAt(body, {radius * std::sin(turn), 0, radius * std::cos(turn)});
        most = std::max(most, last < 0 ? 0 : std::abs(colour.red() - last));
        last = colour.red();
    }
    QVERIFY2(
        most < 20,
        qPrintable(
            QStringLiteral("neighbouring colours differ by %1 of 255, expected < 20").arg(most)));
}

void ArtworkTest::planeLayer_paintsOnlyFacesTowardsIt() {
    Artwork artwork;
    artwork.base = Qt::white;
    artwork.layers = {pictureLayer(plain(Qt::red), {0, 0, 0}, 20)};
    artwork.layers.front().placement = LayerPlacement::Plane;
    artwork.layers.front().axis = LayerAxis::MinusX;
    const TexturedMesh body = paintedBox(artwork);
    QVERIFY(isNear(colourAt(body, {-30, 5, 5}), Qt::red));
    QVERIFY(isNear(colourAt(body, {30, 5, 5}), Qt::white));
    QVERIFY(isNear(colourAt(body, {0, 0, 30}), Qt::white));
}

void ArtworkTest::textLayer_readsCorrectlyFromOutside() {
    const Artwork artwork = textOnTop(QStringLiteral("L"));
    const TexturedMesh body = paintedBox(artwork);
    const double width = 40 * proportionsOf(artwork.layers.front());
    QVERIFY(width > 15 && width < 40);
    const double left = -width / 2 + 1;
    QVERIFY(isNear(colourAt(body, {left, 15, 30}), Qt::black));   // the stem
    QVERIFY(isNear(colourAt(body, {-left, -19, 30}), Qt::black)); // the foot, to the right
    QVERIFY(isNear(colourAt(body, {-left, 10, 30}), Qt::white));
}

void ArtworkTest::paintArtwork_overlappingLetters_leaveNoGap() {
    // A letter with a long stroke through it.
    const TexturedMesh body = paintedBox(textOnTop(QStringLiteral("O\u0336")));
    const auto isBlack = [&](double x, double y) {
        return isNear(colourAt(body, {x, y, 30}), Qt::black);
    };
    double height = -10; // of the stroke
    while (height < 10 && !isBlack(0, height)) {
        height += 0.25;
    }
    height += 0.5;
    int changes = 0; // of colour, from left to right
    for (double x = -25; x < 25; x += 0.25) {
        changes += isBlack(x, height) != isBlack(x + 0.25, height);
    }
    QCOMPARE(changes, 2);
}

void ArtworkTest::fontWarnings_missingFont_nameIt() {
    Artwork artwork;
    artwork.layers = {newLayer(LayerKind::Text, QStringLiteral("Title"))};
    QVERIFY(fontWarnings(artwork).isEmpty());
    artwork.layers.front().font = QStringLiteral("No Such Letters");
    QCOMPARE(fontWarnings(artwork).size(), 1);
    QVERIFY(fontWarnings(artwork).front().contains(QLatin1String("No Such Letters")));
}

void ArtworkTest::fontWarnings_charactersThatNoFontHas_nameThem() {
    const QString unassigned(QChar(0x0378)); // a code point that Unicode never gave a character
    Artwork artwork;
    artwork.layers = {newLayer(LayerKind::Text, QStringLiteral("Title"))};
    ArtworkLayer& layer = artwork.layers.front();
    layer.text = QStringLiteral("Äé 7\nüa\u0301 \u200d");
    QVERIFY(fontWarnings(artwork).isEmpty());
    layer.text += unassigned + u'x' + unassigned;
    QCOMPARE(fontWarnings(artwork).size(), 1);
    QVERIFY(fontWarnings(artwork).front().contains(u' ' + unassigned + u' ')); // named once
    layer.visible = false;
    QVERIFY(fontWarnings(artwork).isEmpty());
}

void ArtworkTest::fontWarnings_scriptThatNoFontShapes_nameIt() {
    Artwork artwork;
    artwork.layers = {newLayer(LayerKind::Text, QStringLiteral("Title"))};
    artwork.layers.front().text = QStringLiteral("A\u0928"); // Devanagari
    const bool isDrawn = !QFontDatabase::families(QFontDatabase::Devanagari).isEmpty();
    const QStringList warnings = fontWarnings(artwork);
    QCOMPARE(warnings.size(), isDrawn ? 0 : 1);
    QVERIFY(isDrawn || warnings.front().contains(QStringLiteral(" \u0928 ")));
}

void ArtworkTest::paintArtwork_wideColour_staysWide() {
    QImage wide(40, 40, QImage::Format_RGBA64);
    wide.fill(QColor::fromRgba64(0, 65535, 0));
    wide.setColorSpace(wideSpace());
    Artwork artwork;
    artwork.base = Qt::white;
    artwork.layers = {pictureLayer(wide, {0, 0, 30}, 20),
                      pictureLayer(plain(Qt::red), {0, 20, 30}, 10)};
    const TexturedMesh body = paintedBox(artwork);
    QVERIFY(isWide(body.textures.front()));
    QVERIFY(isNear(colourAt(body, {0, 20, 30}), Qt::red)); // sRGB's red, stored in wide colour
    const SurfacePoint place = placeAt(body, {0, 0, 30});
    QVERIFY(SurfaceColours(body).at({place}).front().isApprox(LinearColour(0, 1, 0), 1e-3F));
}

void ArtworkTest::paintArtwork_twice_givesTheSameBits() {
    Artwork artwork;
    artwork.base = Qt::white;
    artwork.layers = {newLayer(LayerKind::Carbon, {}), newLayer(LayerKind::Wood, {}),
                      pictureLayer(plain(Qt::red), {0, 30, 0}, 15)};
    artwork.layers[1].opacity = 0.3;
    const TexturedMesh model = bodyOf(sphereMesh(30, 24, 48));
    const TexturedMesh one = paintArtwork(model, artwork, 0.2, Progress());
    const TexturedMesh other = paintArtwork(model, artwork, 0.2, Progress());
    QCOMPARE(one.textures.front(), other.textures.front());
    QVERIFY(one.textureCoordinates == other.textureCoordinates);
}

void ArtworkTest::layerNotes_oneSpotInkInTwoOrders_saysWhichCounts() {
    Artwork artwork;
    artwork.layers.resize(2);
    artwork.layers[0].name = QStringLiteral("Lower");
    artwork.layers[1].name = QStringLiteral("Upper");
    artwork.layers[0].spot = artwork.layers[1].spot = QStringLiteral("Gold");
    QVERIFY(layerNotes(artwork).isEmpty());
    artwork.layers[1].spotFirst = true;
    const QStringList notes = layerNotes(artwork);
    QCOMPARE(notes.size(), 1);
    QVERIFY2(notes[0].contains("with the colour and order of “Lower”"), qPrintable(notes[0]));
    artwork.layers[0].visible = false;
    QVERIFY(layerNotes(artwork).isEmpty());
}

QTEST_MAIN(ArtworkTest)
#include "ArtworkTest.moc"
