// Tests findPrint() with simulated photos of a body, in which the true corners are known.
#include "inspection/FindPrint.h"
#include "PartPhoto.h"
#include "TestFolders.h"
#include "WholeSample.h"
#include "artwork/EditArtwork.h"
#include "base/Error.h"
#include "base/Units.h"
#include "geometry/Shapes.h"
#include "pipeline/Pipeline.h"
#include "texture/Chessboard.h"

#include <QGuiApplication>
#include <QStandardPaths>
#include <QtTest>
#include <random>

using namespace dipwright;
using namespace dipwright::test;

namespace {

constexpr double radius = 35; // mm
const Eigen::Vector3d lookedFrom(60, -160, 90);

// The squares on the ball measure 20 degrees of longitude and of latitude about the Y axis.
constexpr double squareAngle = 20 * pi / 180;

double paintedBall(const Eigen::Vector3d& place) {
    const double around = std::atan2(place.z(), place.x()) / squareAngle;
    const double up = std::asin(std::clamp(place.normalized().y(), -1.0, 1.0)) / squareAngle;
    return (int(std::floor(around)) + int(std::floor(up))) % 2 == 0 ? 0.05 : 0.85;
}

Eigen::Vector3d onBall(double around, double up) {
    return radius * Eigen::Vector3d(std::cos(around) * std::cos(up), std::sin(up),
                                    std::sin(around) * std::cos(up));
}

std::vector<PrintedCorner> ballCorners() {
    std::vector<PrintedCorner> corners;
    for (int row = -3; row <= 3; ++row) {
        for (int column = -9; column < 9; ++column) {
            const double around = column * squareAngle, up = row * squareAngle;
            PrintedCorner corner;
            corner.model = onBall(around, up);
            corner.outward = corner.model.normalized();
            corner.right =
                (onBall(around + 0.01, up) - onBall(around - 0.01, up)) / 0.02 * squareAngle;
            corner.down =
                (onBall(around, up + 0.01) - onBall(around, up - 0.01)) / 0.02 * squareAngle;
            corner.sheet = {column, row};
            corner.isDark = (column + row) % 2 == 0;
            corners.push_back(corner);
        }
    }
    return corners;
}

PhotoCamera camera() {
    PhotoCamera camera = cameraFrom(lookedFrom, {2, 3, -1}, {0.2, 0.1, 1});
    camera.focalLength = 2.6;
    camera.k1 = -0.08;
    camera.k2 = 0.03;
    return camera;
}

// Returns `count` visible corners as a user clicks them, with an error of `off` pixels.
std::vector<PlacePair> clicked(const std::vector<PrintedCorner>& corners, const PhotoCamera& camera,
                               int photo, int count, double off, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, off);
    std::vector<PrintedCorner> seen;
    for (const PrintedCorner& corner : corners) {
        if ((camera.eye() - corner.model).normalized().dot(corner.outward) > 0.4) {
            seen.push_back(corner);
        }
    }
    std::shuffle(seen.begin(), seen.end(), random);
    std::vector<PlacePair> pairs;
    for (int i = 0; i < std::min(count, int(seen.size())); ++i) {
        const Eigen::Vector3d& place = seen[std::size_t(i)].model;
        pairs.push_back(
            {photo, camera.seen(place) + Eigen::Vector2d(noise(random), noise(random)), place});
    }
    return pairs;
}

const TriangleMesh& ball() {
    static const TriangleMesh mesh = sphereMesh(radius, 300, 600);
    return mesh;
}

QImage ballPhoto(const PhotoCamera& camera, const PhotoLight& light) {
    return partPhoto(
        ball(),
        [](const SurfacePoint& point) {
            return paintedBall(position(ball(), point).cast<double>());
        },
        camera, light);
}

FoundPrint foundOn(const QImage& photo, const std::vector<PlacePair>& pairs,
                   const FindPrintSettings& settings = {}) {
    return findPrint({photo}, ball(), ballCorners(), pairs, settings, {},
                     QStringLiteral("pairs.csv"));
}

