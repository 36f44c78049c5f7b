// Tests reverse textures. The films are laid on the body by formulas, without a solver.
#include "texture/ReverseTexture.h"
#include "DippedByHand.h"
#include "base/Units.h"
#include "base/WideGamut.h"
#include "geometry/Shapes.h"
#include "parallel/Threads.h"
#include "texture/LinearLight.h"
#include "texture/StretchPlane.h"

#include <QtTest>

#include <cmath>
#include <complex>
#include <functional>

using namespace dipwright;

namespace {

constexpr double radius = 35;
const Eigen::Vector3d boxSize(60, 30, 60);
const QSize a4Pixels(1240, 1754); // 150 dpi

using Pattern = std::function<LinearColour(double u, double v)>;

// Returns a picture of a pattern. Each texel has the colour at its middle.
QImage drawn(const Pattern& pattern, QSize size) {
    QImage image(size, QImage::Format_RGBA8888);
    for (int row = 0; row < size.height(); ++row) {
        auto* texel = image.scanLine(row);
        for (int column = 0; column < size.width(); ++column, texel += 4) {
            const LinearColour colour =
                pattern((column + 0.5) / size.width(), 1 - (row + 0.5) / size.height());
            for (int channel = 0; channel < 3; ++channel) {
                texel[channel] = encodedByte(colour[channel]);
            }
            texel[3] = 255;
        }
    }
    return image;
}

// Returns smooth waves that are continuous where the map closes.
LinearColour waves(double u, double v) {
    return Eigen::Array3d(0.5 + 0.4 * std::sin(6 * pi * u), 0.5 + 0.4 * std::cos(4 * pi * u),
                          0.5 + 0.4 * std::sin(10 * pi * v))
        .cast<float>();
}

ReverseTexture reversed(const TexturedMesh& model, const DippedFilm& film,
                        const ReverseTextureOptions& options, const Progress& progress = {}) {
    return reverseTexture(*test::laid(model.mesh, film), model, options, progress);
}

ReverseTextureOptions uncompensated(QSize pixels = a4Pixels) {
    ReverseTextureOptions options;
    options.pixels = pixels;
    options.ink.compensate = false;
    return options;
}

// Returns where the middle of a pixel lies on the film, mm.
Eigen::Vector2d place(const QImage& image, int column, int row) {
    return {((column + 0.5) / image.width() - 0.5) * 210,
            ((row + 0.5) / image.height() - 0.5) * 297};
}

template <typename Visit>
void forEachPixel(const QImage& image, const Visit& visit) {
    for (int row = 0; row < image.height(); ++row) {
        const auto* pixel = image.constScanLine(row);
        for (int column = 0; column < image.width(); ++column, pixel += 4) {
            visit(place(image, column, row), pixel);
        }
    }
}

int difference(const unsigned char* pixel, const LinearColour& expected) {
    int most = 0;
    for (int channel = 0; channel < 3; ++channel) {
        most = std::max(most, std::abs(pixel[channel] - encodedByte(expected[channel])));
    }
    return most;
}

} // namespace

class ReverseTextureTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void reverseTexture_flatFace_givesThePicture_data();
    void reverseTexture_flatFace_givesThePicture();
    void reverseTexture_letter_isMirroredInItsPlace();
    void reverseTexture_globe_showsItsMap();
    void reverseTexture_textureSeam_doesNotMixCharts_data();
    void reverseTexture_textureSeam_doesNotMixCharts();
    void reverseTexture_finePattern_isAveragedInLinearLight();
    void reverseTexture_lines_keepContrastWithoutAliasing_data();
    void reverseTexture_lines_keepContrastWithoutAliasing();
    void reverseTexture_bodyWithoutTexture_isItsColour();
    void reverseTexture_textureWithoutCoordinates_isTheMaterialsColour();
    void reverseTexture_colourBeyondSrgb_isKept();
    void reverseTexture_bleed_endsAtItsWidth();
    void reverseTexture_stretchedFilm_getsMoreInk();
    void reverseTexture_inkLimit_reportsShortfallArea();
    void reverseTexture_stretchedFilm_getsMoreWhite();
    void reverseTexture_keepsWanted_returnsWantedColourAndStretch();
    void reverseTexture_spotInks_keepTheirOrder();
    void reverseTexture_anyNumberOfThreads_giveTheSameBytes();
    void reverseTexture_tinyImage_isPainted();
    void reverseTexture_cancelled_throws();
};

