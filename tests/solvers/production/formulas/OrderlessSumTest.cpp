// Tests that the sums depend neither on the order of their terms nor on how threads divide them,
// and that they are precise.

#include "production/formulas/OrderlessSum.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace dipwright::numerics;

namespace {

std::vector<double> randomTerms(float from, float to) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> number(from, to);
    std::vector<double> terms(60'000);
    std::ranges::generate(terms, [&] { return double(number(random)); });
    return terms;
}

SquareSum squareSum(const std::vector<double>& terms) {
    SquareSum sum;
    for (const double term : terms) {
        sum.add(term);
    }
    return sum;
}

std::int64_t products(const std::vector<double>& terms) {
    std::int64_t sum = 0;
    for (const double term : terms) {
        sum += ProductSum::multiple(term);
    }
    return sum;
}

} // namespace

class OrderlessSumTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void sums_otherOrder_giveTheSameBits();
    void productSum_isPrecise();
    void squareSum_smallAndLargeTerms_isPrecise();
    void squareSum_equalTerms_isExact();
    void productSum_termsOutOfRange_countAsZero();
    void squareSum_inParts_givesTheSameBits();
    void squareSum_termsOutOfRange_isNotANumber();
};

void OrderlessSumTest::sums_otherOrder_giveTheSameBits() {
    std::vector<double> terms = randomTerms(-1, 1);
    std::vector<double> squares = randomTerms(0, 1);
    const std::int64_t product = products(terms);
    const double root = squareSum(squares).root();
    std::mt19937 random(4);
    for (int i = 0; i < 5; ++i) {
        std::ranges::shuffle(terms, random);
        std::ranges::shuffle(squares, random);
        QVERIFY(products(terms) == product);
        QVERIFY(squareSum(squares).root() == root);
    }
}

void OrderlessSumTest::productSum_isPrecise() {
    const std::vector<double> terms = randomTerms(-1, 1);
    long double exact = 0;
    for (const double term : terms) {
        exact += term;
    }
    QVERIFY(std::abs(ProductSum::value(products(terms)) - double(exact)) < 1e-8);
    QVERIFY(ProductSum::value(ProductSum::multiple(-0.75)) == -0.75);
}

void OrderlessSumTest::squareSum_smallAndLargeTerms_isPrecise() {
    for (const float size : {1e-12f, 1e-6f, 1.f, 1e4f}) {
        const std::vector<double> terms = randomTerms(0, size);
        long double exact = 0;
        for (const double term : terms) {
            exact += term;
        }
        QVERIFY(std::abs(squareSum(terms).root() / double(std::sqrt(exact)) - 1) < 1e-6);
    }
}

// The rests of equal terms all have the same sign, so their sum is the largest possible.
void OrderlessSumTest::squareSum_equalTerms_isExact() {
    for (const double term : {0.25, 0.5 - 0x1p-25, 0x1p-11, 3 * 0x1p-11, 4 + 0x1p-11}) {
        const double root = squareSum(std::vector<double>(60'000, term)).root();
        QVERIFY(root == std::sqrt(60'000 * term));
    }
}

void OrderlessSumTest::productSum_termsOutOfRange_countAsZero() {
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double bad : {ProductSum::limit, 1e300, infinite, -infinite,
                             std::numeric_limits<double>::quiet_NaN()}) {
        QVERIFY(ProductSum::multiple(bad) == 0);
        QVERIFY(ProductSum::multiple(-bad) == 0);
    }
    QVERIFY(ProductSum::value(ProductSum::multiple(-65535.5)) == -65535.5);
}

void OrderlessSumTest::squareSum_inParts_givesTheSameBits() {
    const std::vector<double> terms = randomTerms(0, 3);
    SquareSum parts[3];
    for (std::size_t i = 0; i < terms.size(); ++i) {
        parts[i * i % 3].add(terms[i]);
    }
    parts[2].add(parts[0]);
    parts[2].add(parts[1]);
    QVERIFY(parts[2].root() == squareSum(terms).root());
}

void OrderlessSumTest::squareSum_termsOutOfRange_isNotANumber() {
    for (const double bad : {1e13, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
        QVERIFY(std::isnan(squareSum({1, bad, 2}).root()));
        QVERIFY(std::isnan(squareSum(std::vector<double>(60'000, bad)).root()));
    }
}

QTEST_GUILESS_MAIN(OrderlessSumTest)
#include "OrderlessSumTest.moc"
