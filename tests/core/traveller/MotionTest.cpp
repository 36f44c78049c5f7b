// Tests the motion of a dip, as points in time and as a filled template.
#include "traveller/Motion.h"

#include "base/Error.h"

#include <QtTest>
#include <cmath>

using namespace dipwright;

namespace {

DipMotion motion() {
    DipMotion result;
    result.project = QStringLiteral("Cup (red);\nM112");
    result.immersion = QStringLiteral("Below");
    result.job = QStringLiteral("0a1b2c3d4e5f");
    result.depth = Millimetres(42);
    result.speed = MillimetresPerSecond(4);
    return result;
}

} // namespace

class MotionTest : public QObject {
    Q_OBJECT

private slots:
    // The motion is 49.5 mm at 20 mm/s, 42.5 mm at 4 mm/s, a hold of 5 s, and 92 mm at 4 mm/s.
    void motionCsv_hasDepthsAndTimes() {
        QCOMPARE(motionCsv(motion()), QByteArray("time_s,height_mm,speed_mm_s\n"
                                                 "0.000,50.000,0.000\n"
                                                 "2.475,0.500,20.000\n"
                                                 "13.100,-42.000,4.000\n"
                                                 "18.100,-42.000,0.000\n"
                                                 "41.100,50.000,4.000\n"));
    }

    void filledTemplate_shippedTemplate_hasTheExpectedCommands() {
        const MotionTemplate shipped = standardMotionTemplate({});
        const QString code =
            QString::fromUtf8(filledTemplate(motion(), shipped.text, shipped.where));
        QVERIFY(!code.contains(u'{'));
        QVERIFY(code.contains(QStringLiteral("0a1b2c3d4e5f")));
        // The commands without comments.
        QStringList commands;
        for (const QString& line : code.split(u'\n')) {
            const QString command = line.section(u';', 0, 0).trimmed();
            if (!command.isEmpty()) {
                commands << command;
            }
        }
        QCOMPARE(commands,
                 QStringList({"G21", "G90", "G1 Z50.000 F1200.000", "M0", "G1 Z0.500 F1200.000",
                              "G1 Z-42.000 F240.000", "G1 Z-42.125 F3.000", "G1 Z-42.000 F3.000",
                              "M0", "G1 Z50.000 F240.000", "M2"}));
    }

    // Some controllers take a dwell in ms, others in s. The hold therefore consists of moves that
    // take the same time.
    void filledTemplate_hold_lastsAsLongOnEveryController() {
        const MotionTemplate shipped = standardMotionTemplate({});
        const QString code =
            QString::fromUtf8(filledTemplate(motion(), shipped.text, shipped.where));
        double height = 0, minutes = 0; // height in mm; time at the dip's depth
        for (const QString& line : code.split(u'\n')) {
            const QString command = line.section(u';', 0, 0).trimmed();
            QVERIFY2(!command.startsWith(QStringLiteral("G4")), qPrintable(command));
            static const QRegularExpression move(QStringLiteral("^G1 Z([-0-9.]+) F([0-9.]+)$"));
            if (const auto match = move.match(command); match.hasMatch()) {
                const double next = match.captured(1).toDouble();
                if (height <= -motion().depth.value() && next <= -motion().depth.value()) {
                    minutes += std::abs(next - height) / match.captured(2).toDouble();
                }
                height = next;
            }
        }
        QVERIFY2(std::abs(60 * minutes - motion().hold.value()) < 0.05,
                 qPrintable(QStringLiteral("the hold lasts %1 s, expected %2 s")
                                .arg(60 * minutes)
                                .arg(motion().hold.value())));
        const QString header = code.section(u'\n', 0, 4);
        for (const char* dialect : {"Marlin", "GRBL", "LinuxCNC"}) {
            QVERIFY2(header.contains(QLatin1String(dialect)), dialect);
        }
    }

    void filledTemplate_projectName_cannotAddCommands() {
        const QByteArray line = filledTemplate(motion(), QStringLiteral("({project})"), {});
        QCOMPARE(line.count('\n'), 0);
        QCOMPARE(line.count('('), 1);
        QCOMPARE(line.count(')'), 1);
        QVERIFY(!line.contains(';'));
    }

    void filledTemplate_unknownName_isRefused() {
        try {
            filledTemplate(motion(), QStringLiteral("G1 Z{height}"), QStringLiteral("own.gcode"));
            QFAIL("an unknown name was accepted, expected a refusal");
        } catch (const Error& error) {
            QVERIFY(error.sentence().contains(QStringLiteral("{height}")));
            QVERIFY(error.sentence().contains(QStringLiteral("depth_mm")));
            QVERIFY(error.sentence().contains(QStringLiteral("own.gcode")));
        }
    }
};

QTEST_GUILESS_MAIN(MotionTest)
#include "MotionTest.moc"
