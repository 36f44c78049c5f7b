// Tests builtPlaces(): where the film lies on a dipped part, in coordinates of the sheet.
#include "inspection/BuiltPlaces.h"
#include "PhotographedPart.h"
#include "TestFolders.h"
#include "accuracy/correction/SheetCorrection.h"
#include "base/Error.h"
#include "solver/SolverRegistry.h"

#include <QStandardPaths>
#include <QtTest>
#include <cmath>

using namespace dipwright;

namespace {

const solver::SolverModule& solverModule() {
    static const SolverRegistry plugins{QStringList{pluginFolder()}};
    return plugins.module(QStringLiteral("pbd-cpu"));
}

} // namespace

class BuiltPlacesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

    // On a body shifted by 1.1 and −0.7 mm, the film lies everywhere as if the film were shifted by
    // −1.1 and 0.7 mm.
    void builtPlaces_shiftedBody_haveTheOppositeShiftOnTheSheet() {
        const Project believed = test::eggToFit(1, 2.4);
        const test::Hidden aside{1.03, 1.03, std::numeric_limits<double>::infinity(), 1.1, -0.7, 0};
        const test::PhotographedPart part(believed, aside, 2.4, solverModule());
        const auto cameras = test::camerasAround({{20, -35}, {140, -30}}, 280, 3.4, 4000);
        const FitPairs pairs = part.pairs(cameras, 24, 20, 0.3, 1);
        const PartView view = fitPartCamera(pairs.body, pairs.photos, pairs.picture, pairs.where);
        const auto places =
            builtPlaces(pairs.printed, view, pairs.picture, {part.believedFilm()},
                        {believed.film.width.value(), believed.film.height.value()}, 1);
        QVERIFY(places.size() > 20);
        for (const BuiltPlace& place : places) {
            const Eigen::Vector2d off(place.off[0].value() + 1.1 / 1.03,
                                      place.off[1].value() - 0.7 / 1.03);
            QVERIFY2(off.norm() < 0.15,
                     qPrintable(
                         QStringLiteral("(%1, %2) mm on the sheet: error %3 mm, expected < 0.15 mm")
                             .arg(place.sheet[0].value())
                             .arg(place.sheet[1].value())
                             .arg(off.norm())));
        }
        qInfo("%zu places, %.3f mm off on the sheet", places.size(), residualOf(places));

        // The next sheet is printed with a shift, so that the print lands in its place.
        AsBuilt built;
        built.parts.resize(1);
        built.places = places;
        built.corrects = true;
        const auto moved = onPrintedSheet(pairs.printed, built);
        for (std::size_t i = 0; i < moved.size(); ++i) {
            const Eigen::Vector2d by = moved[i].sheet - pairs.printed[i].sheet;
            QVERIFY((by - Eigen::Vector2d(1.1, -0.7) / 1.03).norm() < 0.1);
        }
        built.corrects = false;
        QCOMPARE(onPrintedSheet(pairs.printed, built).front().sheet, pairs.printed.front().sheet);
    }

    void requireOnTargets_wrongCoordinatesOfTheSheet_areNamed_data() {
        QTest::addColumn<double>("xx");
        QTest::addColumn<double>("xy");
        QTest::addColumn<double>("yx");
        QTest::addColumn<double>("yy");
        QTest::addColumn<bool>("fromCorner");
        QTest::addColumn<QString>("advice");
        QTest::newRow("correct") << 1.0 << 0.0 << 0.0 << 1.0 << false << QString();
        QTest::newRow("y upwards") << 1.0 << 0.0 << 0.0 << -1.0 << false << "sheet_y_mm has";
        QTest::newRow("x leftwards") << -1.0 << 0.0 << 0.0 << 1.0 << false << "sheet_x_mm has";
        QTest::newRow("swapped") << 0.0 << 1.0 << 1.0 << 0.0 << false << "are swapped";
        QTest::newRow("from the corner") << 1.0 << 0.0 << 0.0 << 1.0 << true << "top left corner";
    }

    void requireOnTargets_wrongCoordinatesOfTheSheet_areNamed() {
        QFETCH(double, xx);
        QFETCH(double, xy);
        QFETCH(double, yx);
        QFETCH(double, yy);
        QFETCH(bool, fromCorner);
        QFETCH(QString, advice);
        Eigen::Matrix2d axes;
        axes << xx, xy, yx, yy;
        static const Project believed = test::eggToFit(1, 2.4);
        static const test::PhotographedPart part(believed, {1.03, 1.03, 4, 1.1, -0.7, 0}, 2.4,
                                                 solverModule());
        const QSizeF sheet(believed.film.width.value(), believed.film.height.value());
        std::vector<PrintedPlace> places =
            part.pairs(test::camerasAround({{20, -35}}, 280, 3.4, 1000), 24, 20, 0.3, 1).printed;
        for (PrintedPlace& place : places) {
            place.sheet = axes * place.sheet;
            if (fromCorner) {
                place.sheet += Eigen::Vector2d(sheet.width(), sheet.height()) / 2;
            }
        }
        QString refusal;
        try {
            requireOnTargets(places, {part.believedFilm()}, sheet, QStringLiteral("places.csv"));
        } catch (const Error& error) {
            refusal = error.message();
        }
        QCOMPARE(refusal.isEmpty(), advice.isEmpty());
        QVERIFY2(refusal.contains(advice), qPrintable(refusal));
    }

    // Another solver stands for the tank. It has hidden errors of film and body, which move the
    // print by 1 mm and more on the body. The correction is measured on one part without scatter
    // and on three parts with 0.2 mm of scatter. The test limits the error that remains on the next
    // part.
    void onPrintedSheet_tankOfAnotherSolver_correctsTheNextPart() {
        const test::Hidden hidden{1.05, 1.02, 6, 0.9, -0.6, 2};
        const test::PhotographedPart part(test::eggToFit(1, 2.4), hidden, 2, solverModule(),
                                          test::referenceTank());
        QVERIFY(fallen(part, 1, 0) > 0.70);
        QVERIFY(fallen(part, 3, 0.2) > 0.85);
    }