void ReverseTextureTest::reverseTexture_flatFace_givesThePicture_data() {
    QTest::addColumn<bool>("graded");
    QTest::newRow("even film") << false;
    QTest::newRow("graded film") << true;
}

void ReverseTextureTest::reverseTexture_flatFace_givesThePicture() {
    QFETCH(bool, graded);
    const solver::FilmGrid grid = graded ? test::gradedA4Grid() : test::a4Grid();
    const QImage picture = drawn(waves, {512, 512});
    const ReverseTexture texture = reversed(test::boxWithPicture(boxSize, picture),
                                            test::flatUnderBox(grid, boxSize), uncompensated());
    QCOMPARE(texture.seamTriangles, std::size_t(0));
    QCOMPARE(texture.shortfallArea, 0.0);
    int compared = 0;
    forEachPixel(texture.image, [&](const Eigen::Vector2d& at, const unsigned char* pixel) {
        if (at.cwiseAbs().maxCoeff() < 29) {
            QCOMPARE(int(pixel[3]), 255);
            // A shift of 0.05 mm would change up to 4 of 255 levels.
            QVERIFY(difference(pixel, waves(0.5 - at.x() / 60, 0.5 - at.y() / 60)) <= 2);
            ++compared;
        }
    });
    QVERIFY(compared > 100000);
}

void ReverseTextureTest::reverseTexture_letter_isMirroredInItsPlace() {
    const QImage letter = test::letterF();
    const ReverseTexture texture =
        reversed(test::boxWithPicture(boxSize, letter), test::flatUnderBox(test::a4Grid(), boxSize),
                 uncompensated({2480, 3508}));
    // Seen from below with −Z up, the right of the picture is −X. On the sheet, ink side up, the
    // letter is mirrored left to right but not upside down.
    std::size_t same = 0;
    std::size_t all = 0;
    std::size_t sameUnmirrored = 0;
    forEachPixel(texture.image, [&](const Eigen::Vector2d& at, const unsigned char* pixel) {
        if (at.cwiseAbs().maxCoeff() < 29) {
            const int row = int((at.y() / 60 + 0.5) * 600);
            const int column = int((0.5 - at.x() / 60) * 600);
            const bool black = pixel[0] < 128;
            same += black == (letter.pixelColor(column, row).red() < 128);
            sameUnmirrored += black == (letter.pixelColor(599 - column, row).red() < 128);
            ++all;
        }
    });
    QVERIFY(double(same) > 0.998 * double(all));
    QVERIFY(double(sameUnmirrored) < 0.9 * double(all));
}

void ReverseTextureTest::reverseTexture_globe_showsItsMap() {
    const QImage picture = drawn(waves, {1024, 512});
    const double end = 1.8;
    const ReverseTexture texture =
        reversed(test::globe(radius, 160, 320, picture),
                 test::viscousOnSphere(test::a4Grid(), radius, end), uncompensated());
    QVERIFY(texture.seamTriangles > 0);
    int compared = 0;
    int wrong = 0;
    forEachPixel(texture.image, [&](const Eigen::Vector2d& at, const unsigned char* pixel) {
        const double distance = at.norm();
        const double angle = 2 * std::asin(std::min(1.0, distance / (2 * radius)));
        if (angle < end - 3 / radius && distance > 1) {
            const double turn = std::atan2(-at.x(), -at.y());
            const LinearColour expected = waves(0.5 + turn / (2 * pi), angle / pi);
            wrong += difference(pixel, expected) > 6 + 8 / distance || pixel[3] != 255;
            ++compared;
        }
    });
    QVERIFY(compared > 200000);
    QCOMPARE(wrong, 0);
}

void ReverseTextureTest::reverseTexture_textureSeam_doesNotMixCharts_data() {
    QTest::addColumn<int>("texels");
    QTest::newRow("texels smaller than pixels") << 4096;
    QTest::newRow("texels as large as pixels") << 1024;
    QTest::newRow("texels larger than pixels") << 128;
}

