#include "traveller/Traveller.h"

#include "base/NumberText.h"
#include "project/Profiles.h"
#include "sheet/page/QrCode.h"
#include "sheet/page/Sheet.h"
#include "sheet/pdf/PdfDocument.h"
#include "traveller/PageInk.h"
#include "traveller/TankTasks.h"

#include <QCoreApplication>
#include <QLocale>

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <optional>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Traveller)
};

const QSizeF page(210, 297);
constexpr double margin = 12;
constexpr double column = 93 - 2; // width of each of two columns
constexpr double secondColumn = margin + column + 4;
constexpr double wordHeight = 2.9, headHeight = 3.8; // heights of the type
const QColor water(40, 110, 200), paper(120, 120, 120), pinColour(190, 30, 30);

QString plain(double number, int decimals = 1) {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    QString text = locale.toString(number, 'f', decimals);
    if (text.contains(locale.decimalPoint())) {
        while (text.endsWith(locale.zeroDigit())) {
            text.chop(1);
        }
        if (text.endsWith(locale.decimalPoint())) {
            text.chop(locale.decimalPoint().size());
        }
    }
    return withMinusSign(text);
}

QString secondsText(const std::optional<Seconds>& time) {
    return time ? Text::tr("%1 s").arg(plain(time->value()))
                : Text::tr("see the film maker's instructions (no time given)");
}

std::optional<Seconds> ofFilm(const Traveller& traveller, Seconds FilmProfile::*time) {
    const auto& film = traveller.profiles.film;
    return film ? std::optional<Seconds>((*film).*time) : std::nullopt;
}

std::optional<Seconds> ofFilm(const Traveller& traveller,
                              std::optional<Seconds> FilmProfile::*time) {
    const auto& film = traveller.profiles.film;
    return film ? (*film).*time : std::nullopt;
}

// Paints the verdict, in a box unless the sheets can be printed. Returns the y below it.
double paintVerdict(const PageInk& ink, const TravellerDip& dip, double top) {
    if (dip.verdict.isEmpty()) {
        return top;
    }
    const double width = page.width() - 2 * margin;
    double y = ink.text({margin, top, width, 0}, headHeight,
                        Text::tr("Verdict: %1").arg(dip.verdict.front()));
    if (!dip.canBePrinted) {
        ink.box({margin - 1, top - 0.5, width + 2, y - top + 1}, 0.6);
        y += 1.5;
    }
    const QString reasons = dip.verdict.mid(1).join(QStringLiteral(" • "));
    return reasons.isEmpty() ? y : ink.text({margin, y, width, 0}, wordHeight, reasons);
}

// Paints the head of a page with the job number as a QR code. Returns the y below it.
double paintHead(QPainter& painter, const Traveller& traveller, std::size_t number) {
    const PageInk ink(painter);
    const TravellerDip& dip = traveller.dips[number];
    constexpr double code = 30;
    const double width = page.width() - 2 * margin - code;
    double y = ink.text({margin, margin, width, 0}, 6,
                        Text::tr("Dip %1 of %2: %3")
                            .arg(number + 1)
                            .arg(traveller.dips.size())
                            .arg(dip.immersion.name));
    y = ink.text({margin, y + 1, width, 0}, headHeight,
                 Text::tr("Traveller for %1, %2").arg(traveller.project, traveller.date));
    QStringList order;
    for (std::size_t i = 0; i < traveller.dips.size(); ++i) {
        order << Text::tr("%1. %2, job %3")
                     .arg(i + 1)
                     .arg(traveller.dips[i].immersion.name, traveller.dips[i].job);
    }
    y = ink.text({margin, y + 1, width, 0}, wordHeight,
                 Text::tr("Order of the dips: %1").arg(order.join(QStringLiteral(" → "))));
    if (!traveller.order.isEmpty()) {
        y = ink.text({margin, y + 0.5, width, 0}, wordHeight, traveller.order);
    }
    const QRectF place(page.width() - margin - code, margin - 4, code, code);
    paintQrCode(painter, place, travellerJob(traveller));
    const double under =
        ink.text({place.x() - 10, place.bottom() - 1, code + 10, 0}, wordHeight,
                 (traveller.dips.size() > 1 ? Text::tr("All dips: %1") : Text::tr("Job %1"))
                     .arg(travellerJob(traveller)),
                 Qt::AlignRight);
    return std::max(y, under) + 1;
}

