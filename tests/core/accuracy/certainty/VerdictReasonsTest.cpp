// What a verdict says of films laid by hand, with and without a comparison.
#include "accuracy/certainty/Verdict.h"

#include "DippedByHand.h"
#include "geometry/Shapes.h"

#include <QtTest>

using namespace dipwright;

namespace {

const Eigen::Vector3d boxSize(40, 30, 40);

// `isGraded`: its lines are told one by one, 1 mm apart, as those of automatic cells are.
std::shared_ptr<const LaidFilm> filmWith(const solver::EquilibriumAccount& account,
                                         bool isGraded = false) {
    DippedFilm film = test::flatUnderBox({61, 61, 60, 60}, boxSize);
    film.equilibrium = account;
    for (int line = 0; isGraded && line < 61; ++line) {
        film.grid.columnPlaces.push_back(line - 30);
        film.grid.rowPlaces.push_back(line - 30);
    }
    return test::laid(boxMesh(boxSize), film);
}

// Of a film that all coarser dips agree with.
CertaintyEstimate agreement(const LaidFilm& laid) {
    const auto same = test::laid(laid.body().mesh, laid.film());
    return certaintyEstimate(laid, {same, same, {}});
}

// What is said of a film of 1 mm cells, graded or not, that twice the cell changes so much, mm.
QString toldOf(double change, bool isGraded) {
    const auto laid = filmWith({}, isGraded);
    CertaintyEstimate estimate = agreement(*laid);
    estimate.doubleSpacing.distance.percentile95 = change;
    estimate.offBy.percentile95 = change;
    return verdictText(QStringLiteral("Top"), verdict(*laid, &estimate));
}

qsizetype mentions(const Verdict& verdict) {
    return verdictText(QStringLiteral("Top"), verdict).count(QStringLiteral("equilibrium"));
}

} // namespace

class VerdictReasonsTest : public QObject {
    Q_OBJECT

private slots:
    void stepsWithoutEquilibriumAreToldOnce() {
        const auto laid = filmWith({3, 0.25, 900});
        const CertaintyEstimate estimate = agreement(*laid);
        const Verdict judged = verdict(*laid, &estimate);
        QCOMPARE(judged.advice, Advice::LookFirst);
        QCOMPARE(mentions(judged), qsizetype(1));
    }

    void aFilmThatIsTooCoarseIsToldWhatCanBeSet() {
        // Half the cell is expected to change 0.2 mm, four thirds of what a certain sheet may.
        QVERIFY(toldOf(0.4, false).contains(QStringLiteral("more points")));
        QVERIFY(toldOf(0.4, true).contains(QStringLiteral("try a cell size of 0.75 mm")));
        for (const bool isGraded : {false, true}) {
            const QString line = toldOf(4, isGraded);
            QVERIFY(line.contains(QStringLiteral("smaller cells or more points")));
            QVERIFY(!line.contains(QStringLiteral("cell size")));
        }
    }

    void theyAreToldOfSheetsThatNobodyAskedAboutToo() {
        const Verdict unjudged = verdict(*filmWith({3, 0.25, 900}), nullptr);
        QCOMPARE(unjudged.advice, Advice::NotJudged);
        QCOMPARE(unjudged.reasons.front().kind, VerdictReason::Kind::NotAsked);
        QCOMPARE(mentions(unjudged), qsizetype(1));
    }

    void whereAllAgreesThereIsNothingElseToTell() {
        const auto laid = filmWith({});
        const CertaintyEstimate estimate = agreement(*laid);
        const Verdict judged = verdict(*laid, &estimate);
        QCOMPARE(judged.advice, Advice::Print);
        QCOMPARE(judged.reasons.size(), std::size_t(1));
        QCOMPARE(mentions(judged), qsizetype(0));
        const QString line = verdictText(QStringLiteral("Top"), judged);
        QVERIFY2(line.startsWith(QStringLiteral("Top: Print it. 95 % of the sheet")),
                 qPrintable(line));
    }
};

QTEST_GUILESS_MAIN(VerdictReasonsTest)
#include "VerdictReasonsTest.moc"
