// Tests two kinds of simulated ink on a ball, on film that stretches up to the ball's rim.
// Compensation by a law that was fitted to a step wedge must show the wanted grey.
#include "DippedByHand.h"
#include "base/Error.h"
#include "base/Units.h"
#include "geometry/Shapes.h"
#include "settings/InkTones.h"
#include "texture/Ink.h"
#include "texture/LinearLight.h"
#include "texture/ReverseTexture.h"
#include "texture/WedgeTable.h"

#include <QtTest>

#include <cmath>
#include <functional>
#include <random>

using namespace dipwright;

namespace {

double lightness(double light) {
    return light > 0.008856 ? 116 * std::cbrt(light) - 16 : 903.3 * light;
}
double density(double light) {
    return -std::log10(light);
}

// Returns the light of ink on film with the area stretch J, if the ink has `light` on unstretched
// film.
using InkOnFilm = std::function<double(double light, double stretch)>;

double dye(double light, double stretch) {
    return std::pow(light, 1 / stretch);
}
// Returns the ink law of dots of the density `solid`, which cover a share of the film and stretch
// with the film.
InkOnFilm dots(double solid) {
    return [solid](double light, double stretch) {
        const double covered = (1 - light) / (1 - std::pow(10, -solid));
        return 1 - covered * (1 - std::pow(10, -solid / stretch));
    };
}

// Returns the readings of a wedge of three inks, with `noise` as standard deviation.
std::vector<WedgeReading> wedge(const InkOnFilm& ink, double solid, double noise = 0) {
    std::mt19937 random(7);
    std::normal_distribution<double> off(0, noise > 0 ? noise : 1);
    const auto read = [&](double value) { return value + (noise > 0 ? off(random) : 0); };
    std::vector<WedgeReading> readings;
    for (const FilmInk kind : {FilmInk::Cyan, FilmInk::Magenta, FilmInk::Yellow}) {
        for (const double tone :
             {0.05, 0.1, 0.2, 0.3, 0.45, 0.6, 0.75, 0.9, 1.05, 1.2, 1.35, 1.5, 1.75, 2.0}) {
            for (const double stretch : {1.3, 1.7, 2.3, 3.0}) {
                if (tone <= solid) {
                    readings.push_back({kind, tone, read(tone), stretch,
                                        read(density(ink(std::pow(10, -tone), stretch)))});
                }
            }
        }
    }
    return readings;
}

// The ball's radius in mm. Film from the distance R lies at the polar angle R/ρ + (R/ρ)³/3. At its
// end the film's area is doubled.
constexpr double radius = 35;
constexpr double rim = 100 * pi / 180;
double polarAngle(double distance) {
    const double share = distance / radius;
    return share + share * share * share / 3;
}
double filmDistance(double angle) {
    double distance = angle * radius;
    for (int step = 0; step < 50; ++step) {
        const double share = distance / radius;
        distance -= radius * (polarAngle(distance) - angle) / (1 + share * share);
    }
    return distance;
}
double areaStretch(double distance) {
    const double share = distance / radius;
    return std::sin(polarAngle(distance)) / share * (1 + share * share);
}

// Returns a ramp from white in the middle to 1/16 of the light at the left and right edges.
QImage ramp() {
    QImage picture(1024, 8, QImage::Format_RGBA8888);
    for (int column = 0; column < picture.width(); ++column) {
        const int grey = 255 - std::abs(column - 512) * 180 / 512;
        for (int row = 0; row < picture.height(); ++row) {
            picture.setPixelColor(column, row, QColor(grey, grey, grey));
        }
    }
    return picture;
}

// The error of the lightness where the film paints, except where the ink limit applies.
struct Shown {
    double worst = 0, worstAtRim = 0; // L*
    int places = 0, atRim = 0;
};
Shown shown(const InkOnFilm& ink, const InkSettings& settings) {
    const TexturedMesh model = test::globe(radius, 90, 180, ramp());
    const auto laid =
        test::laid(model.mesh, test::onSphere(test::a4Grid(), radius, rim, polarAngle));
    ReverseTextureOptions options;
    options.pixels = {1050, 1485}; // five per mm
    options.bleed = 0;
    options.ink = settings;
    const QImage sheet = reverseTexture(*laid, model, options, Progress{}).image;
    ReverseTextureOptions plain = options;
    plain.ink.compensate = false;
    const QImage wanted = reverseTexture(*laid, model, plain, Progress{}).image;
    const double darkest = std::pow(10, -settings.limit) * 1.05;
    Shown result;
    for (int row = 0; row < sheet.height(); ++row) {
        for (int column = 0; column < sheet.width(); ++column) {
            const uchar* printed = sheet.constScanLine(row) + 4 * column;
            const double light = double(linearTable()[printed[1]]);
            const double distance = std::hypot((column + 0.5) / 5 - 105, (row + 0.5) / 5 - 148.5);
            if (printed[3] == 0 || light < darkest || distance < 1) {
                continue;
            }
            const double stretch = areaStretch(distance);
            const double asked = double(linearTable()[(wanted.constScanLine(row) + 4 * column)[1]]);
            const double off = std::abs(lightness(ink(light, stretch)) - lightness(asked));
            const bool isAtRim = distance > filmDistance(rim) - 2.5;
            result.worst = std::max(result.worst, off);
            result.worstAtRim = std::max(result.worstAtRim, isAtRim ? off : 0);
            ++result.places;
            result.atRim += isAtRim ? 1 : 0;
        }
    }
    return result;
}

} // namespace

class StretchedInkTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void inkCompensation_measuredInk_showsTheWantedGrey_data();
    void inkCompensation_measuredInk_showsTheWantedGrey();
    void inkCompensation_shown_invertsPrint_data();
    void inkCompensation_shown_invertsPrint();
    void fitInk_dye_hasExponent1();
    void fitInk_noise_isReportedAsWorst();
    void fitInk_impossibleReadings_areRefused_data();
    void fitInk_impossibleReadings_areRefused();
    void readWedge_table_isRead();
    void readWedge_wrongReading_isRefusedByLine();
    void readWedge_faultyTable_isRefused_data();
    void readWedge_faultyTable_isRefused();
    void inkTonesText_readAgain_givesTheSameTones();
    void inkTones_invalidText_isRefused_data();
    void inkTones_invalidText_isRefused();
};

void StretchedInkTest::inkCompensation_measuredInk_showsTheWantedGrey_data() {
    QTest::addColumn<InkOnFilm>("ink");
    QTest::addColumn<double>("solid");
    QTest::newRow("dye") << InkOnFilm(dye) << 2.0;
    QTest::newRow("dots of 1.2") << dots(1.21) << 1.2;
    QTest::newRow("dots of 1.5") << dots(1.51) << 1.5;
    QTest::newRow("dots of 2") << dots(2.01) << 2.0;
}

