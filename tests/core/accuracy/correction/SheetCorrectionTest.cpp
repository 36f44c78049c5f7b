// Tests that the error that repeats in the parts of a job is separated from scatter and corrected
// on the next sheet.
#include "accuracy/correction/SheetCorrection.h"

#include "base/Error.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <random>

using namespace dipwright;

namespace {

const Millimetres width(210), height(297);

// Returns the error of the tank, about 1 mm, which the simulation does not contain.
Eigen::Vector2d tank(const Eigen::Vector2d& at) {
    return {0.7 + 0.35 * std::sin(at.x() / 40) + 0.2 * std::cos(at.y() / 45),
            -0.4 + 0.3 * std::cos((at.x() - at.y()) / 60)};
}

// Returns 48 places on the uncorrected film, 16 mm apart.
std::vector<Eigen::Vector2d> places() {
    std::vector<Eigen::Vector2d> places;
    for (int row = 0; row < 8; ++row) {
        for (int column = 0; column < 6; ++column) {
            places.emplace_back(16 * (column - 2.5), 16 * (row - 3.5));
        }
    }
    return places;
}

// Dips a part with the sheet corrected by `built` and adds the measured places to `built`.
// `scatter` is the scatter of single places along each axis, `whole` the scatter of whole parts,
// both in mm.
void dip(AsBuilt& built, double scatter, double whole, std::mt19937& random) {
    std::normal_distribution<double> off(0, 1);
    const RepeatingError error(built, 1);
    built.parts.push_back({QStringLiteral("2026-11-22"), QStringLiteral("Ada"), {}, 0});
    const Eigen::Vector2d moved = whole * Eigen::Vector2d(off(random), off(random));
    for (const Eigen::Vector2d& place : places()) {
        const Eigen::Vector2d printed =
            isCorrected(built, 1) ? printedAt(place, error, built.strength) : place;
        const Eigen::Vector2d lies =
            tank(printed) + moved + scatter * Eigen::Vector2d(off(random), off(random));
        BuiltPlace seen;
        seen.part = int(built.parts.size());
        seen.sheet = {Millimetres(printed.x()), Millimetres(printed.y())};
        seen.model = {Millimetres(place.x()), Millimetres(0), Millimetres(place.y())};
        seen.off = {Millimetres(lies.x()), Millimetres(lies.y())};
        built.places.push_back(seen);
    }
}

// Returns the root mean square distance, in mm, between the place where film lands on the next
// part, without scatter, and the place where it should land. Measured halfway between the measured
// places.
double nextResidual(const AsBuilt& built) {
    const RepeatingError error(built, 1);
    double sum = 0;
    for (const Eigen::Vector2d& place : places()) {
        const Eigen::Vector2d between = 0.9 * (place + Eigen::Vector2d(8, 8));
        const Eigen::Vector2d printed =
            isCorrected(built, 1) ? printedAt(between, error, built.strength) : between;
        sum += (printed + tank(printed) - between).squaredNorm();
    }
    return std::sqrt(sum / double(places().size()));
}

// Returns a part whose sheet was measured in other directions: s was seen at axes * s.
AsBuilt measuredIn(const Eigen::Matrix2d& axes) {
    AsBuilt built;
    built.parts.resize(1);
    for (const Eigen::Vector2d& place : places()) {
        const Eigen::Vector2d off = axes * place + tank(place) - place;
        BuiltPlace seen;
        seen.sheet = {Millimetres(place.x()), Millimetres(place.y())};
        seen.model = {Millimetres(place.x()), Millimetres(0), Millimetres(place.y())};
        seen.off = {Millimetres(off.x()), Millimetres(off.y())};
        built.places.push_back(seen);
    }
    return built;
}

double fallen(int parts, double scatter, double whole, int seed) {
    std::mt19937 random{std::uint32_t(seed)};
    AsBuilt built;
    const double before = nextResidual(built);
    built.corrects = true;
    for (int part = 0; part < parts; ++part) {
        dip(built, scatter, whole, random);
    }
    return 1 - nextResidual(built) / before;
}

double worstFallen(int parts, double scatter, double whole) {
    double worst = 1;
    for (int seed = 1; seed <= 20; ++seed) {
        worst = std::min(worst, fallen(parts, scatter, whole, seed));
    }
    qInfo(
        "parts %d, scatter %.2f mm, scatter of parts %.2f mm: the error falls by at least %.1f %%",
        parts, scatter, whole, 100 * worst);
    return worst;
}

} // namespace

