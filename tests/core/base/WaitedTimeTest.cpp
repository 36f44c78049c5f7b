// What counts of a wait, with a clock of the test's own.
#include "base/WaitedTime.h"

#include <QTest>

using namespace dipwright;
using namespace std::chrono_literals;

class WaitedTimeTest : public QObject {
    Q_OBJECT

private slots:
    void looksAddUp() {
        WaitedTime waited(start_);
        for (int look = 1; look <= 100; ++look) {
            QVERIFY(waited.look(start_ + look * 20ms) == look * 20ms);
        }
        QVERIFY(waited.look(start_ + 2s) == 2s); // and time that stands still adds nothing
    }

    void aNightAsleepIsNoHang() {
        WaitedTime waited(start_);
        QVERIFY(waited.look(start_ + 500ms) == 500ms);
        QVERIFY(waited.look(start_ + 8h) <= 500ms + WaitedTime::longestGap);
        QVERIFY(waited.look(start_ + 8h + 500ms) <= 1s + WaitedTime::longestGap);
    }

private:
    WaitedTime::Clock::time_point start_ = WaitedTime::Clock::now();
};

QTEST_GUILESS_MAIN(WaitedTimeTest)
#include "WaitedTimeTest.moc"