void ReverseTextureTest::reverseTexture_textureSeam_doesNotMixCharts() {
    QFETCH(int, texels);
    // The texture has a red and a blue disc on green: the ball is red for x < 0 and blue for x > 0.
    const auto discs = [](double u, double v) {
        const bool onDisc = std::hypot(u - (u < 0.5 ? 0.25 : 0.75), v - 0.5) <= 0.15;
        return onDisc ? LinearColour(u < 0.5 ? 1 : 0, 0, u < 0.5 ? 0 : 1) : LinearColour(0, 1, 0);
    };
    const QImage picture = drawn(discs, {texels, texels});
    const ReverseTexture texture =
        reversed(test::halvedBall(radius, 60, 120, picture),
                 test::viscousOnSphere(test::a4Grid(), radius, 1.8), uncompensated());
    QVERIFY(texture.seamTriangles > 50);
    int stray = 0;
    int printed = 0;
    const double pixel = 210.0 / texture.image.width();
    forEachPixel(texture.image, [&](const Eigen::Vector2d& at, const unsigned char* bytes) {
        if (bytes[3] == 0) {
            return;
        }
        ++printed;
        const bool red = bytes[0] > 200 && bytes[2] < 40;
        const bool blue = bytes[2] > 200 && bytes[0] < 40;
        const bool onSeam = std::abs(at.x()) < 1.5 * pixel;
        stray += bytes[1] > 40 || !(onSeam || (at.x() < 0 ? red : blue));
    });
    QVERIFY(printed > 200000);
    QCOMPARE(stray, 0);
}

void ReverseTextureTest::reverseTexture_finePattern_isAveragedInLinearLight() {
    // The texture is a checkerboard of single texels. A pixel covers about 40 texels.
    QImage picture(2048, 2048, QImage::Format_RGBA8888);
    for (int row = 0; row < picture.height(); ++row) {
        for (int column = 0; column < picture.width(); ++column) {
            picture.setPixel(column, row, (row + column) % 2 ? 0xffffffffu : 0xff000000u);
        }
    }
    const ReverseTexture texture =
        reversed(test::boxWithPicture(boxSize, picture),
                 test::flatUnderBox(test::a4Grid(), boxSize), uncompensated());
    forEachPixel(texture.image, [&](const Eigen::Vector2d& at, const unsigned char* pixel) {
        if (at.cwiseAbs().maxCoeff() < 28) {
            QVERIFY(difference(pixel, LinearColour::Constant(0.5f)) <= 3);
        }
    });
}

void ReverseTextureTest::reverseTexture_lines_keepContrastWithoutAliasing_data() {
    QTest::addColumn<double>("texels"); // of the texture in a pixel's side
    for (const double texels : {1.0, 1.2, 1.4, 2.8, 4.0}) {
        QTest::addRow("%.1f texels per pixel", texels) << texels;
    }
}

// Waves of ¼, ¾, 1.05 and 1½ periods in a pixel. A mean over a pixel's square keeps 90, 30, 5 and
// 21 % of their contrast. Of the last three, only aliases remain.
void ReverseTextureTest::reverseTexture_lines_keepContrastWithoutAliasing() {
    QFETCH(double, texels);
    const double facePixels = 60.0 / 210 * a4Pixels.width();
    const int side = int(std::lround(texels * facePixels));
    const std::array<float, 256>& linear = linearTable();
    // Returns the contrast that remains of waves with so many periods in a pixel.
    const auto contrast = [&](const Eigen::Vector2d& periods) {
        const auto wave = [&](double u, double v) {
            return 2 * pi * facePixels * periods.dot(Eigen::Vector2d(u, v));
        };
        const QImage picture = drawn(
            [&](double u, double v) {
                return LinearColour::Constant(float(0.5 + 0.4 * std::sin(wave(u, v))));
            },
            {side, side});
        const ReverseTexture texture =
            reversed(test::boxWithPicture(boxSize, picture),
                     test::flatUnderBox(test::a4Grid(), boxSize), uncompensated());
        std::complex<double> sum = 0;
        double mean = 0, square = 0;
        int count = 0;
        forEachPixel(texture.image, [&](const Eigen::Vector2d& at, const unsigned char* pixel) {
            if (at.cwiseAbs().maxCoeff() < 26) {
                const double light = double(linear[pixel[0]]);
                sum += light * std::polar(1.0, wave(0.5 - at.x() / 60, 0.5 - at.y() / 60));
                mean += light;
                square += light * light;
                ++count;
            }
        });
        const double spread =
            std::sqrt(std::max(square / count - mean / count * mean / count, 0.0));
        return std::pair(2 * std::abs(sum) / count / 0.4, spread * std::sqrt(2.0) / 0.4);
    };
    const auto check = [](double value, double least, double most) {
        QVERIFY2(value >= least && value <= most, qPrintable(QString::number(value)));
    };
    check(contrast({0.25, 0}).first, 0.85, 1.02);
    check(contrast({0, 0.25}).first, 0.85, 1.02);
    check(contrast({0.18, 0.18}).first, 0.85, 1.02);
    if (texels > 2) { // otherwise the texture has no finer lines
        check(contrast({0.75, 0}).second, 0, 0.36);
        check(contrast({0, 1.05}).second, 0, 0.2);
    }
    if (texels > 3.5) {
        check(contrast({1.5, 0}).second, 0, 0.21);
    }
}

