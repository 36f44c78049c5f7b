// Tests verdicts on films whose positions the test sets, with and without an estimate of the
// numerical error.
#include "accuracy/verdict/BareZones.h"
#include "accuracy/verdict/FinerFilm.h"

#include "DippedByHand.h"
#include "JoinedMeshes.h"
#include "geometry/Shapes.h"
#include "marks/SurfaceMask.h"

#include <QtTest>

using namespace dipwright;

namespace {

const Eigen::Vector3d boxSize(40, 30, 40);

// Returns a film with the given convergence. If `isGraded` is true, the film lists each of its
// lines, 1 mm apart, as automatic cells do.
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

// Returns the estimate for a film that does not change in coarser dips.
NumericalErrorEstimate agreement(const LaidFilm& laid) {
    const auto same = test::laid(laid.body().mesh, laid.film());
    return estimateNumericalError(laid, {same, same, {}});
}

// Returns the estimate for a film that moves by `change` mm everywhere if its cells are doubled.
NumericalErrorEstimate movedBy(const LaidFilm& laid, double change) {
    NumericalErrorEstimate estimate = agreement(laid);
    estimate.doubleSpacing.distance.percentile95 = change;
    estimate.offBy.percentile95 = change;
    std::fill(estimate.pointErrors.begin(), estimate.pointErrors.end(), float(change));
    return estimate;
}

Verdict judged(const LaidFilm& laid, const NumericalErrorEstimate* estimate,
               const ZonedBody* zones = nullptr, const ToleranceSettings& tolerance = {}) {
    return verdict({laid, coverage(laid), estimate, 0, {zones}}, tolerance, {});
}

// Sets the error of the first `share` of the film's points on the body.
void setFirstErrors(NumericalErrorEstimate& estimate, const LaidFilm& laid, double share,
                    float error) {
    std::vector<std::size_t> onBody;
    for (std::size_t point = 0; point < estimate.pointErrors.size(); ++point) {
        if (laid.contact().surface[point].isValid()) {
            onBody.push_back(point);
        }
    }
    onBody.resize(std::size_t(share * double(onBody.size())));
    for (const std::size_t point : onBody) {
        estimate.pointErrors[point] = error;
    }
}

// Returns the verdict's text for a film of 1 mm cells that moves by `change` mm if its cells are
// doubled.
QString verdictTextOf(double change, bool isGraded) {
    const auto laid = filmWith({}, isGraded);
    const NumericalErrorEstimate estimate = movedBy(*laid, change);
    return verdictText(QStringLiteral("Top"), judged(*laid, &estimate));
}

qsizetype mentions(const Verdict& verdict) {
    return verdictText(QStringLiteral("Top"), verdict)
        .count(QStringLiteral("the film did not converge"));
}

// Returns the verdict on a dip without numerical error, after `change` has changed the dip's
// coverage.
template <typename Change>
Verdict changedBy(Change change, double paleArea = 0) {
    const auto laid = filmWith({});
    const NumericalErrorEstimate estimate = agreement(*laid);
    Coverage painted = coverage(*laid);
    change(painted, surfaceArea(laid->body().mesh));
    return verdict({*laid, painted, &estimate, paleArea}, {}, {});
}

} // namespace

class VerdictReasonsTest : public QObject {
    Q_OBJECT

private slots:
    void verdict_stepsWithoutEquilibrium_givesOneReason() {
        const auto laid = filmWith({3, 0.25, 900});
        const NumericalErrorEstimate estimate = agreement(*laid);
        const Verdict found = judged(*laid, &estimate);
        QCOMPARE(found.advice, Advice::CheckFirst);
        QCOMPARE(mentions(found), qsizetype(1));
    }

