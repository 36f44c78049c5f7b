#include "traveller/Motion.h"

#include "base/Error.h"
#include "dip/Pose.h"
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

using Axes = Eigen::Matrix<double, 6, 1>; // X, Y, Z in mm, A, B, C in degrees

constexpr double still = 5e-4; // as written, an axis that moves less does not move

// Returns the G-code words of those axes in `chosen` that move or are not at 0.
QStringList axisWords(const Axes& values, const Axes& ranges, std::initializer_list<int> chosen) {
    constexpr std::array<char16_t, 6> names{u'X', u'Y', u'Z', u'A', u'B', u'C'};
    QStringList words;
    for (const int axis : chosen) {
        const bool isPlaced = axis < 2 && std::abs(values[axis]) > still;
        if (axis == 2 || isPlaced || ranges[axis] > still) {
            words << names[std::size_t(axis)] + plain(values[axis]);
        }
    }
    return words;
}

// Returns the whole motion as G-code moves. `inInverseTime`: the feed of G93, else that of G94.
QString moves(DipMotion motion, bool inInverseTime) {
    if (motion.path.empty()) { // a straight motion moves Z only
        motion.path = {{Seconds(0), {0, 0, motion.start.value()}},
                       {motion.dipTime(), {0, 0, -motion.depth.value()}}};
    }
    const std::vector<MotionPose> poses = motionPoses(motion);
    const std::vector<Eigen::Vector3d> angles = motionAngles(poses);
    std::vector<Axes> values(poses.size());
    for (std::size_t pose = 0; pose < poses.size(); ++pose) {
        values[pose] << poses[pose].place, angles[pose];
    }
    Axes least = values[0], most = values[0];
    for (const Axes& each : values) {
        least = least.cwiseMin(each);
        most = most.cwiseMax(each);
    }
    const Axes ranges = most - least;
    // Moves up first, then over the film, at the speed of the approach. So the part's position at
    // the start does not matter.
    const QString approach = QStringLiteral(" F") + plain(60 * motion.approach.value()) + u'\n';
    QString result = inInverseTime ? QStringLiteral("G94\n") : QString();
    result += QStringLiteral("G1 ") + axisWords(values[0], ranges, {2}).join(u' ') + approach;
    if (const QStringList others = axisWords(values[0], ranges, {0, 1, 3, 4, 5});
        !others.isEmpty()) {
        result += QStringLiteral("G1 ") + others.join(u' ') + approach;
    }
    result += QStringLiteral("M0 ; film swollen, activator sprayed: continue\n");
    result += inInverseTime ? QStringLiteral("G93\n") : QString();
    for (std::size_t pose = 1; pose < poses.size(); ++pose) {
        const double minutes = (poses[pose].time - poses[pose - 1].time).value() / 60;
        const Axes change = values[pose] - values[pose - 1];
        const double way = change.head<3>().norm(), turn = change.tail<3>().norm();
        if (pose + 1 == poses.size()) {
            result += QStringLiteral("M0 ; film round the part cleared from the water: continue\n");
        }
        result += QStringLiteral("G1 ") +
                  axisWords(values[pose], ranges, {0, 1, 2, 3, 4, 5}).join(u' ') +
                  QStringLiteral(" F") +
                  QString::number((inInverseTime ? 1
                                   : way > still ? way
                                                 : turn) /
                                      minutes,
                                  'f', 5) +
                  u'\n';
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

namespace {

// Adds a wait at the last pose, as a slow move down and up, because controllers use different units
// for a dwell and skip moves of no length.
void addWait(std::vector<MotionPose>& poses, Seconds lasts) {
    const MotionPose at = poses.back();
    const double down = holdSpeed.value() * lasts.value() / 2;
    poses.push_back({at.time + lasts / 2, at.place - down * Eigen::Vector3d::UnitZ(), at.turn});
    poses.push_back({at.time + lasts, at.place, at.turn});
}

// Returns a path without moves that a controller would skip because they are shorter than its
// resolution: short ones join the next move, and a wait becomes a slow one.
std::vector<MotionPose> carriedOut(const std::vector<MotionPose>& path) {
    constexpr double leastWay = 0.005, leastTurn = 0.005 * pi / 180; // mm, radians
    constexpr Seconds leastWait(0.2);
    std::vector<MotionPose> poses{path.front()};
    Seconds rested = path.front().time; // when the part was last at the last pose
    for (std::size_t i = 1; i < path.size(); ++i) {
        const MotionPose& last = poses.back();
        const bool moves = (path[i].place - last.place).norm() > leastWay ||
                           last.turn.angularDistance(path[i].turn) > leastTurn;
        if (!moves && i + 1 < path.size()) {
            rested = path[i].time;
            continue;
        }
        if (const Seconds wait = rested - last.time; wait > leastWait) {
            addWait(poses, wait);
        }
        poses.push_back(path[i]);
        rested = path[i].time;
    }
    return poses;
}

} // namespace

std::vector<MotionPose> motionPoses(const DipMotion& motion) {
    const MotionPose &first = motion.path.front(), &last = motion.path.back();
    const Eigen::Vector3d lift(0, 0, (motion.park - motion.start).value());
    std::vector<MotionPose> poses{{Seconds(0), first.place + lift, first.turn}};
    const Seconds begin(lift.z() / motion.approach.value());
    for (const MotionPose& pose : carriedOut(motion.path)) {
        poses.push_back({begin + pose.time, pose.place, pose.turn});
    }
    if (motion.hold > Seconds(0)) {
        addWait(poses, motion.hold);
    }
    const Eigen::Vector3d out(0, 0, (motion.park + motion.depth).value());
    poses.push_back(
        {poses.back().time + Seconds(out.z() / motion.speed.value()), last.place + out, last.turn});
    return poses;
}

std::vector<Eigen::Vector3d> motionAngles(const std::vector<MotionPose>& poses) {
    std::vector<Eigen::Vector3d> angles(poses.size());
    Eigen::Vector3d after(0, 0, 0); // the angles of the next pose
    for (std::size_t pose = poses.size(); pose-- > 0;) {
        after = anglesNear(poses[pose].turn.toRotationMatrix(), after);
        angles[pose] = after * 180 / pi;
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
        {QStringLiteral("grbl"), shippedTemplate("path-grbl")},
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
