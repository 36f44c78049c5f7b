// Tests that bands of rows do their work once and in a valid order on several threads.

#include "common/cpu/RowParallel.h"

#include <QTest>
#include <algorithm>
#include <atomic>
#include <vector>

using namespace dipwright;
using namespace dipwright::cpu;

class RowParallelTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void forRowStages_visitsEachStageOnceAfterItsNeighbours_data();
    void forRowStages_visitsEachStageOnceAfterItsNeighbours();
};

void RowParallelTest::forRowStages_visitsEachStageOnceAfterItsNeighbours_data() {
    QTest::addColumn<int>("rows");
    QTest::addColumn<int>("columns");
    for (const int rows : {1, 7, 16, 23, 24, 32, 33, 100, 401}) {
        for (const int columns : {20, 300}) {
            QTest::addRow("%d x %d", columns, rows) << rows << columns;
        }
    }
}

void RowParallelTest::forRowStages_visitsEachStageOnceAfterItsNeighbours() {
    QFETCH(int, rows);
    QFETCH(int, columns);
    constexpr int stages = 4;
    ThreadTeam team(4);
    for (int repetition = 0; repetition < 20; ++repetition) {
        std::vector<std::atomic<int>> visits(std::size_t(stages * rows));
        const auto at = [&](int stage, int row) -> std::atomic<int>& {
            return visits[std::size_t(stage * rows + row)];
        };
        std::atomic<int> early = 0;
        team.run([&] {
            forRowStages<stages>(rows, columns, [&](int stage, int row) {
                const int first = std::max(row - 1, 0), last = std::min(row + 1, rows - 1);
                for (int near = first; stage > 0 && near <= last; ++near) {
                    early += at(stage - 1, near) != 1;
                }
                ++at(stage, row);
            });
        });
        QVERIFY(early == 0);
        QVERIFY(std::ranges::all_of(visits, [](const auto& count) { return count == 1; }));
    }
}

QTEST_GUILESS_MAIN(RowParallelTest)
#include "RowParallelTest.moc"