void ReverseTextureTest::reverseTexture_bodyWithoutTexture_isItsColour() {
    const QColor colour(180, 60, 20);
    const ReverseTexture texture =
        reversed(test::plainModel(sphereMesh(radius, 40, 80), colour),
                 test::viscousOnSphere(test::a4Grid(), radius, 1.2), uncompensated());
    int printed = 0;
    forEachPixel(texture.image, [&](const Eigen::Vector2d&, const unsigned char* pixel) {
        if (pixel[3]) {
            QCOMPARE(QColor(pixel[0], pixel[1], pixel[2]), colour);
            ++printed;
        }
    });
    QVERIFY(printed > 10000);
}

void ReverseTextureTest::reverseTexture_textureWithoutCoordinates_isTheMaterialsColour() {
    TexturedMesh model = test::plainModel(boxMesh(boxSize), QColor(10, 200, 30));
    model.materials[0].texture = 0;
    model.textures.push_back(test::letterF());
    const ReverseTexture texture =
        reversed(model, test::flatUnderBox(test::a4Grid(), boxSize), uncompensated());
    QCOMPARE(texture.image.pixelColor(620, 877), QColor(10, 200, 30));
}

void ReverseTextureTest::reverseTexture_colourBeyondSrgb_isKept() {
    const DippedFilm film = test::flatUnderBox(test::a4Grid(), boxSize);
    // Colours within sRGB give the same image from an sRGB and from a wide texture.
    const QImage picture = drawn(waves, {512, 512});
    ReverseTextureOptions options;
    options.pixels = a4Pixels;
    const QImage plain = reversed(test::boxWithPicture(boxSize, picture), film, options).image;
    const QImage wide =
        reversed(test::boxWithPicture(boxSize, inWide(picture)), film, options).image;
    QVERIFY(isWide(wide) && wide.colorSpace() == wideSpace());
    const QImage seen = inSrgb(wide);
    const unsigned char* other = plain.constBits();
    forEachPixel(seen, [&](const Eigen::Vector2d&, const unsigned char* pixel) {
        QCOMPARE(int(pixel[3]), int(other[3]));
        for (int channel = 0; pixel[3] != 0 && channel < 3; ++channel) {
            QVERIFY(std::abs(pixel[channel] - other[channel]) <= 1);
        }
        other += 4;
    });
    // Colours beyond sRGB are not clipped, not even in the bleed.
    QImage green(64, 64, QImage::Format_RGBA64);
    green.setColorSpace(QColorSpace::AdobeRgb);
    green.fill(QColor(20, 230, 20));
    green.convertToColorSpace(wideSpace());
    QVERIFY(!fitsInSrgb(green));
    const QImage printed =
        reversed(test::boxWithPicture(boxSize, green), film, uncompensated()).image;
    const auto* meant = reinterpret_cast<const quint16*>(green.constScanLine(0));
    int judged = 0;
    for (int row = 0; row < printed.height(); ++row) {
        const auto* pixel = reinterpret_cast<const quint16*>(printed.constScanLine(row));
        for (int column = 0; column < printed.width(); ++column, pixel += 4) {
            for (int channel = 0; pixel[3] != 0 && channel < 3; ++channel) {
                QVERIFY(std::abs(int(pixel[channel]) - int(meant[channel])) <= 20);
                ++judged;
            }
        }
    }
    QVERIFY(judged > 100000);
}

void ReverseTextureTest::reverseTexture_bleed_endsAtItsWidth() {
    const TexturedMesh model = test::plainModel(boxMesh(boxSize), QColor(10, 200, 30));
    const DippedFilm film = test::flatUnderBox(test::a4Grid(), boxSize);
    const Eigen::Vector2d painted(16.5 * film.grid.spacingX(0), 16.5 * film.grid.spacingZ(0));
    for (const double bleed : {0.0, 2.0, 5.0}) {
        ReverseTextureOptions options = uncompensated();
        options.bleed = bleed;
        const ReverseTexture texture = reversed(model, film, options);
        forEachPixel(texture.image, [&](const Eigen::Vector2d& at, const unsigned char* pixel) {
            const Eigen::Vector2d beyond = (at.cwiseAbs() - painted).cwiseMax(0);
            if (beyond.norm() < bleed - 0.2 || beyond.isZero()) {
                QCOMPARE(int(pixel[3]), 255);
            } else if (beyond.norm() > bleed + 0.2) {
                QCOMPARE(int(pixel[3]), 0);
            }
        });
    }
}

