// How much of a waiting time the timer counts, with a simulated clock.
#include "base/SuspendAwareTimer.h"

#include <QTest>

using namespace dipwright;
using namespace std::chrono_literals;

class SuspendAwareTimerTest : public QObject {
    Q_OBJECT

private slots:
    void suspendAwareTimer_frequentCalls_addUp() {
        SuspendAwareTimer waited(start_);
        for (int look = 1; look <= 100; ++look) {
            QVERIFY(waited.look(start_ + look * 20ms) == look * 20ms);
        }
        QVERIFY(waited.look(start_ + 2s) == 2s); // a call at the same time adds nothing
    }

    void suspendAwareTimer_suspendedForHours_countsOneGap() {
        SuspendAwareTimer waited(start_);
        QVERIFY(waited.look(start_ + 500ms) == 500ms);
        QVERIFY(waited.look(start_ + 8h) <= 500ms + SuspendAwareTimer::longestGap);
        QVERIFY(waited.look(start_ + 8h + 500ms) <= 1s + SuspendAwareTimer::longestGap);
    }

private:
    SuspendAwareTimer::Clock::time_point start_ = SuspendAwareTimer::Clock::now();
};

QTEST_GUILESS_MAIN(SuspendAwareTimerTest)
#include "SuspendAwareTimerTest.moc"
