// Tests how the pose search predicts the work for a certain sheet from two coarse films.
#include "search/PredictedSheet.h"

#include <QtTest>

using namespace dipwright;

namespace {

// Returns moves from `least` to `most` mm, evenly spread, in one zone.
std::vector<PlaceMove> moves(float least, float most, Zone zone = Zone::C) {
    std::vector<PlaceMove> all;
    for (int i = 0; i <= 1000; ++i) {
        all.push_back({least + (most - least) * float(i) / 1000, zone});
    }
    return all;
}

// Cells of 4 and 2 mm, and a job that begins with 1 mm.
constexpr ComparedFilms halved{{4, 0.1}, {2, 0.8}, {1, 10}};

} // namespace

class PredictedSheetTest : public QObject {
    Q_OBJECT

private slots:
    // If 2 mm more move a place by 1 mm, the job's 1 mm leaves half a millimetre: the share of
    // zone C. Twice the error needs half the cell, and so eight times the work.
    void predictedDoublings_errorOfFirstOrder_needsCubicWork() {
        QCOMPARE(predictedDoublings(moves(1, 1), halved, {}), 0.0);
        QCOMPARE(predictedDoublings(moves(2, 2), halved, {}), 3.0);
        QCOMPARE(predictedDoublings(moves(4, 4), halved, {}), 6.0);
    }

    void predictedDoublings_exactZone_hasItsOwnLimit() {
        ToleranceSettings tolerance;
        tolerance.limits[std::size_t(Zone::A)] = Millimetres(0.75);
        QCOMPARE(predictedDoublings(moves(1, 1), halved, tolerance), 0.0);
        QCOMPARE(predictedDoublings(moves(1, 1, Zone::A), halved, tolerance), 3.0);
    }

    void predictedDoublings_fewPlacesFarOff_countAboveOnePerCent() {
        std::vector<PlaceMove> some = moves(0, 0.1f);
        for (int i = 0; i < 5; ++i) {
            some.push_back({12, Zone::C});
        }
        QCOMPARE(predictedDoublings(some, halved, {}), 0.0);
        for (int i = 0; i < 10; ++i) {
            some.push_back({12, Zone::C});
        }
        QCOMPARE(predictedDoublings(some, halved, {}), 6.0);
    }

    void predictedDoublings_filmsThatTellNothing_areZero() {
        QCOMPARE(predictedDoublings({}, halved, {}), 0.0);
        const ComparedFilms equal{{2, 1}, {2, 1}, {1, 10}};
        QCOMPARE(predictedDoublings(moves(9, 9), equal, {}), 0.0);
        const ComparedFilms noJob{{4, 0.1}, {2, 0.8}, {}};
        QCOMPARE(predictedDoublings(moves(9, 9), noJob, {}), 0.0);
    }
};

QTEST_GUILESS_MAIN(PredictedSheetTest)
#include "PredictedSheetTest.moc"
