// The positions of a graded film's lines.
#include "film/FilmLines.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace dipwright;

namespace {

std::vector<double> spacings(const std::vector<double>& lines) {
    std::vector<double> result;
    for (std::size_t line = 1; line < lines.size(); ++line) {
        result.push_back(lines[line] - lines[line - 1]);
    }
    return result;
}

} // namespace

class FilmLinesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void gradedLines_areFineUnderTheBodyAndCoarseAtTheEdges_data();
    void gradedLines_areFineUnderTheBodyAndCoarseAtTheEdges();
    void gradedLines_filmNoLargerThanTheBody_areEven();
    void gradedLines_halved_keepEverySecondLine();
    void gradedLines_smallFilm_keepTheFewestLines();
};

void FilmLinesTest::gradedLines_areFineUnderTheBodyAndCoarseAtTheEdges_data() {
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("to");
    QTest::addColumn<double>("cell");
    QTest::newRow("in the middle") << -30.0 << 30.0 << 0.75;
    QTest::newRow("off to a side") << -80.0 << -50.0 << 0.6;
    QTest::newRow("past the edge") << 70.0 << 140.0 << 1.1;
    QTest::newRow("coarse") << -30.0 << 30.0 << 4.0;
}

void FilmLinesTest::gradedLines_areFineUnderTheBodyAndCoarseAtTheEdges() {
    QFETCH(double, from);
    QFETCH(double, to);
    QFETCH(double, cell);
    const std::vector<double> lines = gradedLines(210, from, to, cell, 1, 8);
    const std::vector<double> cells = spacings(lines);
    QCOMPARE(lines.front(), -105.0);
    QCOMPARE(lines.back(), 105.0);
    QCOMPARE(cells.size() % 2, std::size_t(0));
    for (std::size_t number = 0; number < cells.size(); ++number) {
        const double middle = (lines[number] + lines[number + 1]) / 2;
        QVERIFY(cells[number] > 0 && cells[number] <= coarsestCell * cell * (1 + 1e-9));
        if (middle > from && middle < to) {
            QVERIFY(cells[number] <= cell * mostCellGrowth);
            QVERIFY(cells[number] > 0.9 * cell);
        }
        if (number > 0) {
            const double growth = cells[number] / cells[number - 1];
            QVERIFY(std::max(growth, 1 / growth) < mostCellGrowth * (1 + 1e-9));
        }
    }
    QVERIFY(cells.size() < 210 / cell);
}

void FilmLinesTest::gradedLines_filmNoLargerThanTheBody_areEven() {
    const std::vector<double> cells = spacings(gradedLines(100, -60, 60, 2.5, 1, 8));
    QCOMPARE(cells.size(), std::size_t(40));
    for (const double cell : cells) {
        QVERIFY(std::abs(cell - 2.5) < 1e-12);
    }
}

void FilmLinesTest::gradedLines_halved_keepEverySecondLine() {
    const std::vector<double> own = gradedLines(297, -40, 55, 0.8, 1, 8);
    const std::vector<double> half = gradedLines(297, -40, 55, 0.8, 0.5, 8);
    const std::vector<double> twice = gradedLines(297, -40, 55, 0.8, 2, 8);
    QCOMPARE(half.size(), own.size() / 2 + 1);
    QCOMPARE(twice.size(), own.size() * 2 - 1);
    for (std::size_t line = 0; line < own.size(); ++line) {
        QVERIFY(std::abs(twice[2 * line] - own[line]) < 1e-9);
        if (line % 2 == 0) {
            QVERIFY(std::abs(half[line / 2] - own[line]) < 1e-9);
        }
    }
}

void FilmLinesTest::gradedLines_smallFilm_keepTheFewestLines() {
    QCOMPARE(gradedLines(10, -5, 5, 20, 1, 8).size(), std::size_t(8));
}

QTEST_APPLESS_MAIN(FilmLinesTest)
#include "FilmLinesTest.moc"
