// Tests the motion of a dip, as points in time and as a filled template.
#include "traveller/Motion.h"

#include "base/Error.h"

#include <QMap>
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

// A part that rolls by 200° while it travels and then is levelled about another axis.
DipMotion motionOnPath() {
    DipMotion result = motion();
    const Eigen::Vector3d across = Eigen::Vector3d(1, 2, 0).normalized();
    for (int i = 0; i <= 40; ++i) {
        const double share = i / 40.0;
        result.path.push_back(
            {Seconds(12 * share),
             {-30 + 60 * share, 5 * share, 20 - 40 * share},
             Eigen::Quaterniond(Eigen::AngleAxisd(-200 * pi / 180 * (1 - share), across) *
                                Eigen::AngleAxisd(0.3 * (1 - share), Eigen::Vector3d::UnitZ()))});
    }
    return result;
}

// A controller that reads G-code: absolute millimetres and degrees, and feed by inverse time (G93)
// or per minute (G94, which is the default).
struct Controller {
    struct Stop {
        double seconds = 0;
        Eigen::Vector3d place;
        Eigen::Quaterniond turn;
    };
    std::vector<Stop> stops;

    explicit Controller(const QString& code) {
        QMap<QChar, double> axes{{u'X', 0}, {u'Y', 0}, {u'Z', 0}, {u'A', 0}, {u'B', 0}, {u'C', 0}};
        bool inInverseTime = false;
        double seconds = 0;
        for (const QString& line : code.split(u'\n')) {
            const QMap<QChar, double> before = axes;
            double feed = 0;
            bool moves = false;
            const QStringList words = line.section(u';', 0, 0).simplified().split(u' ');
            for (const QString& word : words) {
                const double number = word.mid(1).toDouble();
                if (word == QLatin1String("G93")) {
                    inInverseTime = true;
                } else if (word == QLatin1String("G94")) {
                    inInverseTime = false;
                } else if (word == QLatin1String("G1")) {
                    moves = true;
                } else if (word.startsWith(u'F')) {
                    feed = number;
                } else if (!word.isEmpty() && axes.contains(word[0])) {
                    axes[word[0]] = number;
                }
            }
            if (!moves) {
                continue;
            }
            const auto way = [&](const char* names) {
                double squares = 0;
                for (const char* name = names; *name; ++name) {
                    squares += std::pow(axes[QLatin1Char(*name)] - before[QLatin1Char(*name)], 2);
                }
                return std::sqrt(squares);
            };
            const double linear = way("XYZ");
            seconds += inInverseTime ? 60 / feed : 60 * (linear > 0 ? linear : way("ABC")) / feed;
            const auto about = [&](char name, const Eigen::Vector3d& axis) {
                return Eigen::AngleAxisd(axes[QLatin1Char(name)] * pi / 180, axis);
            };
            stops.push_back(
                {seconds,
                 {axes[u'X'], axes[u'Y'], axes[u'Z']},
                 about('C', Eigen::Vector3d::UnitZ()) * about('B', Eigen::Vector3d::UnitY()) *
                     about('A', Eigen::Vector3d::UnitX())});
        }
    }
};

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

    // Some controllers take a dwell in ms, others in s. The hold therefore consists of moves, which
    // take the same time on every controller.
    void filledTemplate_hold_lastsEquallyLongOnEveryController() {
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

    void filledTemplate_path_isReadBackFromTheGCode_data() {
        QTest::addColumn<QString>("controller");
        for (const char* name : {"linuxcnc", "grbl", "marlin"}) {
            QTest::newRow(name) << QString::fromLatin1(name);
        }
    }

    void filledTemplate_path_isReadBackFromTheGCode() {
        QFETCH(QString, controller);
        const DipMotion moved = motionOnPath();
        const MotionTemplate text = motionTemplate(controller);
        const Controller read(QString::fromUtf8(filledTemplate(moved, text.text, text.where)));
        const std::vector<MotionPose> poses = motionPoses(moved);
        if (controller == QLatin1String("grbl")) {
            for (const QString& line :
                 QString::fromUtf8(filledTemplate(moved, text.text, text.where)).split(u'\n')) {
                QVERIFY2(line.section(u';', 0, 0).size() <= 80, qPrintable(line));
            }
        }
        // The first pose is reached by two moves: up, then over the film.
        QCOMPARE(read.stops.size(), poses.size() + 1);
        for (std::size_t pose = 0; pose < poses.size(); ++pose) {
            const Controller::Stop& stop = read.stops[pose + 1];
            QVERIFY((stop.place - poses[pose].place).norm() < 0.01);
            QVERIFY(stop.turn.angularDistance(poses[pose].turn) < 0.01 * pi / 180);
            const double lasts = stop.seconds - read.stops[1].seconds;
            QVERIFY2(std::abs(lasts - poses[pose].time.value()) < 0.01,
                     qPrintable(QStringLiteral("%1 s, expected %2 s")
                                    .arg(lasts)
                                    .arg(poses[pose].time.value())));
        }
    }

    // Controllers skip moves of no length, so a wait of 3 s is a slow move down and up.
    void motionPoses_wait_isCarriedOut() {
        DipMotion waits = motion();
        const auto add = [&](double seconds, double height) {
            waits.path.push_back({Seconds(seconds), {0, 0, height}});
        };
        add(0, 0.5);
        add(2, -10);
        add(3, -10);
        add(4, -10.0002);
        add(5, -10);
        add(8, -20);
        const std::vector<MotionPose> poses = motionPoses(waits);
        const double begin = poses[1].time.value();
        QCOMPARE(poses[2].place.z(), -10.0);
        QCOMPARE(poses[3].time.value() - begin, 3.5);
        QVERIFY(poses[3].place.z() < -10.05);
        QCOMPARE(poses[4].time.value() - begin, 5.0);
        QCOMPARE(poses[4].place.z(), -10.0);
        QCOMPARE(poses[5].place.z(), -20.0);
    }

    // A part that only turns about the vertical while it goes down needs two axes.
    void filledTemplate_turnAboutTheVertical_movesTwoAxes() {
        DipMotion moved = motion();
        for (int i = 0; i <= 4; ++i) {
            moved.path.push_back(
                {Seconds(i),
                 {0, 0, 10.0 - 5 * i},
                 Eigen::Quaterniond(Eigen::AngleAxisd(0.2 * (i - 4), Eigen::Vector3d::UnitZ()))});
        }
        const MotionTemplate text = standardMotionTemplate(moved);
        const QString code = QString::fromUtf8(filledTemplate(moved, text.text, text.where));
        const QString move = code.section(QStringLiteral("G93\n"), 1).section(u'\n', 0, 0);
        QVERIFY2(move.startsWith(QStringLiteral("G1 Z10.000 C-45.837 F")), qPrintable(move));
    }

    // The template of a controller also serves a dip that goes straight down.
    void filledTemplate_straightDipForAController_movesZ() {
        const MotionTemplate text = motionTemplate(QStringLiteral("marlin"));
        const Controller read(QString::fromUtf8(filledTemplate(motion(), text.text, text.where)));
        double lowest = 0;
        for (const Controller::Stop& stop : read.stops) {
            QVERIFY(stop.place.head<2>().norm() == 0);
            lowest = std::min(lowest, stop.place.z());
        }
        // The hold is a slow move, 0.125 mm deeper.
        QVERIFY2(std::abs(lowest + 42.125) < 1e-6,
                 qPrintable(QStringLiteral("%1 mm, expected -42.125 mm").arg(lowest)));
        QCOMPARE(read.stops.back().place.z(), 50.0);
    }

    void motionCsv_path_hasPlacesAndAngles() {
        const QList<QByteArray> lines = motionCsv(motionOnPath()).split('\n');
        QCOMPARE(lines.front(), QByteArray("time_s,x_mm,y_mm,z_mm,a_deg,b_deg,c_deg"));
        QCOMPARE(lines.size(), 1 + int(motionPoses(motionOnPath()).size()) + 1);
        QVERIFY(lines[lines.size() - 2].endsWith(",0.000,0.000,0.000"));
    }

    void filledTemplate_pathWithoutMoves_isRefused() {
        const MotionTemplate straight = standardMotionTemplate({});
        QVERIFY_EXCEPTION_THROWN(filledTemplate(motionOnPath(), straight.text, {}), Error);
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