    // In zone C, the unmarked area, the numerical error may be a third of 1.5 mm.
    void verdictText_coarseFilm_namesTheSettingToChange() {
        QVERIFY(verdictTextOf(0.75, false).contains(QStringLiteral("Film > Points")));
        QVERIFY(verdictTextOf(0.75, true).contains(QStringLiteral("Set cells of 0.66 mm")));
        // Cells that double the work are the largest that are worth a dip.
        QVERIFY(verdictTextOf(0.52, true).contains(QStringLiteral("Set cells of 0.79 mm")));
        for (const bool isGraded : {false, true}) {
            const QString line = verdictTextOf(4, isGraded);
            QVERIFY2(line.startsWith(QStringLiteral("Top: Do not print")), qPrintable(line));
            QVERIFY(line.contains(QStringLiteral("much smaller cells or more points")));
            QVERIFY(!line.contains(QStringLiteral("to 0.")));
        }
    }

    void verdictText_cellThatCannotBeSet_isNotProposed() {
        for (const double cell : {0.2, 0.09}) {
            Verdict needsCell;
            needsCell.advice = Advice::CheckFirst;
            needsCell.reasons = {
                {VerdictReason::Kind::OffBy, Advice::CheckFirst, 1, 0.5, {}, cell}};
            const QString text = verdictText(QStringLiteral("Top"), needsCell);
            QCOMPARE(text.contains(QStringLiteral("Set cells of")), cell == 0.2);
            QCOMPARE(text.contains(QStringLiteral("Turn the part.")), cell == 0.09);
        }
    }

    void verdictText_secondDip_isProposedOnlyIfThereIsNone() {
        const auto laid = filmWith({});
        const NumericalErrorEstimate estimate = movedBy(*laid, 0.75);
        for (const bool isOnlyDip : {false, true}) {
            JudgedDip dip{*laid, coverage(*laid), &estimate};
            dip.isOnlyDip = isOnlyDip;
            const QString text = verdictText(QStringLiteral("Top"), verdict(dip, {}, {}));
            QCOMPARE(text.contains(QStringLiteral("second dip")), isOnlyDip);
        }
    }

    void verdict_coarserFilmDoesNotFollow_forbidsAndAsksForHalfTheCell() {
        const auto laid = filmWith({});
        const auto same = test::laid(laid->body().mesh, laid->film());
        for (const auto& doubleSpacing : {decltype(same)(), same}) {
            const NumericalErrorEstimate estimate =
                estimateNumericalError(*laid, {doubleSpacing, nullptr, {}});
            QVERIFY(estimate.failure.isEmpty() && !estimate.isKnown());
            const Verdict found = judged(*laid, &estimate);
            QCOMPARE(found.advice, Advice::DoNotPrint);
            QCOMPARE(found.reasons.front().kind, VerdictReason::Kind::NothingAlike);
            QCOMPARE(wantedCell(found, laid->film()), laid->film().grid.leastSpacing() / 2);
        }
    }

    // Where the coarser film paints nothing, the error is unknown.
    void verdict_filmThatIsNotCompared_checkFirst() {
        const auto laid = filmWith({});
        const auto judgedWith = [&](double unknown, double off, float error) {
            NumericalErrorEstimate estimate = movedBy(*laid, 0.2);
            setFirstErrors(estimate, *laid, off, error);
            setFirstErrors(estimate, *laid, unknown, std::numeric_limits<float>::quiet_NaN());
            return judged(*laid, &estimate);
        };
        QCOMPARE(judgedWith(0.03, 0, 0).advice, Advice::Print);
        const Verdict found = judgedWith(0.2, 0, 0);
        QCOMPARE(found.advice, Advice::CheckFirst);
        QCOMPARE(found.reasons.front().kind, VerdictReason::Kind::UnknownError);
        QVERIFY(wantedCell(found, laid->film()));
        QCOMPARE(judgedWith(0.5, 0, 0).advice, Advice::DoNotPrint);
        // It counts as worse than what is known.
        QCOMPARE(judgedWith(0, 0.04, 0.6F).advice, Advice::Print);
        QCOMPARE(judgedWith(0.03, 0.07, 0.6F).reasons.front().kind, VerdictReason::Kind::OffBy);
        // Only what is known to be far off forbids the sheet.
        QCOMPARE(judgedWith(0.03, 0.05, 2).advice, Advice::CheckFirst);
        QCOMPARE(judgedWith(0.03, 0.11, 2).advice, Advice::DoNotPrint);
    }

