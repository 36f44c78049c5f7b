#include "traveller/Motion.h"

#include "base/Error.h"
#include "disk/SmallFile.h"

#include <QCoreApplication>
#include <QMap>
#include <QRegularExpression>
#include <QStandardPaths>

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

QMap<QString, QString> valuesOf(const DipMotion& motion) {
    return {{QStringLiteral("project"), oneLine(motion.project)},
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

QByteArray motionCsv(const DipMotion& motion) {
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
    return (filled + text.mid(done)).toUtf8();
}

MotionTemplate motionTemplate(const QString& path) {
    return {QString::fromUtf8(readSmallFile(path, longestTemplate)), path};
}

MotionTemplate motionTemplate() {
    const QString own =
        QStandardPaths::locate(QStandardPaths::AppDataLocation, QStringLiteral("motion.gcode"));
    if (!own.isEmpty()) {
        return motionTemplate(own);
    }
    return {motionTemplate(QStringLiteral(":/dipwright/motion/linear.gcode")).text, {}};
}

} // namespace dipwright
