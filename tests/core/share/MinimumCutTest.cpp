// Tests that the labels have the least cost, compared with all possible labels.
#include "share/MinimumCut.h"

#include <QtTest>

#include <random>

using namespace dipwright;

namespace {

double costOf(const std::vector<std::uint8_t>& labels,
              const std::vector<std::array<double, 2>>& costs, const std::vector<CutEdge>& edges) {
    double sum = 0;
    for (std::size_t item = 0; item < labels.size(); ++item) {
        sum += costs[item][labels[item]];
    }
    for (const CutEdge& edge : edges) {
        sum += labels[edge.from] != labels[edge.to] ? edge.cost : 0;
    }
    return sum;
}

double leastCost(const std::vector<std::array<double, 2>>& costs,
                 const std::vector<CutEdge>& edges) {
    double least = std::numeric_limits<double>::infinity();
    for (unsigned number = 0; number < 1u << costs.size(); ++number) {
        std::vector<std::uint8_t> labels;
        for (std::size_t item = 0; item < costs.size(); ++item) {
            labels.push_back(std::uint8_t(number >> item & 1));
        }
        least = std::min(least, costOf(labels, costs, edges));
    }
    return least;
}

} // namespace

class MinimumCutTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void minimumCut_randomGraphs_haveTheLeastCost();
    void minimumCut_expensiveEdges_areNotCut();
};

void MinimumCutTest::minimumCut_randomGraphs_haveTheLeastCost() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(0, 10);
    for (int round = 0; round < 50; ++round) {
        std::vector<std::array<double, 2>> costs(9);
        std::vector<CutEdge> edges;
        for (std::uint32_t item = 0; item < costs.size(); ++item) {
            costs[item] = {any(random), any(random)};
            for (std::uint32_t other = 0; other < item; ++other) {
                if (any(random) < 4) {
                    edges.push_back({item, other, any(random) / 3});
                }
            }
        }
        const double cost = costOf(minimumCut(costs, edges), costs, edges);
        const double least = leastCost(costs, edges);
        QVERIFY2(std::abs(cost - least) < 1e-2,
                 qPrintable(QStringLiteral("cost %1, least cost %2").arg(cost).arg(least)));
    }
}

void MinimumCutTest::minimumCut_expensiveEdges_areNotCut() {
    const std::vector<std::array<double, 2>> costs{{0, 9}, {1, 0}, {1, 0}, {9, 0}};
    const std::vector<CutEdge> edges{{0, 1, 5}, {1, 2, 5}, {2, 3, 1}};
    QCOMPARE(minimumCut(costs, edges), (std::vector<std::uint8_t>{0, 0, 0, 1}));
}

QTEST_APPLESS_MAIN(MinimumCutTest)
#include "MinimumCutTest.moc"
