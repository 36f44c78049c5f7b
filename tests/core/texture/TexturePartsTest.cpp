// Tests the parts of the reverse texture: light, ink, filters, charts, bleed and chessboard.
#include "DippedByHand.h"
#include "base/Units.h"
#include "geometry/Shapes.h"
#include "texture/Bleed.h"
#include "texture/ChartMap.h"
#include "texture/Chessboard.h"
#include "texture/Ink.h"
#include "texture/ReverseMap.h"
#include "texture/TextureSampler.h"

#include <QtTest>

#include <cmath>

using namespace dipwright;

namespace {

QImage filled(int width, int height, const QColor& colour) {
    QImage image(width, height, QImage::Format_RGBA8888);
    image.fill(colour);
    return image;
}

bool isNear(const LinearColour& one, const LinearColour& other, float tolerance) {
    return (one - other).abs().maxCoeff() <= tolerance;
}

TextureSteps texelSteps(const QImage& image, float right, float down) {
    TextureSteps steps;
    steps << right / float(image.width()), 0, 0, down / float(image.height());
    return steps;
}

LinearColour look(const TextureSampler& sampler, const Eigen::Vector2f& coordinate,
                  const TextureSteps& steps) {
    return sampler.sample(coordinate, sampler.footprint(steps));
}

// Adds two triangles that cover the box from (left, bottom) to (right, top) of the texture.
void addChart(TexturedMesh& model, float left, float bottom, float right, float top) {
    const auto first = std::uint32_t(model.mesh.positions.size());
    for (int corner = 0; corner < 4; ++corner) {
        model.mesh.positions.emplace_back(float(first), float(corner % 2), float(corner / 2));
    }
    model.mesh.triangles.push_back({first, first + 1, first + 3});
    model.mesh.triangles.push_back({first, first + 3, first + 2});
    model.textureCoordinates.push_back({{{left, bottom}, {right, bottom}, {right, top}}});
    model.textureCoordinates.push_back({{{left, bottom}, {right, top}, {left, top}}});
    model.material.insert(model.material.end(), 2, 0);
}

TexturedMesh atlas(const QImage& picture) {
    TexturedMesh model;
    Material material;
    material.texture = 0;
    model.materials.push_back(material);
    model.textures.push_back(picture);
    return model;
}

} // namespace

class TexturePartsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void encodedByte_invertsTheLinearTable();
    void inkCompensation_stretchedFilm_printsDenser();
    void inkCompensation_limit_isKept();
    void inkCompensation_blackAndWhite_stay();
    void inkCompensation_switchedOff_changesNothing();
    void textureSampler_magnified_interpolates();
    void textureSampler_minifiedChecker_isGreyInLinearLight();
    void textureSampler_oddSize_keepsItsMean();
    void textureSampler_anisotropicFootprint_doesNotBlurAcross();
    void textureSampler_edges_wrapOnlyIfTheTextureRepeats();
    void textureSampler_transparentTexels_showWhite();
    void textureSampler_sampleWithin_staysInItsChart();
    void chartMap_wholeOrRepeatedTexture_isNotNeeded();
    void continueColour_takesTheNearestColour();
    void continueColour_endsAtItsRadius();
    void chessboard_squaresMeetInTheMiddle();
    void reverseMap_filmGatheredToAPoint_findsTheSurface();
};

void TexturePartsTest::encodedByte_invertsTheLinearTable() {
    for (int value = 0; value < 256; ++value) {
        QCOMPARE(int(encodedByte(linearTable()[std::size_t(value)])), value);
    }
    QCOMPARE(int(encodedByte(-1)), 0);
    QCOMPARE(int(encodedByte(2)), 255);
    QCOMPARE(int(encodedByte(0.5f)), 188);
}

void TexturePartsTest::inkCompensation_stretchedFilm_printsDenser() {
    const InkCompensation ink(InkSettings{});
    const LinearColour wanted(0.5f, 0.8f, 0.2f);
    for (const float stretch : {0.8f, 1.0f, 1.3f, 2.0f}) {
        const InkCompensation::Ink printed = ink.print(wanted, stretch);
        for (int channel = 0; channel < 3; ++channel) {
            const float density = -std::log10(wanted[channel]);
            QVERIFY(std::abs(-std::log10(printed.colour[channel]) - stretch * density) < 1e-4f);
        }
        QVERIFY(!printed.fallsShort);
        QVERIFY(isNear(ink.shown(printed.colour, stretch), wanted, 1e-4f));
    }
}