void ReverseTextureTest::reverseTexture_stretchedFilm_getsMoreInk() {
    // Flat film is stretched by 20 % in both directions, so that every cell covers 1.44 times its
    // area.
    DippedFilm film = test::flatUnderBox(test::a4Grid(), boxSize / 1.2);
    for (Eigen::Vector3f& position : film.positions) {
        position *= 1.2f;
    }
    const QColor colour(200, 120, 90);
    ReverseTextureOptions options;
    options.pixels = a4Pixels;
    const ReverseTexture texture =
        reversed(test::plainModel(boxMesh(boxSize), colour), film, options);
    const QColor printed = texture.image.pixelColor(620, 877);
    const auto density = [](int value) { return -std::log10(linearFromSrgb(value / 255.0)); };
    QVERIFY(std::abs(density(printed.red()) - 1.44 * density(colour.red())) < 0.01);
    QVERIFY(std::abs(density(printed.green()) - 1.44 * density(colour.green())) < 0.01);
    QVERIFY(std::abs(density(printed.blue()) - 1.44 * density(colour.blue())) < 0.01);
    QCOMPARE(texture.shortfallArea, 0.0);
}

void ReverseTextureTest::reverseTexture_inkLimit_reportsShortfallArea() {
    DippedFilm film = test::flatUnderBox(test::a4Grid(), boxSize / 1.2);
    for (Eigen::Vector3f& position : film.positions) {
        position *= 1.2f;
    }
    ReverseTextureOptions options;
    options.pixels = a4Pixels;
    options.ink.limit = 1;
    const ReverseTexture texture =
        reversed(test::plainModel(boxMesh(boxSize), QColor(0, 0, 0)), film, options);
    // All of the painted bottom is too pale. It has 27 × 27 stretched cells, between 28 × 28
    // points.
    const double painted = 27 * 27 * film.grid.spacingX(0) * film.grid.spacingZ(0) * 1.44;
    QVERIFY(std::abs(texture.shortfallArea - painted) < 0.01 * painted);
}

// A half tint is printed on film with an area stretch of 1.44. White extends as far as the colour
// and its bleed.
void ReverseTextureTest::reverseTexture_stretchedFilm_getsMoreWhite() {
    DippedFilm film = test::flatUnderBox(test::a4Grid(), boxSize / 1.2);
    for (Eigen::Vector3f& position : film.positions) {
        position *= 1.2f;
    }
    const TexturedMesh model = test::plainModel(boxMesh(boxSize), QColor(200, 60, 60));
    ReverseTextureOptions options;
    options.pixels = a4Pixels;
    const ReverseTexture plain = reversed(model, film, options);
    QVERIFY(plain.white.isNull());
    options.white = 0.5;
    const ReverseTexture texture = reversed(model, film, options);
    QCOMPARE(texture.image, plain.image);
    QCOMPARE(texture.white.size(), texture.image.size());
    for (int y = 0; y < texture.white.height(); ++y) {
        for (int x = 0; x < texture.white.width(); ++x) {
            const bool isPrinted = qAlpha(texture.image.pixel(x, y)) != 0;
            const int tint = texture.white.constScanLine(y)[x];
            QVERIFY2(isPrinted ? std::abs(tint - 255 * 0.72) < 4 : tint == 0,
                     qPrintable(QStringLiteral("tint %1 of 255").arg(tint)));
        }
    }
    options.white = 0.9; // the printed tint is limited to full tint
    const ReverseTexture full = reversed(model, film, options);
    QCOMPARE(int(full.white.constScanLine(full.white.height() / 2)[full.white.width() / 2]), 255);
}