private:
    // Returns the share by which the next part's error falls. The error is the root mean square on
    // the body, halfway between the photographed places. `scatter` is in mm along each axis.
    static double fallen(const test::PhotographedPart& part, int parts, double scatter) {
        constexpr double pixelsPerMillimetre = 34;
        const FilmSettings& film = part.project().film;
        const auto cameras =
            test::camerasAround({{20, -35}, {110, -30}, {200, -40}, {290, -30}}, 280, 3.4, 4000);
        AsBuilt built;
        for (int number = 1; number <= parts; ++number) {
            const FitPairs perfect = part.pairs(cameras, 60, 30, 0, number);
            const FitPairs seen =
                part.pairs(cameras, 60, 30, scatter * pixelsPerMillimetre, number);
            const PartView view =
                fitPartCamera(perfect.body, seen.photos, seen.picture, seen.where);
            for (const BuiltPlace& place :
                 builtPlaces(seen.printed, view, seen.picture, {part.believedFilm()},
                             {film.width.value(), film.height.value()}, number)) {
                built.places.push_back(place);
            }
            built.parts.push_back({QStringLiteral("2026-11-22"), QStringLiteral("Ada"), {}, 0});
        }
        const RepeatingError error(built, 1);
        double before = 0, after = 0, count = 0;
        for (double x = -36; x <= 36; x += 8) {
            for (double y = -36; y <= 36; y += 8) {
                const Eigen::Vector2d sheet(x, y);
                const auto meant = test::onModel(*part.believedFilm(), sheet, film);
                const auto lies = test::onModel(*part.filmInTank(), sheet, part.settingsInTank());
                const auto next = test::onModel(*part.filmInTank(), printedAt(sheet, error, 1),
                                                part.settingsInTank());
                if (meant && lies && next && sheet.norm() < 34) {
                    before += (*lies - *meant).squaredNorm();
                    after += (*next - *meant).squaredNorm();
                    count += 1;
                }
            }
        }
        qInfo("parts %d, scatter %.1f mm: %.3f mm before, %.3f mm after, of %d places", parts,
              scatter, std::sqrt(before / count), std::sqrt(after / count), int(count));
        return 1 - std::sqrt(after / before);
    }
};

QTEST_MAIN(BuiltPlacesTest)
#include "BuiltPlacesTest.moc"
