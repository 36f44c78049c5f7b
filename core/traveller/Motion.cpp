#include "traveller/Motion.h"

#include "base/Error.h"
#include "disk/SmallFile.h"

#include <QCoreApplication>
#include <QMap>
#include <QRegularExpression>
#include <QStandardPaths>

#include <array>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Motion)
};

constexpr qint64 longestTemplate = 1 << 20; // bytes
// Slowest speed of a hold. Marlin speeds up slower moves (MINIMUM_PLANNER_SPEED); GRBL's limit is
// lower.
constexpr MillimetresPerSecond holdSpeed{0.05};

QString plain(double number) {
    const QString text = QString::number(number, 'f', 3);
    return text == QLatin1String("-0.000") ? QStringLiteral("0.000") : text;
}

// Makes a name safe inside a comment: returns one line without characters that a controller could
// interpret as the end of the comment.
QString oneLine(const QString& name) {
    QString result;
    for (const QChar letter : name.simplified()) {
        result +=
            letter.isPrint() && letter != u'(' && letter != u')' && letter != u';' ? letter : u' ';
    }
    return result.left(80);
}

QString line(const QStringList& words) {
    return words.join(u' ') + u'\n';
}

// Returns the whole motion of a path as G-code moves. `inInverseTime`: G93, else G94.
QString moves(const DipMotion& motion, bool inInverseTime) {
    if (motion.path.empty()) {
        return {};
    }
    const std::vector<MotionPose> poses = motionPoses(motion);
    const std::vector<Eigen::Vector3d> angles = motionAngles(poses);
    const auto valuesAt = [&](std::size_t pose) {
        Eigen::Matrix<double, 6, 1> values;
        values << poses[pose].place, angles[pose];
        return values;
    };
    Eigen::Matrix<double, 6, 1> least = valuesAt(0), most = valuesAt(0);
    for (std::size_t pose = 1; pose < poses.size(); ++pose) {
        least = least.cwiseMin(valuesAt(pose));
        most = most.cwiseMax(valuesAt(pose));
    }
    constexpr double still = 5e-4; // as written, such an axis does not move
    const std::array<char16_t, 6> names{u'X', u'Y', u'Z', u'A', u'B', u'C'};
    QString result;
    for (std::size_t pose = 0; pose < poses.size(); ++pose) {
        const auto values = valuesAt(pose);
        QStringList words{QStringLiteral("G1")};
        for (int axis = 0; axis < 6; ++axis) {
            const bool isRotary = axis >= 3;
            const bool isPlaced = !isRotary && std::abs(values[axis]) > still;
            if (axis == 2 || isPlaced || most[axis] - least[axis] > still) {
                words << names[std::size_t(axis)] + plain(values[axis]);
            }
        }
        if (pose == 0) { // as slow as the approach, from wherever the part is
            const double minutes = motion.park.value() / (60 * motion.approach.value());
            words << QStringLiteral("F") +
                         plain(inInverseTime ? 1 / minutes : 60 * motion.approach.value());
            result += line(words) + QStringLiteral("M0 ; film swollen, activator sprayed: go on\n");
            continue;
        }
        const auto before = valuesAt(pose - 1);
        const double minutes = (poses[pose].time - poses[pose - 1].time).value() / 60;
        const double way = (values.head<3>() - before.head<3>()).norm();
        const double turn = (values.tail<3>() - before.tail<3>()).norm();
        words << QStringLiteral("F") + QString::number(inInverseTime
                                                           ? 1 / minutes
                                                           : (way > still ? way : turn) / minutes,
                                                       'f', 5);
        if (pose + 1 == poses.size()) {
            result += QStringLiteral("M0 ; film round the part cleared from the water: go on\n");
        }
        result += line(words);
    }
    return result.trimmed();
}

QMap<QString, QString> valuesOf(const DipMotion& motion) {
    return {{QStringLiteral("moves"), moves(motion, true)},
            {QStringLiteral("moves_per_minute"), moves(motion, false)},
            {QStringLiteral("project"), oneLine(motion.project)},
            {QStringLiteral("immersion"), oneLine(motion.immersion)},
            {QStringLiteral("job"), oneLine(motion.job)},
            {QStringLiteral("park_mm"), plain(motion.park.value())},
            {QStringLiteral("start_mm"), plain(motion.start.value())},
            {QStringLiteral("depth_mm"), plain(motion.depth.value())},
            {QStringLiteral("speed_mm_s"), plain(motion.speed.value())},
            {QStringLiteral("speed_mm_min"), plain(motion.speed.value() * 60)},
            {QStringLiteral("approach_mm_min"), plain(motion.approach.value() * 60)},
            {QStringLiteral("dip_s"), plain(motion.dipTime().value())},
            {QStringLiteral("hold_s"), plain(motion.hold.value())},
            {QStringLiteral("hold_ms"), plain(motion.hold.value() * 1000)},
            {QStringLiteral("hold_depth_mm"),
             plain(motion.depth.value() + holdSpeed.value() * motion.hold.value() / 2)},
            {QStringLiteral("hold_mm_min"), plain(holdSpeed.value() * 60)}};
}

} // namespace

std::vector<MotionPoint> motionPoints(const DipMotion& motion) {
    std::vector<MotionPoint> points{{Seconds(0), motion.park, MillimetresPerSecond(0)}};
    const auto go = [&](Millimetres height, MillimetresPerSecond speed) {
        const double way = std::abs((height - points.back().height).value());
        points.push_back({points.back().time + Seconds(way / speed.value()), height, speed});
    };
    go(motion.start, motion.approach);
    go(-motion.depth, motion.speed);
    points.push_back(
        {points.back().time + motion.hold, points.back().height, MillimetresPerSecond(0)});
    go(motion.park, motion.speed);
    return points;
}

