// Tests fitPartCamera() with places on a part whose exact positions in the photo are known.
#include "inspection/PartCamera.h"
#include "base/Error.h"
#include "base/Units.h"
#include "inspection/PartViewFiles.h"

#include <Eigen/Geometry>

#include <QtTest>
#include <random>

using namespace dipwright;

namespace {

const QSize picture(1344, 1344); // as in the paper

// The true camera: a pinhole camera with distortion that looks at the origin, independent of the
// tested code.
struct Truth {
    double focalLength = 2.2; // half diagonals
    double k1 = -0.08;
    double distance = 300; // mm
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();

    Eigen::Vector2d seen(const Eigen::Vector3d& place) const {
        const Eigen::Vector3d from = turn * place + Eigen::Vector3d(4, -3, distance);
        const double x = focalLength * from.x() / from.z(), y = focalLength * from.y() / from.z();
        const double more = 1 + k1 * (x * x + y * y);
        const double half = std::hypot(picture.width(), picture.height()) / 2;
        return {picture.width() / 2.0 + half * x * more, picture.height() / 2.0 + half * y * more};
    }
};

Truth truth(double degreesX, double degreesY) {
    Truth truth;
    truth.turn = (Eigen::AngleAxisd(degreesX * pi / 180, Eigen::Vector3d::UnitX()) *
                  Eigen::AngleAxisd(degreesY * pi / 180, Eigen::Vector3d::UnitY()))
                     .toRotationMatrix();
    return truth;
}

// Returns visible places on a ball of 70 mm and their pixels, with `noise` pixels of error.
std::vector<PlacePair> onBall(const Truth& truth, int photo, int count, double noise,
                              std::mt19937& random) {
    std::normal_distribution<double> off(0, noise), any(0, 1);
    std::vector<PlacePair> pairs;
    while (int(pairs.size()) < count) {
        const Eigen::Vector3d place =
            35 * Eigen::Vector3d(any(random), any(random), any(random)).normalized();
        if ((truth.turn * place).z() < -5) {
            pairs.push_back(
                {photo, truth.seen(place) + Eigen::Vector2d(off(random), off(random)), place});
        }
    }
    return pairs;
}

QString errorOf(const std::vector<PlacePair>& pairs) {
    try {
        fitPartCamera(pairs, 1, picture, QStringLiteral("pairs.csv"));
    } catch (const Error& error) {
        return error.message();
    }
    return {};
}

QString readingError(const QByteArray& table) {
    try {
        readPairs(table, 2, QStringLiteral("pairs.csv"));
    } catch (const Error& error) {
        return error.message();
    }
    return {};
}

} // namespace

class PartCameraTest : public QObject {
    Q_OBJECT

private slots:
    void fitPartCamera_perfectPairs_findsTheCamera() {
        std::mt19937 random(1);
        for (int degrees = 0; degrees < 360; degrees += 40) {
            const Truth camera = truth(degrees, 25);
            const PartView view =
                fitPartCamera(onBall(camera, 0, 40, 0, random), 1, picture, QStringLiteral("x"));
            QVERIFY(std::abs(view.focalLength.value / camera.focalLength - 1) < 1e-4);
            QVERIFY(std::abs(view.lens.k1 - camera.k1) < 1e-3);
            QVERIFY(view.figures.meanPixels < 1e-4);
            const Eigen::Vector3d place(10, 20, -5);
            QVERIFY((seenAt(view, 0, picture, place) - camera.seen(place)).norm() < 1e-2);
        }
    }

    // 16 places on a ball, as in the paper's Table II, each clicked with 1 px of error.
    void fitPartCamera_noisyPairs_figuresMatchTheScatter() {
        std::mt19937 random(2);
        double mean = 0;
        constexpr int parts = 50;
        for (int i = 0; i < parts; ++i) {
            Truth camera = truth(20, i);
            camera.k1 = 0;
            camera.distance = 200;
            const PartView view =
                fitPartCamera(onBall(camera, 0, 16, 1, random), 1, picture, QStringLiteral("x"));
            QCOMPARE(view.figures.count, 16);
            mean += view.figures.meanPixels / parts;
            QVERIFY(view.figures.worst >= view.figures.percentile95 - 1e-12);
        }
        // The mean distance of Gaussian errors is √(π/2). The fit used 7 of 32 degrees of freedom.
        const double expected = std::sqrt(pi / 2 * 25 / 32);
        qInfo("mean %.3f px of %.3f expected", mean, expected);
        QVERIFY(std::abs(mean / expected - 1) < 0.05);
    }

    // With unweighted least squares, as in OpenCV's calib3d, this outlier moves the result by 3.8
    // px.
    void fitPartCamera_oneOutlier_doesNotMoveTheCamera() {
        std::mt19937 random(6);
        double mean = 0;
        constexpr int parts = 20;
        for (int i = 0; i < parts; ++i) {
            Truth camera = truth(20, i);
            camera.k1 = 0;
            camera.distance = 200;
            std::vector<PlacePair> pairs = onBall(camera, 0, 16, 0.5, random);
            pairs[3].pixel.x() += 30;
            const PartView view = fitPartCamera(pairs, 1, picture, QStringLiteral("x"));
            for (const PlacePair& pair : onBall(camera, 0, 20, 0, random)) {
                mean += (seenAt(view, 0, picture, pair.model) - pair.pixel).norm() / 20 / parts;
            }
        }
        qInfo("mean error of the places %.2f px", mean);
        QVERIFY(mean < 0.75);
    }