// Returns the wanted colour and the film's stretch, for printers that compensate each ink.
void ReverseTextureTest::reverseTexture_keepsWanted_returnsWantedColourAndStretch() {
    DippedFilm film = test::flatUnderBox(test::a4Grid(), boxSize / 1.2);
    for (Eigen::Vector3f& position : film.positions) {
        position *= 1.2f;
    }
    const TexturedMesh model = test::plainModel(boxMesh(boxSize), QColor(200, 60, 60));
    ReverseTextureOptions options;
    options.pixels = a4Pixels;
    const ReverseTexture plain = reversed(model, film, options);
    QVERIFY(plain.wanted.isNull() && plain.stretch.isNull());
    options.returnsWanted = true;
    const ReverseTexture kept = reversed(model, film, options);
    QCOMPARE(kept.image, plain.image);
    options.ink.compensate = options.returnsWanted = false;
    QCOMPARE(kept.wanted, reversed(model, film, options).image);
    QCOMPARE(kept.stretch.size(), kept.image.size());
    int printed = 0;
    for (int y = 0; y < kept.stretch.height(); ++y) {
        const auto* codes = reinterpret_cast<const std::uint16_t*>(kept.stretch.constScanLine(y));
        for (int x = 0; x < kept.stretch.width(); ++x) {
            const bool isPrinted = qAlpha(kept.image.pixel(x, y)) != 0;
            const float wanted = isPrinted ? 1.44f : 1.0f;
            QVERIFY(std::abs(areaStretchOf(codes[x]) - wanted) < 0.02f);
            printed += isPrinted;
        }
    }
    QVERIFY(printed > 10'000);
}

// The colours and all plates come from the same laid film.
void ReverseTextureTest::reverseTexture_spotInks_keepTheirOrder() {
    const TexturedMesh box = test::boxWithPicture(boxSize, drawn(waves, {256, 256}));
    const auto laid = test::laid(box.mesh, test::flatUnderBox(test::a4Grid(), boxSize));
    ReverseTextureOptions options = uncompensated({210, 297});
    options.white = 0.5;
    const ReverseTexture alone = reverseTexture(*laid, box, options, {});
    QVERIFY(alone.spots.empty());
    for (const int grey : {0, 188, 255}) {
        options.spots.emplace_back([=] {
            QImage plate(8, 8, QImage::Format_RGBA8888);
            plate.fill(QColor(grey, grey, grey));
            return test::boxWithPicture(boxSize, plate);
        });
    }
    const ReverseTexture both = reverseTexture(*laid, box, options, {});
    QCOMPARE(both.image, alone.image);
    QCOMPARE(both.white, alone.white);
    QCOMPARE(both.spots.size(), std::size_t(3));
    std::vector<int> tints;
    for (const QImage& spot : both.spots) {
        QCOMPARE(spot.format(), QImage::Format_Grayscale8);
        QCOMPARE(spot.size(), both.image.size());
        QCOMPARE(int(spot.constScanLine(2)[2]), 0); // beyond the bleed
        tints.push_back(spot.constScanLine(spot.height() / 2)[spot.width() / 2]);
    }
    QCOMPARE(tints, std::vector<int>({255, 127, 0})); // sRGB 188 is half the light
}

void ReverseTextureTest::reverseTexture_anyNumberOfThreads_giveTheSameBytes() {
    const TexturedMesh model = test::globe(radius, 60, 120, drawn(waves, {300, 200}));
    const DippedFilm film = test::viscousOnSphere(test::a4Grid(), radius, 1.8);
    const ReverseTexture many = reversed(model, film, uncompensated());
    const ThreadLimit oneThread(1);
    const ReverseTexture one = reversed(model, film, uncompensated());
    QVERIFY(one.image == many.image);
    QCOMPARE(one.seamTriangles, many.seamTriangles);
    QCOMPARE(one.shortfallArea, many.shortfallArea);
}

void ReverseTextureTest::reverseTexture_tinyImage_isPainted() {
    const TexturedMesh model = test::globe(radius, 60, 120, drawn(waves, {300, 200}));
    const DippedFilm film = test::viscousOnSphere(test::a4Grid(), radius, 1.8);
    const ReverseTexture texture = reversed(model, film, uncompensated({21, 30}));
    QCOMPARE(texture.image.size(), QSize(21, 30));
    QCOMPARE(texture.image.pixelColor(10, 15).alpha(), 255);
    QCOMPARE(texture.image.pixelColor(0, 0).alpha(), 0);
}

void ReverseTextureTest::reverseTexture_cancelled_throws() {
    Progress progress;
    progress.cancelToken.cancel();
    QVERIFY_EXCEPTION_THROWN(reversed(test::plainModel(boxMesh(boxSize), Qt::red),
                                      test::flatUnderBox(test::a4Grid(), boxSize), uncompensated(),
                                      progress),
                             Cancelled);
}

QTEST_MAIN(ReverseTextureTest)
#include "ReverseTextureTest.moc"