// Paints one view of the pose, with the water level before and after the dip.
void paintPose(QPainter& painter, const QRectF& place, const QString& title,
               const PosePicture& picture, const TravellerDip& dip) {
    const PageInk ink(painter);
    const double under = ink.text({place.x(), place.y(), place.width(), 0}, wordHeight, title);
    const QRectF frame(place.x(), under + 0.5, place.width(), place.bottom() - under - 0.5);
    const QRectF where = ink.picture(frame, picture.image);
    const double perMillimetre = where.height() / picture.image.height() * picture.scale;
    const auto heightOf = [&](double y) {
        return where.bottom() - (y - picture.bottom) * perMillimetre;
    };
    for (const double level : {-dip.motion.start.value(), dip.waterAtEnd}) {
        if (level < 0 && !dip.motion.path.empty()) {
            continue; // on a path, the part starts in another rotation than the picture shows
        }
        const double y = heightOf(level);
        if (y > where.top() && y < where.bottom()) {
            ink.line({frame.left(), y}, {frame.right(), y}, 0.3, water,
                     level > 0 ? Qt::DashLine : Qt::SolidLine);
        }
    }
    ink.arrow({frame.left() + 4, where.top() + 3}, {frame.left() + 4, where.top() + 15}, Qt::black);
    ink.box(frame, 0.15, paper);
}

QString poseText(const TravellerDip& dip) {
    if (!dip.motion.path.empty()) {
        return Text::tr("The part at the end of the dip, when its rotation about fixed axes is X "
                        "%1°, then Y %2°, then Z %3°. Dashed blue line: water at the end.")
            .arg(plain(dip.immersion.rotation[0].value()), plain(dip.immersion.rotation[1].value()),
                 plain(dip.immersion.rotation[2].value()));
    }
    const auto& angles = dip.immersion.rotation;
    const auto& offset = dip.immersion.offset;
    return Text::tr("Rotation about fixed axes: X %1°, then Y %2°, then Z %3°. Centre of the part: "
                    "x = %4 mm (to the right), z = %5 mm (towards the lower edge) from the film's "
                    "centre. Blue line: water when the dip begins (solid) and ends (dashed).")
        .arg(plain(angles[0].value()), plain(angles[1].value()), plain(angles[2].value()),
             plain(offset[0].value()), plain(offset[1].value()));
}

QString cradleText(const TravellerDip& dip) {
    const QString text =
        !dip.hasCradle ? Text::tr("There is no cradle for this dip. Hold the part as drawn.")
        : dip.motion.path.empty()
            ? Text::tr("The cradle is marked with the number of this dip and the number of its "
                       "sheet, %1. Its arrow points to the film's upper edge.")
                  .arg(dip.job)
            : Text::tr("The cradle is marked with the number of this dip and the number of its "
                       "sheet, %1. At the end of the path, its arrow points to the film's upper "
                       "edge.")
                  .arg(dip.job);
    return (QStringList(text) + dip.cradleNotes).join(QStringLiteral(" "));
}

double paintPoses(QPainter& painter, const TravellerDip& dip, double top) {
    const PageInk ink(painter);
    constexpr double high = 62;
    paintPose(painter, {margin, top, column, high}, Text::tr("Seen from the film's lower edge"),
              dip.front, dip);
    paintPose(painter, {secondColumn, top, column, high},
              Text::tr("Seen from the film's right edge"), dip.right, dip);
    const double width = page.width() - 2 * margin;
    const double y = ink.text({margin, top + high + 1, width, 0}, wordHeight, poseText(dip));
    return ink.text({margin, y + 0.8, width, 0}, wordHeight, cradleText(dip)) + 2;
}