Project ballJob() {
    Project project;
    auto model = std::make_shared<TexturedMesh>();
    model->mesh = sphereMesh(radius, 90, 180);
    model->textureCoordinates.resize(model->mesh.triangles.size());
    for (auto& coordinates : model->textureCoordinates) {
        coordinates.fill(Eigen::Vector2f::Constant(NAN));
    }
    model->material.resize(model->mesh.triangles.size(), 0);
    model->materials.resize(1);
    model->chart = findCharts(*model);
    project.model = model;
    project.film.width = project.film.height = Millimetres(180);
    project.film.columns = project.film.rows = 91;
    project.fieldResolution = 96;
    project.sheet.resolution = DotsPerInch(72);
    return project;
}

// Returns a photo of the ball with its print turned about Y by a number of squares.
QImage turnedBall(double squares) {
    return partPhoto(ball(),
                     [&](const SurfacePoint& point) {
                         const Eigen::Vector3d place = position(ball(), point).cast<double>();
                         return paintedBall(
                             Eigen::AngleAxisd(squares * squareAngle, Eigen::Vector3d::UnitY()) *
                             place);
                     },
                     camera(), {});
}

QString errorOf(const QImage& photo, const std::vector<PlacePair>& pairs) {
    try {
        foundOn(photo, pairs);
    } catch (const Error& error) {
        return error.message();
    }
    return {};
}

} // namespace

class FindPrintTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

    void findPrint_corners_areWithinHundredthsOfAPixel_data() {
        QTest::addColumn<double>("blur");
        QTest::addColumn<double>("noise");
        QTest::addColumn<bool>("glare");
        QTest::addColumn<int>("jpeg");
        QTest::newRow("noise of two levels") << 0.8 << 2.0 << false << 85;
        QTest::newRow("glare") << 0.8 << 1.0 << true << 85;
        if (isWholeRun()) {
            QTest::newRow("sharp") << 0.6 << 0.0 << false << 0;
            QTest::newRow("noise of one level") << 0.8 << 1.0 << false << 85;
            QTest::newRow("out of focus") << 2.5 << 1.0 << false << 85;
        }
    }

    void findPrint_corners_areWithinHundredthsOfAPixel() {
        QFETCH(double, blur);
        QFETCH(double, noise);
        QFETCH(bool, glare);
        QFETCH(int, jpeg);
        const QImage photo = ballPhoto(
            camera(), {.blur = blur, .noise = noise, .glare = glare, .jpegQuality = jpeg});
        const FoundPrint print = foundOn(photo, clicked(ballCorners(), camera(), 0, 8, 1.5, 3));
        Eigen::Vector2d mean = Eigen::Vector2d::Zero();
        double square = 0, farthest = 0;
        const double count = double(print.places.size());
        for (const PrintedPlace& place : print.places) {
            const Eigen::Vector2d off = place.pixel - camera().seen(place.model);
            mean += off / count;
            square += off.squaredNorm() / count;
            farthest = std::max(farthest, off.norm());
        }
        qInfo("%d of %d corners; error mean %.4f, %.4f, rms %.4f, at most %.3f px; the fitted "
              "camera leaves R = %.4f px",
              int(count), print.expected[0], mean.x(), mean.y(), std::sqrt(square), farthest,
              print.view.figures.meanPixels);
        QVERIFY(count > 0.7 * print.expected[0]);
        QVERIFY(mean.norm() < 0.05);
        QVERIFY(std::sqrt(square) < 0.15);
        QVERIFY(farthest < 1);
    }

    void findPrint_shiftedPrint_figuresGiveTheShift() {
        // The print is turned by 0.5° about Y from its place. The camera is known from the body
        // itself.
        const double off = 0.5 * pi / 180;
        const QImage photo = partPhoto(
            ball(),
            [&](const SurfacePoint& point) {
                const Eigen::Vector3d place = position(ball(), point).cast<double>();
                return paintedBall(Eigen::AngleAxisd(off, Eigen::Vector3d::UnitY()) * place);
            },
            camera(), {});
        const FoundPrint print = foundOn(photo, clicked(ballCorners(), camera(), 0, 40, 0, 3),
                                         {.keepsCamera = true, .lens = {}});
        // A place moves along its circle of latitude.
        double expected = 0;
        for (const PrintedPlace& place : print.places) {
            expected += off * std::hypot(place.model.x(), place.model.z());
        }
        double mean = 0;
        for (const PairDistance& one : print.view.off) {
            mean += one.millimetres;
        }
        qInfo("R %.3f ± %.3f px; mean across the line of sight %.3f mm of %.3f",
              print.view.figures.meanPixels, print.view.figures.deviationPixels,
              mean / double(print.places.size()), expected / double(print.places.size()));
        QVERIFY(mean < expected && mean > 0.6 * expected); // less in a slanted view
        // A camera that is fitted to the print absorbs the turn.
        const FoundPrint followed = foundOn(photo, clicked(ballCorners(), camera(), 0, 40, 0, 3));
        QVERIFY(followed.view.figures.meanPixels < 0.2 * print.view.figures.meanPixels);
    }

    // The squares are about 150 pixels wide and bent. The best match of four flat squares therefore
    // lies some pixels away from the corner.
    void findPrint_cornersFarFromTheirPlaces_areFoundExactly() {
        const Eigen::AngleAxisd off(4 * pi / 180, Eigen::Vector3d(1, 1, 0).normalized());
        const QImage photo =
            partPhoto(ball(),
                      [&](const SurfacePoint& point) {
                          return paintedBall(off * position(ball(), point).cast<double>());
                      },
                      camera(), {});
        const FoundPrint print = foundOn(photo, clicked(ballCorners(), camera(), 0, 40, 0, 3),
                                         {.keepsCamera = true, .lens = {}});
        QVERIFY(double(print.places.size()) > 0.7 * print.expected[0]);
        for (const PrintedPlace& place : print.places) {
            const Eigen::Vector2d away = place.pixel - camera().seen(off.inverse() * place.model);
            QVERIFY2(
                away.norm() < 0.5,
                qPrintable(QStringLiteral("the corner is %1 px from its place, expected < 0.5 px")
                               .arg(away.norm())));
        }
    }

    // In an inverted photo, most corners of a shifted print are found at the places of their
    // neighbours.
    void findPrint_invertedPhotoOfShiftedPrint_isRefused() {
        QImage photo = turnedBall(0.25);
        photo.invertPixels();
        const QString error = errorOf(photo, clicked(ballCorners(), camera(), 0, 40, 0, 3));
        QVERIFY2(error.contains(QStringLiteral("swapped")), qPrintable(error));
    }

    void findPrint_printOffByNearlyHalfASquare_isTold() {
        for (const auto& [squares, isTold] : {std::pair(0.25, false), std::pair(0.45, true)}) {
            const FoundPrint print =
                foundOn(turnedBall(squares), clicked(ballCorners(), camera(), 0, 40, 0, 3));
            QVERIFY2(print.doubt.contains(QStringLiteral("diagonal")) == isTold,
                     qPrintable(print.doubt));
        }
    }

    void findPrint_severalPhotos_areFittedTogether() {
        PhotoCamera other = cameraFrom({150, -90, 20}, {0, 0, 0}, {0, 0.2, 1});
        other.focalLength = 2.6;
        other.k1 = -0.08;
        other.k2 = 0.03;
        std::vector<PlacePair> pairs = clicked(ballCorners(), camera(), 0, 8, 1.5, 3);
        for (const PlacePair& pair : clicked(ballCorners(), other, 1, 8, 1.5, 4)) {
            pairs.push_back(pair);
        }
        const FoundPrint print = findPrint({ballPhoto(camera(), {}), ballPhoto(other, {})}, ball(),
                                           ballCorners(), pairs, {}, {}, QStringLiteral("pairs"));
        QCOMPARE(int(print.expected.size()), 2);
        QCOMPARE(print.view.figures.count, int(print.places.size()));
        QVERIFY(print.places.front().photo == 0 && print.places.back().photo == 1);
        QVERIFY(std::abs(print.view.focalLength.value - 2.6) < 2 * print.view.focalLength.off);
        QVERIFY(print.view.figures.meanPixels < 0.1);
    }

    void findPrint_photoWithoutThePrint_isRefused() {
        const auto pairs = clicked(ballCorners(), camera(), 0, 10, 1, 5);
        const QImage good = ballPhoto(camera(), {});
        QCOMPARE(errorOf(good, pairs), QString());
        QImage bare(good.size(), QImage::Format_RGB32);
        bare.fill(Qt::gray);
        QVERIFY(errorOf(bare, pairs).contains(QStringLiteral("were found")));
        // The photo shows the same part with another job's print.
        const QImage other =
            partPhoto(ball(),
                      [](const SurfacePoint& point) {
                          const Eigen::Vector3d place = position(ball(), point).cast<double>();
                          return paintedBall(
                              Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()) * place);
                      },
                      camera(), {});
        QVERIFY2(errorOf(other, pairs).contains(QStringLiteral("were found")),
                 qPrintable(errorOf(other, pairs)));
        // The photo shows the print with dark and light swapped.
        const QImage swapped =
            partPhoto(ball(),
                      [](const SurfacePoint& point) {
                          return 0.9 - paintedBall(position(ball(), point).cast<double>());
                      },
                      camera(), {});
        QVERIFY(errorOf(swapped, pairs).contains(QStringLiteral("swapped")));
        // The photo is mirrored, and its places were clicked in the mirrored photo.
        std::vector<PlacePair> flipped = pairs;
        for (PlacePair& pair : flipped) {
            pair.pixel.x() = good.width() - pair.pixel.x();
        }
        QVERIFY(errorOf(good.mirrored(true, false), flipped).contains(QStringLiteral("mirror")));
        // Half of the photo is covered: only the visible corners are found.
        QImage half = good;
        for (int y = 0; y < half.height(); ++y) {
            for (int x = half.width() / 2; x < half.width(); ++x) {
                half.setPixelColor(x, y, QColor(120, 120, 120));
            }
        }
        const FoundPrint print = foundOn(half, pairs);
        QVERIFY(double(print.places.size()) < 0.65 * print.expected[0]);
    }

    void findPrint_dippedChessboard_isFoundOnTheBody();

    // The chessboard is a decal on the body's lowest point.
    void printedCorners_chessSquaresOfArtwork_areFound() {
        constexpr int across = 8, down = 6, pixels = 20;
        constexpr double square = 5; // mm
        QImage board(across * pixels, down * pixels, QImage::Format_RGBA8888);
        for (int y = 0; y < board.height(); ++y) {
            for (int x = 0; x < board.width(); ++x) {
                board.setPixelColor(x, y,
                                    (x / pixels + y / pixels) % 2 == 0 ? Qt::black : Qt::white);
            }
        }
        Project project = ballJob();
        ArtworkLayer layer = newLayer(LayerKind::Picture, QStringLiteral("Board"));
        layer.picture = artworkPicture(board);
        layer.place = {Millimetres(0), Millimetres(-radius), Millimetres(0)};
        layer.size = {Millimetres(across * square), Millimetres(down * square)};
        project.artwork.base = Qt::white;
        project.artwork.layers = {layer};
        const SolverRegistry registry(QStringList{pluginFolder()});
        JobOptions options;
        options.estimatesNumericalError = false;
        const JobResult job = runJob(project, registry, options, nullptr, {});
        const auto corners = printedCorners(project, {job.immersions[0].laid}, PartPrint::Texture);
        QCOMPARE(int(corners.size()), (across - 1) * (down - 1));
        for (const PrintedCorner& corner : corners) {
            QVERIFY(std::abs(corner.model.norm() - radius) < 0.1);
            double nearest = radius;
            for (const PrintedCorner& other : corners) {
                if (&other != &corner) {
                    nearest = std::min(nearest, (other.model - corner.model).norm());
                }
            }
            // The decal keeps lengths along the bent surface.
            QVERIFY2(std::abs(nearest - square) < 0.05 * square,
                     qPrintable(QStringLiteral("corners are %1 mm apart, expected %2 mm")
                                    .arg(nearest)
                                    .arg(square)));
        }
    }
};