std::vector<MotionPose> motionPoses(const DipMotion& motion) {
    // A part that waits sinks and rises by this much, so that each move is a move on any
    // controller.
    constexpr double waiting = 0.1;
    const MotionPose &first = motion.path.front(), &last = motion.path.back();
    const Eigen::Vector3d lift(0, 0, (motion.park - motion.start).value());
    std::vector<MotionPose> poses{{Seconds(0), first.place + lift, first.turn}};
    const Seconds begin(lift.z() / motion.approach.value());
    for (const MotionPose& pose : motion.path) {
        poses.push_back({begin + pose.time, pose.place, pose.turn});
    }
    const auto add = [&](Seconds lasts, const Eigen::Vector3d& place) {
        poses.push_back({poses.back().time + lasts, place, last.turn});
    };
    if (motion.hold > Seconds(0)) {
        add(motion.hold / 2, last.place - waiting * Eigen::Vector3d::UnitZ());
        add(motion.hold / 2, last.place);
    }
    const Eigen::Vector3d out(0, 0, (motion.park + motion.depth).value());
    add(Seconds(out.z() / motion.speed.value()), last.place + out);
    return poses;
}

std::vector<Eigen::Vector3d> motionAngles(const std::vector<MotionPose>& poses) {
    std::vector<Eigen::Vector3d> angles;
    for (const MotionPose& pose : poses) {
        const Eigen::Vector3d zyx = pose.turn.toRotationMatrix().eulerAngles(2, 1, 0);
        const Eigen::Vector3d one(zyx[2], zyx[1], zyx[0]);
        const Eigen::Vector3d other(one.x() + pi, pi - one.y(), one.z() + pi); // the same rotation
        const Eigen::Vector3d before =
            angles.empty() ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(angles.back() * pi / 180);
        const auto near = [&](const Eigen::Vector3d& all) -> Eigen::Vector3d {
            return before + (all - before).unaryExpr([](double angle) {
                return std::remainder(angle, 2 * pi);
            });
        };
        const bool otherIsNearer = (near(other) - before).norm() < (near(one) - before).norm();
        angles.push_back(near(otherIsNearer ? other : one) * 180 / pi);
    }
    return angles;
}

namespace {

QByteArray pathCsv(const DipMotion& motion) {
    QByteArray csv("time_s,x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n");
    const std::vector<MotionPose> poses = motionPoses(motion);
    const std::vector<Eigen::Vector3d> angles = motionAngles(poses);
    for (std::size_t pose = 0; pose < poses.size(); ++pose) {
        QStringList values{plain(poses[pose].time.value())};
        for (const Eigen::Vector3d& vector : {poses[pose].place, angles[pose]}) {
            values << plain(vector.x()) << plain(vector.y()) << plain(vector.z());
        }
        csv += values.join(u',').toLatin1() + '\n';
    }
    return csv;
}

} // namespace

QByteArray motionCsv(const DipMotion& motion) {
    if (!motion.path.empty()) {
        return pathCsv(motion);
    }
    QByteArray csv("time_s,height_mm,speed_mm_s\n");
    for (const MotionPoint& point : motionPoints(motion)) {
        csv += QStringLiteral("%1,%2,%3\n")
                   .arg(plain(point.time.value()), plain(point.height.value()),
                        plain(point.speed.value()))
                   .toLatin1();
    }
    return csv;
}

QByteArray filledTemplate(const DipMotion& motion, const QString& text, const QString& where) {
    static const QRegularExpression name(QStringLiteral("\\{([^{}\\n]*)\\}"));
    const QMap<QString, QString> values = valuesOf(motion);
    QString filled;
    qsizetype done = 0;
    for (auto found = name.globalMatch(text); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        const auto value = values.find(match.captured(1));
        if (value == values.end()) {
            throw Error(Text::tr("The motion template contains the unknown placeholder {%1}; use "
                                 "one of these: %2")
                            .arg(match.captured(1), values.keys().join(QStringLiteral(", "))),
                        where);
        }
        filled += text.mid(done, match.capturedStart() - done) + *value;
        done = match.capturedEnd();
    }
    if (!motion.path.empty() && !text.contains(QLatin1String("{moves"))) {
        throw Error(Text::tr("This dip follows a path, and the motion template has no {moves}; add "
                             "{moves} or {moves_per_minute}, or choose the template of a "
                             "controller: linuxcnc, grbl or marlin"),
                    where);
    }
    return (filled + text.mid(done)).toUtf8();
}

namespace {

QString shippedTemplate(const char* name) {
    return QStringLiteral(":/dipwright/motion/%1.gcode").arg(QLatin1String(name));
}

} // namespace

MotionTemplate motionTemplate(const QString& nameOrPath) {
    static const QMap<QString, QString> controllers{
        {QStringLiteral("linuxcnc"), shippedTemplate("path")},
        {QStringLiteral("grbl"), shippedTemplate("path")},
        {QStringLiteral("marlin"), shippedTemplate("path-marlin")}};
    const QString path = controllers.value(nameOrPath, nameOrPath);
    return {QString::fromUtf8(readSmallFile(path, longestTemplate)), nameOrPath};
}

MotionTemplate standardMotionTemplate(const DipMotion& motion) {
    const QString own =
        QStandardPaths::locate(QStandardPaths::AppDataLocation, QStringLiteral("motion.gcode"));
    if (!own.isEmpty()) {
        return motionTemplate(own);
    }
    return {motionTemplate(shippedTemplate(motion.path.empty() ? "linear" : "path")).text, {}};
}

} // namespace dipwright