// Paints the film on the water as seen from above: its edges, marks and pins, and the part's
// outline.
void paintFilm(QPainter& painter, const QRectF& place, const Traveller& traveller,
               const TravellerDip& dip) {
    const PageInk ink(painter);
    const FilmSettings& film = traveller.film;
    const QSizeF floating(film.width.value() * film.swellX, film.height.value() * film.swellY);
    std::array<Millimetres, 2> tank{};
    if (traveller.profiles.tank) {
        tank = traveller.profiles.tank->markDistance;
    }
    const double scale =
        std::min((place.width() - 14) / std::max(floating.width(), tank[0].value()),
                 (place.height() - 14) / std::max(floating.height(), tank[1].value()));
    const QPointF middle = place.center();
    const auto at = [&](double x, double z) { return middle + QPointF(x * scale, z * scale); };
    QRectF sheet(QPointF(0, 0), floating * scale);
    sheet.moveCenter(middle);
    painter.drawImage(sheet, dip.sheet);
    ink.box(sheet, 0.3);
    const double x = dip.immersion.offset[0].value(), z = dip.immersion.offset[1].value();
    const BoundingBox& body = dip.body;
    ink.box(QRectF(at(x + double(body.min().x()), z + double(body.min().z())),
                   at(x + double(body.max().x()), z + double(body.max().z()))),
            0.25, Qt::black, Qt::DashLine);
    for (const Eigen::Vector2d& mark : traveller.pins.marks) {
        const QPointF centre = at(mark.x(), mark.y());
        ink.line(centre - QPointF(1.6, 0), centre + QPointF(1.6, 0), 0.2);
        ink.line(centre - QPointF(0, 1.6), centre + QPointF(0, 1.6), 0.2);
    }
    painter.setPen(QPen(pinColour, 0.4));
    painter.setBrush(Qt::NoBrush);
    for (const Eigen::Vector2d& pin : traveller.pins.pins) {
        painter.drawEllipse(at(pin.x(), pin.y()), 1.3, 1.3);
    }
    if (tank[0].value() > 0 && tank[1].value() > 0) {
        ink.box(QRectF(at(-tank[0].value() / 2, -tank[1].value() / 2),
                       at(tank[0].value() / 2, tank[1].value() / 2)),
                0.3, water, Qt::DotLine);
    }
    ink.text({sheet.left(), sheet.top() + 0.8, sheet.width(), 0}, wordHeight,
             Text::tr("upper edge"), Qt::AlignHCenter);
    ink.text({sheet.left(), sheet.bottom() - 4.4, sheet.width(), 0}, wordHeight,
             Text::tr("lower edge"), Qt::AlignHCenter);
    painter.save();
    painter.translate(sheet.left() + 0.6, sheet.bottom());
    painter.rotate(-90);
    ink.text({0, 0, sheet.height(), 0}, wordHeight, Text::tr("left edge"), Qt::AlignHCenter);
    painter.restore();
}

QString filmText(const Traveller& traveller) {
    const auto pinText = [](const Eigen::Vector2d& pin) {
        return QStringLiteral("(%1; %2)").arg(plain(pin.x()), plain(pin.y()));
    };
    const auto& pins = traveller.pins.pins;
    QString text =
        Text::tr("From above, ink side up. Crosses: marks of the floating film, or its corners "
                 "if it has no marks. Red circles: datum pins at (x; z) = %1, %2 and %3 mm from "
                 "the film's "
                 "centre, x to the right, z towards the lower edge. Dashed: the part.")
            .arg(pinText(pins[0]), pinText(pins[1]), pinText(pins[2]));
    const auto& tank = traveller.profiles.tank;
    const bool hasMarks = tank && tank->markDistance[0].value() > 0;
    text +=
        u' ' +
        (hasMarks
             ? Text::tr("Dotted: the tank's marks, %1 × %2 mm apart. Centre the film between them.")
                   .arg(plain(tank->markDistance[0].value()), plain(tank->markDistance[1].value()))
             : Text::tr("The distance between the tank's marks is not given."));
    return text;
}

QString materialText(const Traveller& traveller) {
    const FilmSettings& film = traveller.film;
    const QString size = Text::tr("Film: printed size %1 × %2 mm, swell %3 × %4.")
                             .arg(plain(film.width.value()), plain(film.height.value()),
                                  plain(film.swellX, 3), plain(film.swellY, 3));
    const auto& profile = traveller.profiles.film;
    const QString origin = hasMeasuredSwell(film, traveller.profiles)
                               ? Text::tr("Swell measured on %1.").arg(profile->measured.date)
                               : Text::tr("Swell guessed, not measured.");
    if (!profile) {
        return size + u' ' + Text::tr("No film profile is given.") + u' ' + origin;
    }
    return size + u' ' +
           Text::tr("%1 (lot: %2, use by: %3).")
               .arg(profile->name, profile->lot.isEmpty() ? Text::tr("not given") : profile->lot,
                    profile->expiry.isEmpty() ? Text::tr("not given") : profile->expiry) +
           u' ' + origin;
}