void TexturePartsTest::inkCompensation_limit_isKept() {
    InkSettings settings;
    settings.limit = 1;
    const InkCompensation ink(settings);
    const InkCompensation::Ink dark = ink.print({0.2f, 0.9f, 0.9f}, 2);
    QVERIFY(std::abs(dark.colour[0] - 0.1f) < 1e-5f);
    QVERIFY(dark.fallsShort);
    QVERIFY(!ink.print({0.4f, 0.9f, 0.9f}, 2).fallsShort);
    // A colour denser than the limit is printed unchanged.
    QVERIFY(std::abs(ink.print({0.03f, 1, 1}, 2).colour[0] - 0.03f) < 1e-5f);
    QVERIFY(!ink.print({0.03f, 1, 1}, 1).fallsShort);
}

void TexturePartsTest::inkCompensation_blackAndWhite_stay() {
    const InkCompensation ink(InkSettings{});
    for (const float stretch : {0.0f, 0.5f, 1.0f, 3.0f}) {
        QVERIFY(isNear(ink.print({1, 1, 1}, stretch).colour, {1, 1, 1}, 0));
        QVERIFY(isNear(ink.print({0, 0, 0}, stretch).colour, {0, 0, 0}, 0));
    }
    QVERIFY(!ink.print({0, 0, 0}, 1).fallsShort);
    QVERIFY(ink.print({0, 0, 0}, 1.5f).fallsShort);
}

void TexturePartsTest::inkCompensation_switchedOff_changesNothing() {
    InkSettings settings;
    settings.compensate = false;
    const InkCompensation::Ink printed = InkCompensation(settings).print({0.1f, 0.5f, 0}, 3);
    QVERIFY(isNear(printed.colour, {0.1f, 0.5f, 0}, 0));
    QVERIFY(!printed.fallsShort);
}

void TexturePartsTest::textureSampler_magnified_interpolates() {
    QImage image = filled(2, 1, Qt::black);
    image.setPixelColor(1, 0, Qt::white);
    const TextureSampler sampler(image, false);
    const TextureSteps steps = texelSteps(image, 0.01f, 0.01f);
    QVERIFY(isNear(look(sampler, {0.25f, 0.5f}, steps), {0, 0, 0}, 1e-5f));
    QVERIFY(isNear(look(sampler, {0.5f, 0.5f}, steps), {0.5f, 0.5f, 0.5f}, 1e-5f));
    QVERIFY(isNear(look(sampler, {0.625f, 0.5f}, steps), {0.75f, 0.75f, 0.75f}, 1e-5f));
    QVERIFY(isNear(look(sampler, {0.99f, 0.5f}, steps), {1, 1, 1}, 1e-5f));
}

void TexturePartsTest::textureSampler_minifiedChecker_isGreyInLinearLight() {
    QImage image = filled(64, 64, Qt::black);
    for (int row = 0; row < 64; ++row) {
        for (int column = row % 2; column < 64; column += 2) {
            image.setPixelColor(column, row, Qt::white);
        }
    }
    const TextureSampler sampler(image, false);
    for (const float step : {2.0f, 3.3f, 8.0f, 64.0f}) {
        const LinearColour grey = look(sampler, {0.37f, 0.61f}, texelSteps(image, step, step));
        QVERIFY(isNear(grey, {0.5f, 0.5f, 0.5f}, 0.01f));
    }
}

void TexturePartsTest::textureSampler_oddSize_keepsItsMean() {
    // One white column of seven gives 1/7 of the light, at every position.
    for (int white = 0; white < 7; ++white) {
        QImage image = filled(7, 5, Qt::black);
        for (int row = 0; row < 5; ++row) {
            image.setPixelColor(white, row, Qt::white);
        }
        const LinearColour mean =
            look(TextureSampler(image, false), {0.5f, 0.5f}, texelSteps(image, 1000, 1000));
        QVERIFY(isNear(mean, LinearColour::Constant(1.0f / 7), 0.001f));
    }
}

