#include "pipeline/JobTicket.h"

#include "base/ImageRows.h"
#include "base/ProgramName.h"
#include "base/Sha256.h"
#include "pipeline/JobTraveller.h"
#include "project/Profiles.h"

#include <QJsonArray>

#include <cmath>

namespace dipwright {
namespace {

QJsonArray pair(double first, double second) {
    return {first, second};
}

QJsonValue orNull(const std::optional<Seconds>& time) {
    return time ? QJsonValue(time->value()) : QJsonValue();
}

// Returns the profile's name and the values of `keys`; null if the project has no such profile.
template <typename Kind>
QJsonValue named(const std::optional<Kind>& profile, std::initializer_list<const char*> keys) {
    if (!profile) {
        return {};
    }
    const QJsonObject all = toJson(Profile(*profile));
    QJsonObject json{{"name", profile->name}};
    for (const char* key : keys) {
        json.insert(QLatin1String(key), all.value(QLatin1String(key)));
    }
    return json;
}

QJsonObject filmTicket(const Project& project) {
    const FilmSettings& film = project.film;
    const bool measured = hasMeasuredSwell(film, project.profiles);
    return {{"size_mm", pair(film.width.value(), film.height.value())},
            {"swell", pair(film.swellX, film.swellY)},
            {"swell_is", measured ? "measured" : "guessed"},
            {"growth_per_s", film.growthRate},
            {"growth_limit", film.growthLimit},
            {"relaxation_time_s", std::isinf(film.relaxationTime.value())
                                      ? QJsonValue()
                                      : QJsonValue(film.relaxationTime.value())},
            {"profile", named(project.profiles.film, {"lot", "expiry", "feed"})}};
}

// Returns the film's waiting times. A time is null if there is no film profile or the profile does
// not give it.
QJsonObject dwellTicket(const std::optional<FilmProfile>& film) {
    if (!film) {
        return {{"soak_s", {}}, {"activator_s", {}}, {"flash_s", {}}, {"drying_s", {}}};
    }
    return {{"soak_s", film->soakTime.value()},
            {"activator_s", film->activatorTime.value()},
            {"flash_s", orNull(film->flashTime)},
            {"drying_s", orNull(film->dryingTime)}};
}

// Returns the poses of a dip on a path, for a machine.
QJsonArray posesTicket(const DipMotion& motion) {
    QJsonArray poses;
    for (const MotionPose& pose : motion.path) {
        const Eigen::Vector3d& place = pose.place;
        const Eigen::Quaterniond& turn = pose.turn;
        poses.append(
            QJsonObject{{"time_s", pose.time.value()},
                        {"place_mm", QJsonArray{place.x(), place.y(), place.z()}},
                        {"turn_wxyz", QJsonArray{turn.w(), turn.x(), turn.y(), turn.z()}}});
    }
    return poses;
}

QJsonObject motionTicket(const DipMotion& motion) {
    return {{"park_mm", motion.park.value()},    {"start_mm", motion.start.value()},
            {"depth_mm", motion.depth.value()},  {"speed_mm_s", motion.speed.value()},
            {"dip_s", motion.dipTime().value()}, {"approach_mm_s", motion.approach.value()},
            {"hold_s", motion.hold.value()}};
}

QJsonObject sheetTicket(const Sheet& sheet) {
    const QSizeF page = pageSize(sheet);
    return {{"page_mm", pair(page.width(), page.height())},
            {"dpi", sheet.settings.resolution.value()},
            {"passes", sheet.passes},
            {"picture_px", QJsonArray{sheet.image.width(), sheet.image.height()}},
            {"picture_sha256", pictureHash(sheet.image)}};
}

QJsonArray filesTicket(const QStringList& names, const ResultContents& contents) {
    QJsonArray files;
    for (const QString& name : names) {
        const QByteArray bytes = contents(name);
        if (!bytes.isEmpty()) {
            files.append(
                QJsonObject{{"file", name}, {"bytes", bytes.size()}, {"sha256", sha256Hex(bytes)}});
        }
    }
    return files;
}

} // namespace

QString pictureHash(const QImage& filmImage) {
    Sha256 hash;
    forImageRows(filmImage, [&](const QImage& rows, int) {
        const QImage picture = flattened(rows);
        for (int row = 0; row < picture.height(); ++row) {
            hash.add(QByteArrayView(picture.constScanLine(row), 3 * qsizetype(picture.width())));
        }
    });
    return QString::fromLatin1(hash.result().toHex());
}

QJsonObject jobTicket(const JobResult& result, const std::vector<QStringList>& files,
                      const ResultContents& contents) {
    const Project& project = result.project;
    QStringList jobs;
    QJsonArray dips;
    for (std::size_t i = 0; i < result.immersions.size(); ++i) {
        const ImmersionResult& dip = result.immersions[i];
        const std::array<Degrees, 3>& turn = dip.immersion.rotation;
        jobs << dip.sheet.job.hash;
        const DipMotion motion = jobMotion(result, i);
        QJsonObject ticket{
            {"name", dip.immersion.name},
            {"job", dip.sheet.job.hash},
            {"rotation_deg", QJsonArray{turn[0].value(), turn[1].value(), turn[2].value()}},
            {"offset_mm", pair(dip.immersion.offset[0].value(), dip.immersion.offset[1].value())},
            {"advice", adviceKey(dip.verdict.advice)},
            {"motion", motionTicket(motion)},
            {"sheet", sheetTicket(dip.sheet)},
            {"files", filesTicket(files[i], contents)}};
        if (!motion.path.empty()) {
            ticket.insert(QStringLiteral("path"), pathToJson(dip.immersion));
            ticket.insert(QStringLiteral("poses"), posesTicket(motion));
        }
        dips.append(ticket);
    }
    return {{"format", "dipwright-ticket"},
            {"version", 1},
            {"program", programVersion()},
            {"project", project.name},
            {"date", project.date},
            {"job", combinedJobNumber(jobs)},
            {"solver", QJsonObject{{"id", result.solver.id}, {"version", result.solver.version}}},
            {"film", filmTicket(project)},
            {"dwell", dwellTicket(project.profiles.film)},
            {"printer", named(project.profiles.printer, {"scale"})},
            {"tank", named(project.profiles.tank, {"size_mm", "water_level_mm"})},
            {"dips", dips}};
}

} // namespace dipwright