// Returns the pose on a path at a given time, interpolated between the path's poses.
MotionPose poseAt(const std::vector<MotionPose>& path, Seconds time) {
    const auto after = std::find_if(path.begin() + 1, path.end() - 1,
                                    [&](const MotionPose& pose) { return pose.time >= time; });
    const MotionPose& before = *(after - 1);
    const double share = std::clamp((time - before.time) / (after->time - before.time), 0.0, 1.0);
    return {time, before.place + share * (after->place - before.place),
            before.turn.slerp(share, after->turn)};
}

// Returns the times of the poses that the page lists. These are the user's own poses, unless there
// are too many, or a limit of the acceleration delays them. Then they divide the dip's time into
// equal parts.
std::vector<Seconds> listedTimes(const TravellerDip& dip) {
    constexpr std::size_t mostListed = 8;
    constexpr int parts = 3;
    std::vector<Seconds> times;
    const DipPath& path = dip.immersion.path;
    if (path.kind == PathKind::Poses && path.keys.size() <= mostListed && !path.acceleration) {
        for (const PathKey& key : path.keys) {
            times.push_back(key.time);
        }
        return times;
    }
    for (int part = 0; part <= parts; ++part) {
        times.push_back(dip.motion.dipTime() * (double(part) / parts));
    }
    return times;
}

// Tells how the water must flow, with a space before it; empty if it stands.
QString flowText(const TravellerDip& dip) {
    const Eigen::Vector3d flow = waterVelocity(dip.immersion.path);
    if (flow.norm() == 0) {
        return {};
    }
    const Eigen::Vector3d way = dip.motion.dipTime().value() * flow;
    const double heading = std::atan2(flow.z(), flow.x()) * 180 / pi;
    return u' ' +
           Text::tr("The water flows at %1 mm/s with the heading %2° (0°: to the right, 90°: "
                    "towards the lower edge) and carries the film. Lay the film so far upstream "
                    "that its centre is in the middle of the tank when the dip begins; all "
                    "positions are relative to that place. At the end of the dip, the film's "
                    "centre is %3 mm to the right of it and %4 mm towards the lower edge.")
               .arg(plain(flow.norm(), 2), plain(heading < 0 ? heading + 360 : heading),
                    plain(way.x()), plain(way.z()));
}

// Tells how to lay the film of a dip on the water.
QString layText(const TravellerDip& dip) {
    QString text = dip.passes > 1
                       ? Text::tr("Lay sheet %1, which must have been printed in %2 passes, on the "
                                  "water, ink side up.")
                             .arg(dip.job)
                             .arg(dip.passes)
                       : Text::tr("Lay sheet %1 on the water, ink side up.").arg(dip.job);
    // On a path, the arrow may point to the upper edge only at the end.
    if (dip.hasCradle && dip.motion.path.empty()) {
        text += u' ' + Text::tr("The arrow on the cradle's plate must point to the upper edge of "
                                "the sheet.");
    }
    return text + flowText(dip);
}

// Describes a dip that goes straight down.
QString straightStep(const DipMotion& motion) {
    return Text::tr("Dip the part: lower its lowest point from %1 mm above the water to %2 mm "
                    "below it, at %3 mm/s, in %4 s")
        .arg(plain(motion.start.value()), plain(motion.depth.value()),
             plain(motion.speed.value(), 2), plain(motion.dipTime().value()));
}