    void verdict_markedZone_usesItsOwnLimit() {
        const auto laid = filmWith({});
        auto model = std::make_shared<TexturedMesh>(
            test::plainModel(laid->body().mesh, QColor(200, 200, 200)));
        ToleranceSettings tolerance;
        ZoneMark bottom;
        bottom.place[1] = Millimetres(double(boundingBox(model->mesh).min().y()));
        bottom.extent = MarkExtent::Face;
        tolerance.marks = {bottom};
        ZonedBody zones(model);
        zones.setMarks(tolerance.marks);
        const NumericalErrorEstimate estimate = movedBy(*laid, 0.2); // zone A allows 0.1 mm
        QCOMPARE(judged(*laid, &estimate).advice, Advice::Print);
        const Verdict marked = judged(*laid, &estimate, &zones, tolerance);
        QCOMPARE(marked.advice, Advice::CheckFirst);
        QCOMPARE(marked.reasons.front().zone, std::optional(Zone::A));
        QVERIFY(!marked.places.empty());
        QCOMPARE(marked.places.front().limit, 0.1);
        tolerance.limits[0] = Millimetres(0.7);
        QCOMPARE(judged(*laid, &estimate, &zones, tolerance).advice, Advice::Print);
    }

    void verdict_stepErrorAboveLimit_givesReasonStep() {
        const auto laid = filmWith({}, true);
        NumericalErrorEstimate estimate = movedBy(*laid, 0.75);
        estimate.doubleStep.distance.percentile95 = 1.6; // a quarter of it is compared
        QCOMPARE(judged(*laid, &estimate).reasons.front().kind, VerdictReason::Kind::Step);
    }

    void estimate_filmsThatAgreeByChance_leaveAShareOfTheCell() {
        const auto laid = filmWith({});
        const auto same = test::laid(laid->body().mesh, laid->film());
        const NumericalErrorEstimate estimate = estimateNumericalError(*laid, {same, same, {}}, {});
        const double least = 0.2 * laid->film().grid.leastSpacing();
        QVERIFY(std::abs(estimate.offBy.percentile95 - least) < 1e-6);
        for (std::size_t point = 0; point < estimate.pointErrors.size(); ++point) {
            const bool isOnBody = laid->contact().surface[point].isValid();
            QVERIFY(estimate.pointErrors[point] == (isOnBody ? float(least) : 0.0F));
        }
        ToleranceSettings strict; // a third of it is less than the least error
        strict.limits.fill(Millimetres(2 * least));
        const Verdict verdict = judged(*laid, &estimate, nullptr, strict);
        QCOMPARE(verdict.advice, Advice::CheckFirst);
        QVERIFY(verdict.reasons.front().kind != VerdictReason::Kind::Step);
    }

