// Tests how the pose search predicts the work for a certain sheet from two coarse films.
#include "search/PredictedSheet.h"
#include "accuracy/verdict/FinerFilm.h"

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
constexpr ComparedCells halved{4, 2, 1};

using Kind = VerdictReason::Kind;

// A film with cells of 1 mm.
DippedFilm filmOfMillimetres() {
    DippedFilm film;
    film.grid.columns = film.grid.rows = 101;
    film.grid.width = film.grid.depth = 100;
    film.steps = 1000;
    return film;
}

// The verdict "check first" for a numerical error, with a limit of 0.5 mm.
Verdict checkFirst(Kind kind, double error, double proposedCell) {
    ReasonList reasons;
    reasons.add({kind, Advice::CheckFirst, error, 0.5, {}, proposedCell});
    return std::move(reasons).verdict();
}

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

    // One of 20 places is 5 %, and so may be far off in zone C; one of 19 may not.
    void predictedDoublings_smallZone_countsPlacesExactly() {
        ToleranceSettings tolerance;
        tolerance.limits[std::size_t(Zone::B)] = Millimetres(1000); // does not count
        std::vector<PlaceMove> some = moves(0, 0);
        some.resize(19);
        some.push_back({1, Zone::C});
        QCOMPARE(predictedDoublings(some, halved, tolerance), 0.0);
        some.back().distance = 2.9F; // within the whole limit
        QCOMPARE(predictedDoublings(some, halved, tolerance), 0.0);
        some.erase(some.begin());
        QVERIFY(predictedDoublings(some, halved, tolerance) > 4);
    }

    void predictedDoublings_filmsThatTellNothing_areZero() {
        QCOMPARE(predictedDoublings({}, halved, {}), 0.0);
        QCOMPARE(predictedDoublings(moves(9, 9), {2, 2, 1}, {}), 0.0);
        QCOMPARE(predictedDoublings(moves(9, 9), {4, 2, 0}, {}), 0.0);
    }

    void neededDoublings_smallError_areZero() {
        ReasonList reasons;
        reasons.add({Kind::Certain, Advice::Print, 0.3});
        reasons.add({Kind::Air, Advice::CheckFirst, 0.01});
        QCOMPARE(neededDoublings(std::move(reasons).verdict(), filmOfMillimetres()), 0.0);
    }

    void neededDoublings_refinedFilm_followFromItsCell() {
        ReasonList reasons;
        reasons.add({Kind::Refined, Advice::Print, 0.5});
        QCOMPARE(neededDoublings(std::move(reasons).verdict(), filmOfMillimetres()), 3.0);
    }

    // The work limit allows no smaller cells, so the verdict stays "check first".
    void neededDoublings_filmThatCannotBeRefined_growWithTheError() {
        const DippedFilm film = filmOfMillimetres();
        FilmSettings settings;
        settings.resolution = FilmResolution::Automatic;
        settings.work = double(film.grid.pointCount()) * 1000 / 1e6;
        const auto doublings = [&](Kind kind, double error, double cell) {
            const Verdict verdict = afterRefinement(checkFirst(kind, error, cell), film, settings);
            if (verdict.advice != Advice::CheckFirst) {
                return -1.0;
            }
            return neededDoublings(verdict, film);
        };
        QCOMPARE(doublings(Kind::OffBy, 1, 0.5), 3.0);
        QCOMPARE(doublings(Kind::OffBy, 2, 0.25), 6.0);
        QCOMPARE(doublings(Kind::OffByMuch, 4, 0), 9.0);
        QCOMPARE(doublings(Kind::OffByMuch, 400, 0), mostDoublings);
        QCOMPARE(doublings(Kind::Border, 0.1, 0), 3.0); // half the cell
    }
};

QTEST_GUILESS_MAIN(PredictedSheetTest)
#include "PredictedSheetTest.moc"