// Describes a dip that does not go straight down. Each pose has a line of its own.
QString pathStep(const TravellerDip& dip, std::size_t number) {
    const QString bullet = QStringLiteral("\n• ");
    std::vector<MotionPose> poses;
    for (const Seconds time : listedTimes(dip)) {
        poses.push_back(poseAt(dip.motion.path, time));
    }
    const std::vector<Eigen::Vector3d> angles = motionAngles(poses);
    QStringList keys;
    for (std::size_t pose = 0; pose < poses.size(); ++pose) {
        const Eigen::Vector3d &place = poses[pose].place, &turn = angles[pose];
        keys << Text::tr("%1 s: %2 mm to the right, %3 mm towards the upper edge, %4 mm up, turned "
                         "by %5°, %6° and %7°")
                    .arg(plain(poses[pose].time.value()), plain(place.x()), plain(place.y()),
                         plain(place.z()), plain(turn.x()), plain(turn.y()), plain(turn.z()));
    }
    return Text::tr("Dip the part along its path in %1 s (motion-%2.csv begins at the waiting "
                    "height). Each pose gives the time, the position of the part's centre relative "
                    "to the film's centre on the water, and the turn relative to the rotation at "
                    "the end: about the axis to the right, then about the axis towards the upper "
                    "edge, then about the upward axis.")
               .arg(plain(dip.motion.dipTime().value()))
               .arg(number + 1) +
           bullet + keys.join(bullet);
}

// Returns the steps of one dip; `number` counts from 0.
std::vector<TankTask> stepsOf(const Traveller& traveller, std::size_t number) {
    const TravellerDip& dip = traveller.dips[number];
    const DipMotion& motion = dip.motion;
    std::vector<TankTask> tasks;
    const auto add = [&](TankStep step, const QString& text,
                         const std::optional<Seconds>& time = {}) {
        tasks.push_back({int(number) + 1, step, tankStepTitle(step), text, time});
    };
    // `text` has a place for the time.
    const auto addTimed = [&](TankStep step, const QString& text,
                              const std::optional<Seconds>& time) {
        add(step, text.arg(secondsText(time)), time);
    };
    const bool isMasked = traveller.masked.count > 0, isLast = number + 1 == traveller.dips.size();
    if (isMasked) {
        add(TankStep::Tape,
            number == 0 ? Text::tr("Cover the masked surface of the part with tape (pink in "
                                   "the pictures). Number of areas: %1; in total %2 mm².")
                              .arg(traveller.masked.count)
                              .arg(plain(traveller.masked.area, 0))
                        : Text::tr("Check that the tape still covers the masked surface (pink "
                                   "in the pictures)."));
    }
    add(TankStep::Lay, layText(dip));
    addTimed(TankStep::Soak, Text::tr("Soak the film: %1"),
             ofFilm(traveller, &FilmProfile::soakTime));
    addTimed(TankStep::Activator, Text::tr("Spray the activator, then wait: %1"),
             ofFilm(traveller, &FilmProfile::activatorTime));
    add(TankStep::Dip, motion.path.empty() ? straightStep(motion) : pathStep(dip, number),
        motion.dipTime());
    add(TankStep::Hold,
        Text::tr("Hold the part under water for %1 s. Clear the remaining film from the water "
                 "around it. Then lift the part out at %2 mm/s.")
            .arg(plain(motion.hold.value()), plain(motion.speed.value(), 2)),
        motion.hold);
    addTimed(TankStep::Flash, Text::tr("Let the part flash off before rinsing: %1"),
             ofFilm(traveller, &FilmProfile::flashTime));
    addTimed(TankStep::Dry, Text::tr("Rinse the part, then let it dry: %1"),
             ofFilm(traveller, &FilmProfile::dryingTime));
    if (isMasked && isLast) {
        add(TankStep::RemoveTape, Text::tr("Remove the tape from the masked surface."));
    }
    add(TankStep::Compare,
        !isLast ? Text::tr("Before dip %1, compare the part with its pictures after dip %2: the "
                           "colours are in place, nothing is torn or folded, and the part is dry "
                           "where it will be held.")
                      .arg(number + 2)
                      .arg(number + 1)
                : Text::tr("Compare the part with its pictures after dip %1.").arg(number + 1));
    return tasks;
}

double paintFilmAndSteps(QPainter& painter, const Traveller& traveller, std::size_t number,
                         double top) {
    const PageInk ink(painter);
    constexpr double high = 88;
    paintFilm(painter, {margin, top, column, high - 4}, traveller, traveller.dips[number]);
    const double left =
        ink.text({margin, top + high - 3, column, 0}, wordHeight, filmText(traveller));
    double y = ink.text({secondColumn, top, column, 0}, headHeight, Text::tr("At the tank"));
    y = ink.text({secondColumn, y + 1, column, 0}, wordHeight, materialText(traveller)) + 1.5;
    for (const TankTask& task : stepsOf(traveller, number)) {
        y = ink.tick({secondColumn, y + 1.2}, column, wordHeight, task.text);
    }
    return std::max(left, y) + 3;
}