    void fitPartCamera_severalPhotos_shareOneLens() {
        std::mt19937 random(3);
        const Truth first = truth(10, 0), second = truth(15, 120);
        std::vector<PlacePair> pairs = onBall(first, 0, 16, 0.5, random);
        for (const PlacePair& pair : onBall(second, 1, 16, 0.5, random)) {
            pairs.push_back(pair);
        }
        const PartView view = fitPartCamera(pairs, 2, picture, QStringLiteral("x"));
        QCOMPARE(int(view.photos.size()), 2);
        QCOMPARE(view.figures.count, 32);
        QVERIFY(std::abs(view.focalLength.value - 2.2) < view.focalLength.off * 2);
        const Eigen::Vector3d place(5, 5, 20);
        QVERIFY((seenAt(view, 1, picture, place) - second.seen(place)).norm() < 2);
    }

    void fitPartCamera_95PercentInterval_holdsTheFocalLengthIn95Percent() {
        std::mt19937 random(4);
        int held = 0;
        constexpr int parts = 200;
        for (int i = 0; i < parts; ++i) {
            const PartView view = fitPartCamera(onBall(truth(i, 2 * i), 0, 40, 0.5, random), 1,
                                                picture, QStringLiteral("x"));
            held += std::abs(view.focalLength.value - 2.2) <= view.focalLength.off;
        }
        qInfo("95 %% interval of the focal length: contains the true value in %.1f %%",
              100.0 * held / parts);
        QVERIFY(held >= 0.91 * parts && held <= 0.99 * parts);
    }

    void fitPartCamera_ambiguousPairs_areRefused() {
        std::mt19937 random(5);
        const std::vector<PlacePair> good = onBall(truth(10, 10), 0, 16, 0.5, random);
        QCOMPARE(errorOf(good), QString());
        QVERIFY(errorOf({good.begin(), good.begin() + 5}).contains(QStringLiteral("needs 6")));
        std::vector<PlacePair> flat = good;
        for (PlacePair& pair : flat) {
            pair.model.z() = 0;
            pair.pixel = truth(10, 10).seen(pair.model);
        }
        QVERIFY(errorOf(flat).contains(QStringLiteral("one plane")));
        std::vector<PlacePair> mirrored = good;
        for (PlacePair& pair : mirrored) {
            pair.pixel.x() = picture.width() - pair.pixel.x();
        }
        QVERIFY(errorOf(mirrored).contains(QStringLiteral("mirror")));
        std::vector<PlacePair> same(10, good.front());
        QVERIFY(!errorOf(same).isEmpty());
        // At this distance, a turn of the camera and a shift look the same.
        Truth far = truth(10, 10);
        far.distance = 100'000;
        far.focalLength = 700;
        QVERIFY(!errorOf(onBall(far, 0, 16, 1, random)).isEmpty());
    }

    void readPairs_table_isReadOrRefusedByLine() {
        const QByteArray head = "photo,x_px,y_px,x_mm,y_mm,z_mm\n";
        const auto pairs = readPairs(head + "1,10.5,20,1,2,3\r\n\n2,1,2,-3,4e1,5\n", 2,
                                     QStringLiteral("pairs.csv"));
        QCOMPARE(int(pairs.size()), 2);
        QCOMPARE(pairs[1].photo, 1);
        QCOMPARE(pairs[1].model.y(), 40);
        for (const char* line : {"1,2,3,4,5", "0,1,2,3,4,5", "3,1,2,3,4,5", "1,nan,2,3,4,5",
                                 "1,1e30,2,3,4,5", "1.5,1,2,3,4,5", "a,b,c,d,e,f"}) {
            QVERIFY2(readingError(head + line).contains(QStringLiteral("Line 2")), line);
        }
        QVERIFY(readingError("\xef\xbb\xbf" + head + "1,2,3,4,5,6\n").isEmpty());
        QVERIFY(!readingError("x,y\n").isEmpty());
        QVERIFY(!readingError({}).isEmpty());
    }

    void requireInPhotos_placeOutside_isRefusedByLine() {
        const QByteArray table =
            "photo,x_px,y_px,x_mm,y_mm,z_mm\n1,0,600,1,2,3\n\n1,800.5,2,3,4,5\n";
        const auto pairs = readPairs(table, 1, QStringLiteral("pairs.csv"));
        requireInPhotos(pairs, {801, 600}, QStringLiteral("pairs.csv"));
        try {
            requireInPhotos(pairs, {800, 600}, QStringLiteral("pairs.csv"));
            QFAIL("the place was accepted, expected a refusal");
        } catch (const Error& error) {
            QVERIFY(error.message().contains(QStringLiteral("Line 4")));
        }
    }
};

QTEST_APPLESS_MAIN(PartCameraTest)
#include "PartCameraTest.moc"