    // Films of these cells lie `side` mm to the side per cell: the dip's own, with double the cell,
    // before the refinement, and with double the cell of that. A line has only the error of its
    // slope, times 1.5. The other errors are computed by hand.
    void estimate_filmsBefore_countWithSlopeAndDeviation_data() {
        QTest::addColumn<std::vector<int>>("cells"); // that fill the width of 60 mm
        QTest::addColumn<std::vector<double>>("sides");
        QTest::addColumn<double>("error");
        using Cells = std::vector<int>;
        using Sides = std::vector<double>;
        const Cells all{60, 30, 40, 20}, halved{60, 30, 30, 15};
        QTest::newRow("line") << all << Sides{0.2, 0.2, 0.2, 0.2} << 1.5 * 0.2;
        QTest::newRow("noise") << all << Sides{0.3, -0.3, -0.3, 0.3} << 1.5 * 0.129 + 0.296;
        QTest::newRow("three films") << Cells{60, 30, 40} << Sides{0.2, 0.2, 0.2} << 1.5 * 0.2;
        QTest::newRow("halved cells: three films") << halved << Sides{0.2, 0.2, 0.2, 0.2} << 0.3;
        QTest::newRow("two films: their distance")
            << Cells{60, 30, 30} << Sides{0, 0.2, 0.2} << 0.4;
    }
    void estimate_filmsBefore_countWithSlopeAndDeviation() {
        QFETCH(std::vector<int>, cells);
        QFETCH(std::vector<double>, sides);
        QFETCH(double, error);
        const auto own = filmWith({});
        std::vector<std::shared_ptr<const LaidFilm>> films;
        for (std::size_t film = 0; film < cells.size(); ++film) {
            const int points = cells[film] + 1;
            DippedFilm dipped = test::flatUnderBox({points, points, 60, 60}, boxSize);
            for (Eigen::Vector3f& place : dipped.positions) {
                place.x() += float(sides[film] * 60 / cells[film]);
            }
            films.push_back(test::laid(own->body().mesh, dipped));
        }
        const LaidFilm* last = films.size() > 3 ? films[3].get() : nullptr;
        const std::size_t middle = 30 * 61 + 30;
        const auto errorWith = [&](const std::shared_ptr<const LaidFilm>& doubleStep) {
            return double(estimateNumericalError(*films[0], {films[1], doubleStep, {}},
                                                 FilmsBefore{*films[2], last})
                              .pointErrors[middle]);
        };
        QVERIFY(std::abs(errorWith(films[1]) - error) < 0.001);
        DippedFilm slower = films[1]->film(); // steps twice as long move the film by 2 mm
        for (Eigen::Vector3f& place : slower.positions) {
            place.x() += 2;
        }
        const double left = cells.size() == 3 && cells[1] == cells[2] ? 2 : 1;
        QVERIFY(std::abs(errorWith(test::laid(own->body().mesh, slower)) - left) < 0.001);
    }

    void afterRefinement_affordableCells_replaceTheNumericalReasons() {
        const auto laid = filmWith({}, true);
        const NumericalErrorEstimate estimate = movedBy(*laid, 0.75);
        const Verdict now = judged(*laid, &estimate);
        QCOMPARE(now.advice, Advice::CheckFirst);
        FilmSettings film;
        film.resolution = FilmResolution::Automatic;
        const Verdict expected = afterRefinement(now, laid->film(), film);
        QCOMPARE(expected.advice, Advice::Print);
        QCOMPARE(expected.reasons.front().kind, VerdictReason::Kind::Refined);
        film.resolution = FilmResolution::Cell; // never refined
        QCOMPARE(afterRefinement(now, laid->film(), film).advice, Advice::CheckFirst);
    }

    void verdict_shareAboveLimit_checkFirstThenDoNotPrint_data() {
        QTest::addColumn<double>("share");
        QTest::addColumn<int>("advice");
        QTest::newRow("within") << 0.9 << int(Advice::Print);
        QTest::newRow("above") << 1.1 << int(Advice::CheckFirst);
        QTest::newRow("far above") << 5.5 << int(Advice::DoNotPrint);
    }
    void verdict_shareAboveLimit_checkFirstThenDoNotPrint() {
        QFETCH(double, share);
        QFETCH(int, advice);
        const VerdictSettings limits;
        const Verdict air = changedBy([&](Coverage& painted, double surface) {
            painted.trappedAir.area = share * limits.air * surface;
        });
        QCOMPARE(int(air.advice), advice);
        const Verdict torn = changedBy([&](Coverage& painted, double) {
            painted.marked.add(std::uint8_t(solver::PointMark::Torn),
                               share * limits.damaged * painted.paintedArea);
        });
        QCOMPARE(int(torn.advice), advice);
        double paintedArea = 0;
        changedBy([&](Coverage& painted, double) { paintedArea = painted.paintedArea; });
        const Verdict pale = changedBy([](Coverage&, double) {}, share * limits.pale * paintedArea);
        QCOMPARE(int(pale.advice), advice);
        if (advice > int(Advice::Print)) {
            QCOMPARE(air.reasons.front().kind, VerdictReason::Kind::Air);
            QVERIFY(verdictText({}, air).contains(QStringLiteral("Vent holes narrower than")));
            QCOMPARE(pale.reasons.front().kind, VerdictReason::Kind::Pale);
            QCOMPARE(torn.reasons.front().kind, VerdictReason::Kind::Damaged);
        }
    }

