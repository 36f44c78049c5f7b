// Tests the processor time of a thread.
#include "base/ProcessorTime.h"

#include <QTest>
#include <QThread>

using namespace dipwright;
using namespace std::chrono_literals;

class ProcessorTimeTest : public QObject {
    Q_OBJECT

private slots:
    void threadProcessorTime_waiting_doesNotCount() {
        const auto before = threadProcessorTime();
        QThread::msleep(100);
        QVERIFY(threadProcessorTime() - before < 50ms);
    }

    void threadProcessorTime_computing_counts() {
        const auto before = threadProcessorTime();
        while (threadProcessorTime() - before < 1ms) {
        }
        QVERIFY(threadProcessorTime() > before);
    }
};

QTEST_GUILESS_MAIN(ProcessorTimeTest)
#include "ProcessorTimeTest.moc"