void StretchedInkTest::inkCompensation_measuredInk_showsTheWantedGrey() {
    QFETCH(const InkOnFilm, ink);
    QFETCH(const double, solid);
    InkSettings settings;
    settings.limit = solid;
    settings.law = fitInk(wedge(ink, solid), {}).law;
    const Shown grey = shown(ink, settings);
    QVERIFY(grey.places > 100'000);
    QVERIFY(grey.atRim > 5'000);
    const QString figures = QStringLiteral("largest error %1 L*, at the rim %2 L*")
                                .arg(grey.worst)
                                .arg(grey.worstAtRim);
    qInfo("%s", qPrintable(figures));
    QVERIFY2(grey.worst <= 1, qPrintable(figures));
}

void StretchedInkTest::inkCompensation_shown_invertsPrint_data() {
    inkCompensation_measuredInk_showsTheWantedGrey_data();
}

void StretchedInkTest::inkCompensation_shown_invertsPrint() {
    QFETCH(const InkOnFilm, ink);
    QFETCH(const double, solid);
    InkSettings settings;
    settings.limit = 3;
    settings.law = fitInk(wedge(ink, solid), {}).law;
    const InkCompensation compensation(settings);
    for (const float light : {1.0f, 0.97f, 0.8f, 0.5f, 0.3f, 0.1f, 0.05f}) {
        for (const float stretch : {0.7f, 1.0f, 1.2f, 2.0f, 3.5f}) {
            const auto printed = compensation.print(LinearColour::Constant(light), stretch);
            const LinearColour back = compensation.shown(printed.colour, stretch);
            if (!printed.fallsShort && printed.colour[0] > 0.0011f) {
                QVERIFY2(std::abs(back[0] - light) < 1e-4f,
                         qPrintable(QStringLiteral("light %1 at stretch %2: %3 shown")
                                        .arg(double(light))
                                        .arg(double(stretch))
                                        .arg(double(back[0]))));
            }
        }
    }
    QCOMPARE(compensation.print(LinearColour::Ones(), 2).colour[0], 1.0f);
}

// A dye's exponent is 1 at every tone, which is also the default without measurement.
void StretchedInkTest::fitInk_dye_hasExponent1() {
    const FittedInk fitted = fitInk(wedge(dye, 2), {});
    QCOMPARE(fitted.patches, 42);
    for (const InkTone& tone : fitted.law.tones) {
        QVERIFY(std::abs(tone.exponent - 1) < 1e-6);
        QVERIFY(std::abs(tone.bend) < 1e-6);
    }
    const Shown guessed = shown(dye, InkSettings{});
    QVERIFY2(
        guessed.worst <= 1,
        qPrintable(QStringLiteral("largest error %1 L*, expected 1 or less").arg(guessed.worst)));
    // For dots this default is wrong.
    InkSettings unmeasured;
    unmeasured.limit = 1.5;
    const Shown wrong = shown(dots(1.51), unmeasured);
    qInfo("dots by a dye's law: %g L*", wrong.worst);
    QVERIFY(wrong.worst > 3);
    // Opaque dots need no more ink on stretched film.
    InkSettings opaque;
    opaque.law.exponents = {0, 0, 0};
    QCOMPARE(InkCompensation(opaque).print(LinearColour::Constant(0.3f), 2).colour[0], 0.3f);
}

void StretchedInkTest::fitInk_noise_isReportedAsWorst() {
    QVERIFY(fitInk(wedge(dots(1.51), 1.5), {}).worst < 0.01);
    const FittedInk noisy = fitInk(wedge(dots(1.51), 1.5, 0.005), {});
    QVERIFY(noisy.worst > 0.003 && noisy.worst < 0.03);
}

void StretchedInkTest::fitInk_impossibleReadings_areRefused_data() {
    QTest::addColumn<QList<double>>("reading"); // nominal, flat, stretch, shown
    QTest::newRow("not stretched") << QList<double>{1, 1, 1, 1};
    QTest::newRow("no density") << QList<double>{1, 1, 2, 0};
    QTest::newRow("not a number") << QList<double>{1, 1, 2, std::nan("")};
    QTest::newRow("infinite") << QList<double>{1, 1, std::numeric_limits<double>::infinity(), 0.5};
    QTest::newRow("denser when stretched") << QList<double>{1, 1, 1.3, 1.3};
    QTest::newRow("much denser when stretched") << QList<double>{0.3, 0.1, 1.3, 2};
    QTest::newRow("much paler than the dye law") << QList<double>{0.3, 2, 1.3, 0.01};
}

void StretchedInkTest::fitInk_impossibleReadings_areRefused() {
    QFETCH(const QList<double>, reading);
    const WedgeReading wrong{FilmInk::Cyan, reading[0], reading[1], reading[2], reading[3]};
    QVERIFY_EXCEPTION_THROWN(fitInk(std::vector{wrong}, {}), Error);
    QVERIFY_EXCEPTION_THROWN(fitInk({}, {}), Error);
    // By these readings, more ink would show a paler colour.
    const std::vector<WedgeReading> crossing{{FilmInk::Cyan, 1, 1, 3, 0.9},
                                             {FilmInk::Cyan, 1.1, 1.1, 3, 0.4}};
    QVERIFY_EXCEPTION_THROWN(fitInk(crossing, {}), Error);
}

void StretchedInkTest::readWedge_table_isRead() {
    const QByteArray head = "ink,nominal,flat,across,down,shown\n";
    const std::vector<WedgeReading> readings =
        readWedge(head + "magenta,0.3,0.31,120,150,0.2\n\ngrey,1,1.02, 150 ,140,0.6\r\n", "w.csv");
    QCOMPARE(readings.size(), std::size_t(4));
    QCOMPARE(readings[0].ink, FilmInk::Magenta);
    QCOMPARE(readings[0].nominal, 0.3);
    QCOMPARE(readings[0].flat, 0.31);
    QCOMPARE(readings[0].stretch, 1.8); // 1.2 across and 1.5 down
    QCOMPARE(readings[0].shown, 0.2);
    QCOMPARE(readings[3].ink, FilmInk::Yellow);
    QCOMPARE(readings[3].stretch, 2.1);
    // Rows of the blank table that are not filled in are ignored.
    const QByteArray blank = blankWedge({{FilmInk::Cyan, 5}, {FilmInk::Black, 2}}, 4);
    QVERIFY(readWedge(blank, "w.csv").empty());
    QCOMPARE(blank.count('\n'), 1 + (5 + 2) * 4);
    QVERIFY(!blank.contains("black,0.2,")); // the third tone of a row with two patches
}

void StretchedInkTest::readWedge_wrongReading_isRefusedByLine() {
    const QByteArray table = "ink,nominal,flat,across,down,shown\ncyan,1,1,120,120,0.8\n\n"
                             "cyan,1,-1,120,120,0.8\n";
    try {
        fitInk(readWedge(table, "w.csv"), "w.csv");
        QFAIL("the reading was accepted, expected a refusal");
    } catch (const Error& error) {
        QCOMPARE(error.where(), QStringLiteral("w.csv, line 4"));
    }
}

void StretchedInkTest::readWedge_faultyTable_isRefused_data() {
    QTest::addColumn<QByteArray>("table");
    const QByteArray head = "ink,nominal,flat,across,down,shown\n";
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("another's head") << QByteArray("a,b\n1,2\n");
    QTest::newRow("no ink") << head + "green,1,1,120,120,0.5\n";
    QTest::newRow("one number missing") << head + "cyan,1,1,120,0.5\n";
    QTest::newRow("a word") << head + "cyan,1,1,120,wide,0.5\n";
    QTest::newRow("not a number") << head + "cyan,1,1,120,nan,0.5\n";
    QTest::newRow("endless") << head + QByteArray(20'000, '\n');
}

void StretchedInkTest::readWedge_faultyTable_isRefused() {
    QFETCH(const QByteArray, table);
    QVERIFY_EXCEPTION_THROWN(readWedge(table, "w.csv"), Error);
}

void StretchedInkTest::inkTonesText_readAgain_givesTheSameTones() {
    const std::vector<InkTone> tones = fitInk(wedge(dots(1.51), 1.5, 0.002), {}).law.tones;
    QVERIFY(inkTones(inkTonesText(tones), {}) == tones);
    QVERIFY(inkTones({}, {}).empty());
}

void StretchedInkTest::inkTones_invalidText_isRefused_data() {
    QTest::addColumn<QString>("text");
    for (const char* text :
         {"cyan", "cyan 0.3 0.5 0.1", "blue 0.3 0.5 0.1 2", "grey 0.3 0.5 0.1 2",
          "cyan 0.3 0.5 0.1 nan", "cyan 0.3 0.5 0.1 1e9", "cyan 0 0.5 0.1 2", "cyan 0.3 9 0.1 2",
          "cyan 0.3 0.5 0.1 2;", "cyan 0.3 0.5 0 2; cyan 0.3 0.5 0 2",
          "yellow 0.3 0.5 0 2; cyan 0.3 0.5 0 2", "cyan 0.3 0 0 4; cyan 0.4 2 0 4"}) {
        QTest::newRow(text) << QString::fromLatin1(text);
    }
}

void StretchedInkTest::inkTones_invalidText_isRefused() {
    QFETCH(const QString, text);
    QVERIFY_EXCEPTION_THROWN(inkTones(text, "ink.tones"), Error);
}

QTEST_MAIN(StretchedInkTest)
#include "StretchedInkTest.moc"