void TexturePartsTest::textureSampler_anisotropicFootprint_doesNotBlurAcross() {
    // The texture has stripes along u. Pixels are six texels long along u and one texel wide.
    QImage image = filled(64, 64, Qt::black);
    for (int row = 0; row < 64; row += 4) {
        for (int column = 0; column < 64; ++column) {
            image.setPixelColor(column, row, Qt::white);
            image.setPixelColor(column, row + 1, Qt::white);
        }
    }
    const TextureSampler sampler(image, false);
    const TextureSteps steps = texelSteps(image, 6, 1);
    QVERIFY(look(sampler, {0.5f, 1 - 33 / 64.0f}, steps)[0] > 0.95f);
    QVERIFY(look(sampler, {0.5f, 1 - 35 / 64.0f}, steps)[0] < 0.05f);
}

void TexturePartsTest::textureSampler_edges_wrapOnlyIfTheTextureRepeats() {
    QImage image = filled(4, 1, Qt::black);
    image.setPixelColor(3, 0, Qt::white);
    const TextureSteps steps = texelSteps(image, 0.01f, 0.01f);
    QVERIFY(isNear(look(TextureSampler(image, false), {0, 0.5f}, steps), {0, 0, 0}, 1e-5f));
    QVERIFY(isNear(look(TextureSampler(image, true), {0, 0.5f}, steps), {0.5f, 0.5f, 0.5f}, 1e-5f));
    QVERIFY(isNear(look(TextureSampler(image, true), {-0.125f, 7.5f}, steps), {1, 1, 1}, 1e-5f));
    QVERIFY(isNear(look(TextureSampler(image, true), {2.875f, -1}, steps), {1, 1, 1}, 1e-5f));
}

void TexturePartsTest::textureSampler_transparentTexels_showWhite() {
    const TextureSampler clear(filled(2, 2, QColor(255, 0, 0, 0)), false);
    QVERIFY(isNear(clear.sample({0.5f, 0.5f}, {}), {1, 1, 1}, 1e-5f));
    const TextureSampler half(filled(2, 2, QColor(0, 0, 0, 128)), false);
    QVERIFY(isNear(half.sample({0.5f, 0.5f}, {}), LinearColour::Constant(127 / 255.0f), 0.005f));
}

void TexturePartsTest::textureSampler_sampleWithin_staysInItsChart() {
    // A red and a blue chart meet in the middle, on a green ground.
    QImage image = filled(32, 32, Qt::green);
    for (int row = 8; row < 24; ++row) {
        for (int column = 4; column < 28; ++column) {
            image.setPixelColor(column, row, column < 16 ? Qt::red : Qt::blue);
        }
    }
    TexturedMesh model = atlas(image);
    addChart(model, 4 / 32.0f, 8 / 32.0f, 0.5f, 24 / 32.0f);
    addChart(model, 0.5f, 8 / 32.0f, 28 / 32.0f, 24 / 32.0f);
    model.chart = findCharts(model);
    const auto charts = ChartMap::of(model, 0);
    QVERIFY(charts);
    const TextureSampler sampler(image, false);
    for (const float step : {0.1f, 1.0f, 3.0f}) {
        const TextureSteps steps = texelSteps(image, step, step);
        const auto within = [&](float u, float v, std::uint32_t chart) {
            return sampler.sampleWithin({u, v}, steps, *charts, chart);
        };
        const LinearColour red(1, 0, 0);
        const LinearColour blue(0, 0, 1);
        QVERIFY(isNear(within(0.5f, 0.5f, model.chart[0]), red, 1e-5f));
        QVERIFY(isNear(within(0.5f, 0.5f, model.chart[2]), blue, 1e-5f));
        QVERIFY(isNear(within(4 / 32.0f, 8 / 32.0f, model.chart[0]), red, 1e-5f));
        QVERIFY(isNear(within(28 / 32.0f, 24 / 32.0f, model.chart[2]), blue, 1e-5f));
    }
    const TextureSteps steps = texelSteps(image, 0.1f, 0.1f);
    const std::array<Eigen::Vector2f, 3> atTheBorder = {
        {{0.4f, 0.5f}, {0.49f, 0.5f}, {0.4f, 0.4f}}};
    QVERIFY(!sampler.isWithin(atTheBorder, steps, *charts, model.chart[0]));
}