constexpr double signature = 15; // height of the fields at the bottom, mm

// Paints the pictures of the part after a dip, and the fields to sign, down to the end of the page.
void paintAfter(QPainter& painter, const Traveller& traveller, std::size_t number, double top) {
    const PageInk ink(painter);
    const double width = page.width() - 2 * margin;
    const double bottom = page.height() - margin - signature;
    const double y = ink.text({margin, top, width, 0}, headHeight,
                              Text::tr("After dip %1 the part should look like this (seen from the "
                                       "lower edge, the right edge and below)")
                                  .arg(number + 1));
    const QImage& after = traveller.dips[number].after;
    const double full = after.isNull() ? 0 : width * after.height() / after.width();
    ink.picture({margin, y + 1, width, std::min(bottom - y - 3, full)}, after);
    const QStringList words{Text::tr("Done by"), Text::tr("Date, time"), Text::tr("Checked by")};
    for (int i = 0; i < words.size(); ++i) {
        const QRectF place(margin + i * width / 3, bottom, width / 3, signature);
        ink.box(place, 0.25);
        ink.text({place.x() + 1.2, place.y() + 0.8, place.width(), 0}, wordHeight, words[i]);
    }
}

// Paints all that the operator does in a dip. Returns the y below it.
double paintDip(QPainter& painter, const Traveller& traveller, std::size_t number) {
    const TravellerDip& dip = traveller.dips[number];
    double y = paintHead(painter, traveller, number);
    y = paintVerdict(PageInk(painter), dip, y) + 2;
    y = paintPoses(painter, dip, y);
    return paintFilmAndSteps(painter, traveller, number, y);
}

// Tells whether the pictures of the part after a dip are large enough below the steps.
bool picturesFit(const Traveller& traveller, std::size_t number) {
    constexpr double leastHeight = 35; // mm, with their title
    QImage canvas(1, 1, QImage::Format_RGB32);
    QPainter painter(&canvas);
    return paintDip(painter, traveller, number) <= page.height() - margin - signature - leastHeight;
}

} // namespace

std::vector<TankTask> tankTasks(const Traveller& traveller) {
    std::vector<TankTask> tasks;
    for (std::size_t number = 0; number < traveller.dips.size(); ++number) {
        for (TankTask& task : stepsOf(traveller, number)) {
            if (task.step == TankStep::Compare) { // the picture is on the page only
                task.text = Text::tr("Compare the part with the picture on the traveller: the "
                                     "colours are in place, and nothing is torn or folded.");
            }
            tasks.push_back(std::move(task));
        }
    }
    return tasks;
}

QString combinedJobNumber(const QStringList& jobs) {
    if (jobs.size() == 1) {
        return jobs.front();
    }
    return hashOfJobs(jobs);
}

QString travellerJob(const Traveller& traveller) {
    QStringList jobs;
    for (const TravellerDip& dip : traveller.dips) {
        jobs << dip.job;
    }
    return combinedJobNumber(jobs);
}

QByteArray travellerPdf(const Traveller& traveller) {
    std::vector<PdfPage> pages;
    for (std::size_t number = 0; number < traveller.dips.size(); ++number) {
        const bool fits = picturesFit(traveller, number);
        pages.push_back({page, [&traveller, number, fits](QPainter& painter) {
                             const double y = paintDip(painter, traveller, number);
                             if (fits) {
                                 paintAfter(painter, traveller, number, y);
                             }
                         }});
        if (!fits) {
            pages.push_back({page, [&traveller, number](QPainter& painter) {
                                 const double y = paintHead(painter, traveller, number);
                                 paintAfter(painter, traveller, number, y + 2);
                             }});
        }
    }
    PdfSettings settings;
    settings.title = Text::tr("Traveller for %1, %2").arg(traveller.project, traveller.date);
    return pdfDocument(pages, settings);
}

} // namespace dipwright
