// The time left of a job, from given progress reports.
#include "workbench/jobs/TimeLeft.h"

#include <QtTest>
#include <cmath>

using namespace dipwright;

namespace {

// Reports every `every` seconds, at a speed in shares per second.
std::vector<JobProgress> reportsAt(double speed, double every, double until,
                                   JobProgress begin = {0, 0}) {
    std::vector<JobProgress> reports{begin};
    for (double time = begin.seconds + every; time <= until; time += every) {
        reports.push_back({time, begin.share + speed * (time - begin.seconds)});
    }
    return reports;
}

} // namespace

class TimeLeftTest : public QObject {
    Q_OBJECT

private slots:
    void secondsLeft_shortlyAfterTheStart_isUnknown() {
        QVERIFY(!secondsLeft(reportsAt(0.01, 0.5, 2), 2));
        QVERIFY(!secondsLeft({}, 20));
        QVERIFY(!secondsLeft({{1, 0.2}}, 20));
    }

    void secondsLeft_evenProgress_isExact() {
        for (const double now : {5, 20, 60, 90}) {
            const auto left = secondsLeft(reportsAt(0.01, 0.5, now), now);
            QVERIFY(left);
            QVERIFY(std::abs(*left - (100 - now)) < 1e-6);
        }
    }

    void secondsLeft_skippedFirstStage_doesNotCount() {
        // A stage that was stored takes no time, then the job needs 80 s for the rest.
        const auto reports = reportsAt(0.01, 0.5, 20, {0.5, 0.2});
        QVERIFY(std::abs(*secondsLeft(reports, 20) - 60.5) < 1e-6);
    }

    void secondsLeft_fewReports_runsDownBetweenThem() {
        const auto reports = reportsAt(0.01, 10, 30); // each dip takes 10 s
        double last = 1e9;
        for (double now = 30; now <= 40; ++now) {
            const double left = *secondsLeft(reports, now);
            QVERIFY2(left < last && std::abs(left - (100 - now)) < 1e-6,
                     qPrintable(QString::number(left)));
            last = left;
        }
    }

    void secondsLeft_lateReport_doesNotRunToZero() {
        const auto reports = reportsAt(0.01, 1, 50);
        QVERIFY(*secondsLeft(reports, 95) > 50);
    }

    void steadySeconds_countdown_neverGoesUp() {
        std::optional<double> shown;
        for (double time = 0; time < 90; ++time) {
            const double noise = 3 * std::sin(time);
            const double next = steadySeconds(std::max(0.0, 90 - time + noise), shown);
            QVERIFY2(!shown || next <= *shown, qPrintable(QString::number(time)));
            shown = next;
        }
        QCOMPARE(*shown, 5.0);
    }

    void steadySeconds_muchLonger_isShown() { QCOMPARE(steadySeconds(100, 40.0), 120.0); }

    void timeLeftText_hasOneOrTwoUnits() {
        QLocale::setDefault(QLocale::c());
        QCOMPARE(timeLeftText(40), QStringLiteral("about 40 s left"));
        QCOMPARE(timeLeftText(300), QStringLiteral("about 5 min left"));
        QCOMPARE(timeLeftText(4800), QStringLiteral("about 1 h 20 min left"));
    }
};

QTEST_GUILESS_MAIN(TimeLeftTest)
#include "TimeLeftTest.moc"