class SheetCorrectionTest : public QObject {
    Q_OBJECT

private slots:
    void repeatingError_oneMeasuredPart_fallsByMostOfIt() {
        QVERIFY(worstFallen(1, 0, 0) > 0.95);
        QVERIFY(worstFallen(1, 0.2, 0) > 0.70);
    }

    void repeatingError_threeMeasuredParts_fallsFurther() {
        QVERIFY(worstFallen(3, 0.2, 0) > 0.85);
        worstFallen(3, 0.2, 0.2);
        worstFallen(10, 0.2, 0);
    }

    void repeatingError_partsOnCorrectedSheets_staysCorrected() {
        QVERIFY(fallen(6, 0.05, 0, 3) > 0.9); // all parts but the first use a corrected sheet
    }

    void repeatingError_scatterOnly_isReportedAndNotCorrected() {
        std::mt19937 random{5};
        std::normal_distribution<double> off(0, 0.3);
        AsBuilt built;
        for (int part = 1; part <= 4; ++part) {
            for (const Eigen::Vector2d& place : places()) {
                BuiltPlace seen;
                seen.part = part;
                seen.sheet = {Millimetres(place.x()), Millimetres(place.y())};
                seen.model = {Millimetres(place.x()), Millimetres(0), Millimetres(place.y())};
                seen.off = {Millimetres(off(random)), Millimetres(off(random))};
                built.places.push_back(seen);
            }
        }
        const RepeatingError error(built, 1);
        QCOMPARE(error.parts(), 4);
        QVERIFY(std::abs(error.scatter() / 0.3 - 1) < 0.1);
        double most = 0, mean = 0;
        for (const RepeatedPlace& place : error.places()) {
            most = std::max(most, error.at(place.sheet).norm());
            mean = std::max(mean, place.mean.norm());
        }
        qInfo("largest mean error of a place %.3f mm, largest correction %.3f mm", mean, most);
        QVERIFY(most < 0.1 && mean > 0.3);
    }

    void repeatingError_farFromThePlaces_staysBounded() {
        std::mt19937 random{6};
        AsBuilt built;
        dip(built, 0.1, 0, random);
        const RepeatingError error(built, 1);
        QVERIFY(error.at({100, 140}).norm() < 2);
        QVERIFY(error.at({5000, 5000}).norm() < 2);
        QVERIFY(RepeatingError(built, 2).isNothing());
        built.corrects = true;
        QVERIFY(isCorrected(built, 1));
        QVERIFY(!isCorrected(built, 2));
        built.strength = 0;
        QVERIFY(!isCorrected(built, 1));
    }

    void requirePossibleErrors_ordinaryPart_isAccepted() {
        std::mt19937 random{8};
        AsBuilt built;
        dip(built, 0.3, 0.2, random);
        QVERIFY(DenseError(RepeatingError(built, 1), width, height).gradient() < 0.1);
        requirePossibleErrors(built, width, height, QStringLiteral("job"));
        requirePossibleErrors({}, width, height, QStringLiteral("job"));
    }

    void requirePossibleErrors_mirroredSwappedOrTurnedSheet_isRefused() {
        Eigen::Matrix2d mirrored, swapped;
        mirrored << 1, 0, 0, -1;
        swapped << 0, 1, 1, 0;
        for (const Eigen::Matrix2d& axes :
             {mirrored, swapped, Eigen::Matrix2d(-Eigen::Matrix2d::Identity())}) {
            AsBuilt built = measuredIn(axes);
            built.strength = 0.1; // an impossible error is not corrected in part either
            QVERIFY_EXCEPTION_THROWN(
                requirePossibleErrors(built, width, height, QStringLiteral("job")), Error);
        }
    }

    void unusualErrorNote_scaledTurnedOrShiftedPart_isTold() {
        std::mt19937 random{8};
        AsBuilt usual;
        dip(usual, 0.3, 0.2, random);
        QCOMPARE(unusualErrorNote(RepeatingError(usual, 1)), QString());
        const auto noteOf = [](const Eigen::Matrix2d& axes, double shift) {
            AsBuilt built = measuredIn(axes);
            for (BuiltPlace& place : built.places) {
                place.off[0] = place.off[0] + Millimetres(shift);
            }
            requirePossibleErrors(built, width, height, QStringLiteral("job"));
            return unusualErrorNote(RepeatingError(built, 1));
        };
        const Eigen::Matrix2d same = Eigen::Matrix2d::Identity();
        QCOMPARE(noteOf(1.03 * same, 0), QString());
        QVERIFY(noteOf(1.1 * same, 0).contains(QStringLiteral("change lengths by 1")));
        QVERIFY(!noteOf(Eigen::Rotation2Dd(0.15).toRotationMatrix(), 0).isEmpty());
        QVERIFY(noteOf(same, 12).contains(QStringLiteral("by up to 1")));
    }