    // The small box is 1 % of the painted area. Its error is unknown.
    void verdict_smallBodyBesideLargeOne_isJudgedByItself() {
        TexturedMesh model = test::plainModel(boxMesh(boxSize), Qt::white);
        model.mesh = test::joined(model.mesh, boxMesh({4, boxSize.y(), 4}), {25, 0, 0});
        model.materials.push_back({QStringLiteral("Knob: brass"), Qt::white});
        model.material.resize(model.mesh.triangles.size(), 1);
        const auto bodies = separateBodies(model);
        QVERIFY(bodies);
        QCOMPARE(bodies->names.size(), 2);
        QCOMPARE(bodies->names[1], QStringLiteral("Knob"));

        DippedFilm film = test::flatUnderBox({61, 61, 60, 60}, boxSize);
        const auto isUnderSmall = [&](std::size_t point) {
            const Eigen::Vector2f rest = restPosition(film.grid, point);
            return std::abs(rest.x() - 25) <= 2 && std::abs(rest.y()) <= 2;
        };
        for (std::size_t point = 0; point < film.states.size(); ++point) {
            if (isUnderSmall(point)) {
                film.states[point] = solver::PointState::Adhered;
            }
        }
        const auto laid = test::laid(model.mesh, film);
        NumericalErrorEstimate estimate = agreement(*laid);
        for (std::size_t point = 0; point < film.states.size(); ++point) {
            if (isUnderSmall(point)) {
                estimate.pointErrors[point] = std::numeric_limits<float>::quiet_NaN();
            }
        }
        const Coverage covered = coverage(*laid);
        VerdictSettings limits;
        limits.edge = Millimetres(0);
        QCOMPARE(verdict({*laid, covered, &estimate}, {}, limits).advice, Advice::Print);
        const Verdict found =
            verdict({*laid, covered, &estimate, 0, {nullptr, nullptr, bodies.get()}}, {}, limits);
        QCOMPARE(found.advice, Advice::DoNotPrint);
        QCOMPARE(found.reasons.front().kind, VerdictReason::Kind::UnknownError);
        QCOMPARE(found.reasons.front().body, bodies->names[1]);

        ReasonList bare;
        const std::vector<std::uint8_t> painted{1, 0, 0};
        addBareBodyReasons(bare, {{0, 0, 1}, {"Large", "Small"}},
                           std::vector{middleOf(0), middleOf(1), middleOf(2)}, painted, 0.1);
        const Verdict ofBare = std::move(bare).verdict();
        QCOMPARE(ofBare.reasons.size(), std::size_t(1));
        QVERIFY(reasonText(ofBare.reasons[0], millimetres).startsWith(QStringLiteral("Small: ")));
    }

    void verdict_manyBareBodies_areNamedOrCounted() {
        ReasonList bare;
        const std::vector<std::uint8_t> painted(6, 0);
        std::vector<SurfacePoint> places;
        for (std::uint32_t body = 0; body < 6; ++body) {
            places.push_back(middleOf(body));
        }
        addBareBodyReasons(bare, {{0, 1, 2, 3, 4, 5}, {"A", "B", "C", "D", "E", "F"}}, places,
                           painted, 0.1);
        QStringList bodies;
        for (const VerdictReason& reason : bare.reasons()) {
            bodies << reason.body;
        }
        QCOMPARE(bodies, QStringList({"A", "B", "C", "3 more bodies"}));
    }

