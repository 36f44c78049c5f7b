// Loops, sorting, tasks and teams of threads.
#include "parallel/ParallelFor.h"
#include "parallel/ParallelSort.h"
#include "parallel/Tasks.h"
#include "parallel/Threads.h"

#include <QtTest>

#include <atomic>
#include <chrono>
#include <numeric>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace dipwright;

class ParallelTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void parallelFor_visitsEveryIndexOnce();
    void parallelForPieces_coverTheRange();
    void parallelFor_emptyRange_doesNothing();
    void parallelFor_nested_computesAll();
    void parallelFor_exception_reachesTheCaller();
    void parallelSort_equalsStdSort_data();
    void parallelSort_equalsStdSort();
    void tasks_nestedTasksAndLoops_allRun();
    void tasks_oneThrows_othersFinish();
    void tasks_destroyedWithoutWait_finish();
    void tasks_destroyedAfterException_deletesIt();
    void runIsolated_loop_runsNoOtherTask();
    void threadLimit_inScope_limitsTheThreads();
    void threadTeam_run_finishesBeforeItReturns();
    void threadTeam_exception_reachesTheCaller();
    void threadTeam_manyShortLoops_seeEachOthersResults();
    void threadTeam_loopsOfAllLengths_visitEveryIndexOnce();
    void threadTeam_nestedLoop_computesAll();
    void threadTeam_exceptionInALoop_reachesTheCaller();
};