    void correctedImage_knownError_movesAgainstIt() {
        AsBuilt built;
        for (int i = 0; i < 12; ++i) {
            BuiltPlace seen;
            seen.sheet = {Millimetres(20 * (i % 4) - 30), Millimetres(20 * (i / 4) - 20)};
            seen.model = {Millimetres(i), Millimetres(0), Millimetres(0)};
            seen.off = {Millimetres(3), Millimetres(-2)};
            built.places.push_back(seen);
        }
        const DenseError error(RepeatingError(built, 1), width, height);
        QImage film(420, 594, QImage::Format_RGBA8888); // two pixels a millimetre
        film.fill(Qt::transparent);
        film.setPixelColor(250, 300, QColor(200, 40, 10));
        const QImage moved = correctedImage(film, error, 1);
        QCOMPARE(moved.size(), film.size());
        QVERIFY(moved.pixelColor(244, 304).alpha() > 200);
        QCOMPARE(moved.pixelColor(250, 300).alpha(), 0);
        const QColor half = correctedImage(film, error, 0.5).pixelColor(247, 302);
        QVERIFY(half.alpha() > 200 && std::abs(half.red() - 200) < 3);
        QCOMPARE(correctedImage(film, error, 0), film);
        // Amounts of ink are moved, but never mixed.
        QImage inks(420, 594, QImage::Format_RGBA8888);
        for (int y = 0; y < inks.height(); ++y) {
            for (int x = 0; x < inks.width(); ++x) {
                inks.setPixelColor(x, y, (x / 3 + y / 2) % 2 ? QColor(200, 40, 10) : Qt::black);
            }
        }
        const QImage kept = correctedImage(inks, error, 0.77, Resampling::Nearest);
        QVERIFY(kept != inks);
        for (int y = 0; y < inks.height(); ++y) {
            for (int x = 0; x < inks.width(); ++x) {
                const QRgb pixel = kept.pixel(x, y);
                QVERIFY(pixel == qRgb(200, 40, 10) || pixel == qRgb(0, 0, 0) || pixel == 0);
            }
        }
    }

    // A displacement of parts of a pixel. Paler pixels at the edge would make a pale bleed.
    void correctedImage_edgeOfPaint_keepsFullInk() {
        AsBuilt built = measuredIn(Eigen::Matrix2d::Identity());
        for (BuiltPlace& place : built.places) {
            place.off = {Millimetres(0.63), Millimetres(-0.37)};
        }
        const DenseError error(RepeatingError(built, 1), width, height);
        QImage film(420, 594, QImage::Format_RGBA8888), white(film.size(), QImage::Format_Alpha8);
        film.fill(Qt::transparent);
        white.fill(0);
        for (int y = 200; y < 400; ++y) {
            for (int x = 150 + y % 7; x < 260; ++x) {
                film.setPixelColor(x, y, QColor(200, 40, 10));
                white.scanLine(y)[x] = 180;
            }
        }
        white.reinterpretAsFormat(QImage::Format_Grayscale8);
        const QImage moved = correctedImage(film, error, 1);
        const QImage tints = correctedTints(white, error, 1);
        QCOMPARE(tints.format(), QImage::Format_Grayscale8);
        QVERIFY(moved != film);
        for (int y = 0; y < film.height(); ++y) {
            for (int x = 0; x < film.width(); ++x) {
                const QRgb pixel = moved.pixel(x, y);
                QVERIFY(pixel == qRgb(200, 40, 10) || pixel == 0);
                QCOMPARE(int(tints.constScanLine(y)[x]), pixel == 0 ? 0 : 180);
            }
        }
    }

    void correctionPicture_isDrawnAtTheWantedSize() {
        std::mt19937 random{7};
        AsBuilt built;
        dip(built, 0.1, 0, random);
        const QImage picture = correctionPicture(RepeatingError(built, 1), width, height, 1, 900);
        QCOMPARE(picture.height(), 900);
        if (qEnvironmentVariableIsSet("DIPWRIGHT_PICTURES")) {
            picture.save(qEnvironmentVariable("DIPWRIGHT_PICTURES") +
                         QStringLiteral("/correction.png"));
        }
    }
};

QTEST_MAIN(SheetCorrectionTest)
#include "SheetCorrectionTest.moc"