    void verdict_unpaintedBody_doNotPrint() {
        const Verdict bare = changedBy([](Coverage& painted, double) { painted.paintedArea = 0; });
        QCOMPARE(bare.advice, Advice::DoNotPrint);
        QCOMPARE(bare.reasons.front().kind, VerdictReason::Kind::Unpainted);
    }

    void verdict_everythingMasked_blamesTheMask() {
        const auto laid = filmWith({});
        const NumericalErrorEstimate estimate = agreement(*laid);
        const auto model =
            std::make_shared<TexturedMesh>(test::plainModel(boxMesh(boxSize), Qt::white));
        MaskMark whole;
        whole.extent = MarkExtent::Material;
        const auto mask = surfaceMask(model, {whole});
        const Coverage covered = coverage(*laid, mask.get());
        const Verdict bare = verdict({*laid, covered, &estimate, 0, {nullptr, mask.get()}}, {}, {});
        QCOMPARE(bare.advice, Advice::DoNotPrint);
        QCOMPARE(bare.reasons.size(), std::size_t(1)); // nothing on the numerical error
        QCOMPARE(bare.reasons.front().kind, VerdictReason::Kind::AllMasked);
    }

    // The film is 60 mm wide and the box 40 mm, so 10 mm of film are left on each side.
    void verdict_paintNearFilmEdge_checkFirst() {
        const auto laid = filmWith({});
        const NumericalErrorEstimate estimate = agreement(*laid);
        const JudgedDip dip{*laid, coverage(*laid), &estimate};
        VerdictSettings limits;
        limits.edge = Millimetres(9);
        QCOMPARE(verdict(dip, {}, limits).advice, Advice::Print);
        limits.edge = Millimetres(12);
        const Verdict near = verdict(dip, {}, limits);
        QCOMPARE(near.advice, Advice::CheckFirst);
        QVERIFY(std::abs(near.reasons.front().value - 10) < 1.01); // within a cell
    }

    // Reasons against printing also count without an estimate.
    void verdict_withoutEstimate_isNotJudged() {
        QCOMPARE(judged(*filmWith({}), nullptr).advice, Advice::NotJudged);
        const Verdict unbalanced = judged(*filmWith({3, 0.25, 900}), nullptr);
        QCOMPARE(unbalanced.advice, Advice::CheckFirst);
        QCOMPARE(unbalanced.reasons.back().kind, VerdictReason::Kind::NotAsked);
        QCOMPARE(mentions(unbalanced), qsizetype(1));
    }

    void verdict_allDipsAgree_printWithOneReason() {
        const auto laid = filmWith({});
        const NumericalErrorEstimate estimate = agreement(*laid);
        const Verdict found = judged(*laid, &estimate);
        QCOMPARE(found.advice, Advice::Print);
        QCOMPARE(found.reasons.size(), std::size_t(1));
        QCOMPARE(mentions(found), qsizetype(0));
        const QString line = verdictText(QStringLiteral("Top"), found);
        QVERIFY2(line.startsWith(QStringLiteral("Top: Print it. Numerical error: at most ")),
                 qPrintable(line));
    }

    void verdictReason_everyKind_hasTextAndUniqueKey() {
        QStringList keys;
        for (int kind = 0; kind <= int(VerdictReason::Kind::UnusualSwell); ++kind) {
            const VerdictReason reason{VerdictReason::Kind(kind),
                                       Advice::Print,
                                       0.1,
                                       0.05,
                                       QStringLiteral("the cause"),
                                       1};
            QVERIFY2(reasonText(reason, millimetres).size() > 8,
                     qPrintable(QStringLiteral("reason %1 has no text").arg(kind)));
            keys << reasonKey(reason.kind);
        }
        QCOMPARE(keys.removeDuplicates(), qsizetype(0));
    }
};

QTEST_GUILESS_MAIN(VerdictReasonsTest)
#include "VerdictReasonsTest.moc"
