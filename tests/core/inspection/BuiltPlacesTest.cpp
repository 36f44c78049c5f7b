// Where the film lies on a dipped part, told on the sheet.
#include "inspection/BuiltPlaces.h"
#include "PhotographedPart.h"
#include "correction/SheetCorrection.h"
#include "solver/SolverRegistry.h"

#include <QStandardPaths>
#include <QtTest>

using namespace dipwright;

namespace {

const solver::SolverModule& solverModule() {
    static const SolverRegistry plugins{QStringList{DIPWRIGHT_PLUGINS}};
    return plugins.module(QStringLiteral("pbd-cpu"));
}

} // namespace

class BuiltPlacesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

    // Film that is laid on a body 1.1 and 0.7 mm aside lies where film that much the other way was
    // meant to lie, all over.
    void aBodyAsideIsAPrintAside() {
        const Project believed = test::eggToFit(1, 2.4);
        const test::Hidden aside{1.03, 1.03, std::numeric_limits<double>::infinity(), 1.1, -0.7, 0};
        const test::PhotographedPart part(believed, aside, 2.4, solverModule());
        const auto cameras = test::camerasRound({{20, -35}, {140, -30}}, 280, 3.4, 4000);
        const FitPairs pairs = part.pairs(cameras, 24, 20, 0.3, 1);
        const PartView view = fitPartCamera(pairs.body, pairs.photos, pairs.picture, pairs.where);
        const auto places =
            builtPlaces(pairs.printed, view, pairs.picture, {part.believedFilm()},
                        {believed.film.width.value(), believed.film.height.value()}, 1);
        QVERIFY(places.size() > 20);
        for (const BuiltPlace& place : places) {
            const Eigen::Vector2d off(place.off[0].value() + 1.1 / 1.03,
                                      place.off[1].value() - 0.7 / 1.03);
            QVERIFY2(off.norm() < 0.15, qPrintable(QStringLiteral("%1, %2 mm of the sheet are off "
                                                                  "by %3 mm")
                                                       .arg(place.sheet[0].value())
                                                       .arg(place.sheet[1].value())
                                                       .arg(off.norm())));
        }
        qInfo("%zu places, %.3f mm off on the sheet", places.size(), residualOf(places));

        // The next sheet has its print where it comes to lie right.
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
};

QTEST_MAIN(BuiltPlacesTest)
#include "BuiltPlacesTest.moc"