void TexturePartsTest::chartMap_wholeOrRepeatedTexture_isNotNeeded() {
    TexturedMesh whole = atlas(filled(8, 8, Qt::red));
    addChart(whole, 0, 0, 1, 1);
    whole.chart = findCharts(whole);
    QVERIFY(!ChartMap::of(whole, 0));
    TexturedMesh tiled = atlas(filled(8, 8, Qt::red));
    addChart(tiled, 0, 0, 3, 0.5f);
    tiled.chart = findCharts(tiled);
    QVERIFY(textureRepeats(tiled, 0));
    QVERIFY(!textureRepeats(whole, 0));
}

void TexturePartsTest::continueColour_takesTheNearestColour() {
    QImage image = filled(60, 40, Qt::transparent);
    image.fill(0u);
    const std::vector<std::pair<QPoint, QColor>> seeds = {
        {{10, 10}, Qt::red}, {{40, 12}, Qt::blue}, {{25, 33}, Qt::yellow}};
    for (const auto& [place, colour] : seeds) {
        image.setPixelColor(place, colour);
    }
    continueColour(image, 18);
    for (int row = 0; row < 40; ++row) {
        for (int column = 0; column < 60; ++column) {
            double nearest = 1e9;
            double second = 1e9;
            QColor expected;
            for (const auto& [place, colour] : seeds) {
                const double distance = std::hypot(place.x() - column, place.y() - row);
                if (distance < nearest) {
                    second = nearest;
                    nearest = distance;
                    expected = colour;
                } else {
                    second = std::min(second, distance);
                }
            }
            const QColor found = image.pixelColor(column, row);
            QCOMPARE(found.alpha(), nearest <= 18 ? 255 : 0);
            if (nearest <= 18 && second > nearest) {
                QCOMPARE(found.rgb(), expected.rgb());
            }
        }
    }
}

void TexturePartsTest::continueColour_endsAtItsRadius() {
    QImage image = filled(50, 50, Qt::transparent);
    image.fill(0u);
    image.setPixelColor(25, 25, Qt::red);
    QImage none = image;
    continueColour(none, 0);
    QVERIFY(none == image);
    continueColour(image, 7.5);
    int printed = 0;
    for (int row = 0; row < 50; ++row) {
        for (int column = 0; column < 50; ++column) {
            printed += image.pixelColor(column, row).alpha() ? 1 : 0;
        }
    }
    QVERIFY(std::abs(printed - pi * 7.5 * 7.5) < 8);
}

void TexturePartsTest::chessboard_squaresMeetInTheMiddle() {
    const QImage board = chessboard({2, 2, 200, 100}, 17, {400, 200});
    QCOMPARE(board.size(), QSize(400, 200));
    const auto isWhite = [&](int x, int y) { return board.pixelColor(x, y) == QColor(Qt::white); };
    QVERIFY(isWhite(199, 99) == isWhite(200, 100));
    QVERIFY(isWhite(200, 99) == isWhite(199, 100));
    QVERIFY(isWhite(199, 99) != isWhite(200, 99));
    QVERIFY(isWhite(200, 100) == isWhite(233, 133));
    QVERIFY(isWhite(200, 100) != isWhite(234, 133));
    QVERIFY(isWhite(200, 100) != isWhite(233, 134));
}

// Film that is compressed to a point has triangles without area. Because of rounding they do not
// lie exactly on the surface.
void TexturePartsTest::reverseMap_filmGatheredToAPoint_findsTheSurface() {
    const TexturedMesh model = test::plainModel(sphereMesh(35, 40, 80), Qt::red);
    DippedFilm film = test::viscousOnSphere(test::a4Grid(), 35, 1.2);
    const Eigen::Vector3f beside = film.positions[film.positions.size() / 2] * 1.001f;
    FilmContact contact;
    contact.places.assign(film.positions.size(), beside);
    contact.surface.resize(film.positions.size());
    contact.painted.assign(filmTriangles(film.grid).size(), 1);
    const LaidFilm laid(std::make_shared<const PosedBody>(posedBody(model.mesh, {})),
                        std::move(film), std::move(contact));
    for (const SurfacePoint& corner : ReverseMap(laid, model).whole(0).surface) {
        QVERIFY(corner.isValid());
    }
}

QTEST_APPLESS_MAIN(TexturePartsTest)
#include "TexturePartsTest.moc"