// A ball is dipped through the chessboard. In the tank the film swells by 1.5 % more than in the
// job, and the ball is displaced by 0.8 mm.
void FindPrintTest::findPrint_dippedChessboard_isFoundOnTheBody() {
    const Project project = ballJob();
    Project inTank = project;
    inTank.film.swellX = inTank.film.swellY = 1.015;
    inTank.immersions[0].offset = {Millimetres(0.8), Millimetres(0)};
    const SolverRegistry registry(QStringList{pluginFolder()});
    JobOptions options;
    options.chessboard = true;
    options.estimatesNumericalError = false;
    const JobResult meant = runJob(project, registry, options, nullptr, {});
    const JobResult made = runJob(inTank, registry, options, nullptr, {});
    const QSizeF sheet(180, 180);
    const auto corners = chessboardCorners(*meant.immersions[0].laid, 0, sheet, chessSquare);
    const auto truth = chessboardCorners(*made.immersions[0].laid, 0, sheet, chessSquare);
    QVERIFY(corners.size() >= 21);
    // The photo takes each place's colour from the film of the tank.
    const Print print = chessboardPrint(*made.immersions[0].laid, sheet, chessSquare);
    PhotoCamera camera = cameraFrom({50, -190, 60}, {0, -5, 0}, {0, 0, 1});
    camera.k1 = -0.05;
    const QImage photo = partPhoto(project.model->mesh, print, camera, {});
    if (qEnvironmentVariableIsSet("DIPWRIGHT_PICTURES")) {
        photo.save(qEnvironmentVariable("DIPWRIGHT_PICTURES") + "/dipped-ball.png");
    }
    const FoundPrint found =
        findPrint({photo}, project.model->mesh, corners, clicked(corners, camera, 0, 40, 0, 7),
                  {.keepsCamera = true, .lens = {}}, {}, QStringLiteral("x"));
    double worst = 0, meanOff = 0, mean = 0;
    for (std::size_t i = 0; i < found.places.size(); ++i) {
        const PrintedPlace& place = found.places[i];
        for (const PrintedCorner& corner : truth) {
            if (corner.sheet == place.sheet) {
                const double away = (place.pixel - camera.seen(corner.model)).norm();
                worst = std::max(worst, away);
                meanOff += away / double(found.places.size());
            }
        }
        mean += (camera.seen(place.model) - place.pixel).norm() / double(found.places.size());
    }
    qInfo("%zu of %d corners; from where the film really took them: mean %.3f px, %.3f at  "
          "most; R %.3f ± %.3f px of %.3f, %.2f mm at most",
          found.places.size(), found.expected[0], meanOff, worst, found.view.figures.meanPixels,
          found.view.figures.deviationPixels, mean, found.view.figures.worst);
    QVERIFY(double(found.places.size()) > 0.7 * found.expected[0]);
    QVERIFY(meanOff < 0.5);
    QVERIFY(std::abs(found.view.figures.meanPixels - mean) < 0.5);
    QVERIFY(mean > 2);
}

QTEST_MAIN(FindPrintTest)
#include "FindPrintTest.moc"