void ParallelTest::parallelFor_visitsEveryIndexOnce() {
    std::vector<int> visits(10'000, 0);
    parallelFor(3, 10'000, [&](int index) { ++visits[std::size_t(index)]; });
    parallelForEvenly(std::size_t(3), visits.size(), [&](std::size_t index) { ++visits[index]; });
    QCOMPARE(std::count(visits.begin(), visits.end(), 0), 3);
    QCOMPARE(std::count(visits.begin(), visits.end(), 2), 9'997);
}

void ParallelTest::parallelForPieces_coverTheRange() {
    std::vector<int> visits(10'000, 0);
    parallelForPieces(0, 10'000, 64, [&](int first, int last) {
        for (int index = first; index < last; ++index) {
            ++visits[std::size_t(index)];
        }
    });
    QCOMPARE(std::count(visits.begin(), visits.end(), 1), 10'000);
}

void ParallelTest::parallelFor_emptyRange_doesNothing() {
    std::atomic<int> calls = 0;
    const auto count = [&](int) { ++calls; };
    parallelFor(0, 0, count);
    parallelFor(0, -1, count);
    parallelForEvenly(5, 5, count);
    QCOMPARE(int(calls), 0);
}

void ParallelTest::parallelFor_nested_computesAll() {
    std::vector<int> sums(100, 0);
    parallelFor(0, 100, [&](int outer) {
        std::vector<int> squares(1000);
        parallelFor(0, 1000, [&](int inner) { squares[std::size_t(inner)] = outer * inner; });
        sums[std::size_t(outer)] = std::accumulate(squares.begin(), squares.end(), 0);
    });
    for (int outer = 0; outer < 100; ++outer) {
        QCOMPARE(sums[std::size_t(outer)], outer * 499'500);
    }
}

void ParallelTest::parallelFor_exception_reachesTheCaller() {
    try {
        parallelFor(0, 1000, [](int index) {
            if (index % 10 == 7) {
                throw std::runtime_error("index " + std::to_string(index));
            }
        });
        QFAIL("no exception was thrown");
    } catch (const std::runtime_error& error) {
        QVERIFY(QByteArray(error.what()).endsWith('7'));
    }
}

void ParallelTest::parallelSort_equalsStdSort_data() {
    QTest::addColumn<int>("size");
    for (const int size : {0, 1, 8191, 8192, 8193, 100'000}) {
        QTest::addRow("%d", size) << size;
    }
}

void ParallelTest::parallelSort_equalsStdSort() {
    QFETCH(int, size);
    std::mt19937 random(1);
    std::vector<unsigned> numbers(static_cast<std::size_t>(size));
    std::generate(numbers.begin(), numbers.end(), [&] { return random() % 5000; });
    std::vector<unsigned> expected = numbers;
    std::sort(expected.begin(), expected.end());
    parallelSort(numbers.begin(), numbers.end());
    QVERIFY(numbers == expected);
}

void ParallelTest::tasks_nestedTasksAndLoops_allRun() {
    std::vector<int> sums(20, 0);
    Tasks tasks;
    for (std::size_t number = 0; number < sums.size(); ++number) {
        tasks.run([&, number] {
            tasks.run([&, number] {
                std::vector<int> ones(1000, 0);
                parallelFor(std::size_t(0), ones.size(), [&](std::size_t i) { ones[i] = 1; });
                sums[number] = std::accumulate(ones.begin(), ones.end(), 0);
            });
        });
    }
    tasks.wait();
    QCOMPARE(std::count(sums.begin(), sums.end(), 1000), 20);
    tasks.wait(); // without tasks
    tasks.run([&] { sums[0] = 1; });
    tasks.wait();
    QCOMPARE(sums[0], 1);
}

void ParallelTest::tasks_oneThrows_othersFinish() {
    Tasks tasks;
    std::atomic<int> begun = 0, ended = 0;
    for (int task = 0; task < 50; ++task) {
        tasks.run([&, task] {
            if (task == 10) {
                throw std::runtime_error("ten");
            }
            ++begun;
            std::atomic<int> loops = 0;
            parallelFor(0, 10'000, [&](int) { ++loops; });
            ended += loops == 10'000 ? 1 : 0;
        });
    }
    QVERIFY_EXCEPTION_THROWN(tasks.wait(), std::runtime_error);
    QCOMPARE(int(ended), int(begun));
    tasks.wait(); // the exception is thrown only once
}

void ParallelTest::tasks_destroyedWithoutWait_finish() {
    std::atomic<int> begun = 0, ended = 0;
    {
        Tasks tasks;
        for (int task = 0; task < 50; ++task) {
            tasks.run([&] {
                ++begun;
                parallelFor(0, 1000, [](int) {});
                ++ended;
            });
        }
    }
    QCOMPARE(int(ended), int(begun));
}

// Exceptions may be thrown on any thread. They are deleted on this one.
void ParallelTest::tasks_destroyedAfterException_deletesIt() {
    static std::atomic<int> made = 0, gone = 0;
    struct Failure {
        Failure() { ++made; }
        Failure(const Failure&) { ++made; }
        ~Failure() { ++gone; }
    };
    for (int group = 0; group < 200; ++group) {
        std::atomic<bool> isThrown = false;
        Tasks tasks;
        tasks.run([&] {
            isThrown = true;
            throw Failure();
        });
        while (!isThrown) {
            std::this_thread::yield();
        }
    }
    QVERIFY(made >= 200);
    QCOMPARE(int(gone), int(made));
}

void ParallelTest::runIsolated_loop_runsNoOtherTask() {
    const auto here = std::this_thread::get_id();
    bool isUndisturbed = false;
    std::atomic<int> disturbances = 0;
    Tasks tasks;
    for (int task = 0; task < 200; ++task) {
        tasks.run([&] {
            if (std::this_thread::get_id() == here && isUndisturbed) {
                ++disturbances;
            }
        });
    }
    runIsolated([&] {
        isUndisturbed = true;
        parallelFor(0, 10'000, [](int) {});
        isUndisturbed = false;
    });
    tasks.wait();
    QCOMPARE(int(disturbances), 0);
}

void ParallelTest::threadLimit_inScope_limitsTheThreads() {
    const auto mostAtOnce = [] {
        std::atomic<int> now = 0, most = 0;
        parallelFor(0, 1000, [&](int) {
            const int together = ++now;
            int before = most;
            while (before < together && !most.compare_exchange_weak(before, together)) {
            }
            --now;
        });
        return int(most);
    };
    {
        const ThreadLimit limit(1);
        QCOMPARE(mostAtOnce(), 1);
    }
    const ThreadLimit none(0);
    QVERIFY(mostAtOnce() <= coreCount());
}

void ParallelTest::threadTeam_run_finishesBeforeItReturns() {
    ThreadTeam team(2);
    std::vector<int> squares(1000);
    int threads = 0;
    team.run([&] {
        threads = loopThreads();
        parallelFor(0, 1000, [&](int index) { squares[std::size_t(index)] = index * index; });
    });
    QCOMPARE(threads, 2);
    QCOMPARE(squares.back(), 998'001);
}

void ParallelTest::threadTeam_exception_reachesTheCaller() {
    ThreadTeam team(1);
    QVERIFY_EXCEPTION_THROWN(team.run([] { throw std::runtime_error("work"); }),
                             std::runtime_error);
}

// Each loop reads what the other threads wrote in the loop before.
void ParallelTest::threadTeam_manyShortLoops_seeEachOthersResults() {
    constexpr std::size_t places = 8;
    constexpr int loops = 5000;
    std::vector<int> now(places, 0), next(places, 0);
    ThreadTeam team(4);
    team.run([&] {
        for (int loop = 0; loop < loops; ++loop) {
            parallelForEvenly(std::size_t(0), places, [&](std::size_t place) {
                next[place] = now[(place + places / 2 + 1) % places] + 1;
            });
            now.swap(next);
            if (loop % 1000 == 0) { // long enough for helpers to leave
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
            }
        }
    });
    QCOMPARE(now, std::vector<int>(places, loops));
}

void ParallelTest::threadTeam_loopsOfAllLengths_visitEveryIndexOnce() {
    ThreadTeam team(3);
    team.run([&] {
        for (const int length : {1, 2, 3, 4, 7, 255, 256, 257, 1000}) {
            std::vector<int> visits(static_cast<std::size_t>(length));
            const auto visit = [&](int index) { ++visits[std::size_t(index - 5)]; };
            parallelForEvenly(5, 5 + length, visit);
            parallelFor(5, 5 + length, visit);
            parallelForPieces(5, 5 + length, 16, [&](int first, int last) {
                for (int index = first; index < last; ++index) {
                    visit(index);
                }
            });
            QCOMPARE(visits, std::vector<int>(visits.size(), 3));
        }
    });
}

void ParallelTest::threadTeam_nestedLoop_computesAll() {
    std::atomic<int> calls = 0;
    ThreadTeam team(2);
    team.run([&] {
        parallelForEvenly(0, 20, [&](int) {
            parallelFor(0, 100, [&](int) { ++calls; });
            ThreadTeam(2).run([&] { parallelForEvenly(0, 10, [&](int) { ++calls; }); });
        });
    });
    QCOMPARE(int(calls), 20 * 110);
}

void ParallelTest::threadTeam_exceptionInALoop_reachesTheCaller() {
    ThreadTeam team(2);
    std::atomic<int> calls = 0;
    team.run([&] {
        for (int loop = 0; loop < 100; ++loop) {
            QVERIFY_EXCEPTION_THROWN(parallelForEvenly(0, 2,
                                                       [&](int index) {
                                                           if (index == loop % 2) {
                                                               throw std::runtime_error("loop");
                                                           }
                                                       }),
                                     std::runtime_error);
            parallelForEvenly(0, 2, [&](int) { ++calls; });
        }
    });
    QCOMPARE(int(calls), 200);
}

QTEST_APPLESS_MAIN(ParallelTest)
#include "ParallelTest.moc"
