#include "pipeline/JobTraveller.h"

#include "cost/CostText.h"
#include "dip/TankFit.h"
#include "pipeline/JobCost.h"
#include "pipeline/JobVerdict.h"
#include "pipeline/PrintedBody.h"

#include <QPainter>

#include <cmath>

namespace dipwright {
namespace {

const QSize posePixels(900, 560), afterPixels(620, 480);
constexpr int sheetPixelsAcross = 500;

// Draws the body without its cradle from the front, the right and below, side by side.
QImage afterDip(const PoseView& view, const Progress& progress) {
    QImage pictures(3 * afterPixels.width(), afterPixels.height(), QImage::Format_RGB32);
    QPainter painter(&pictures);
    int x = 0;
    for (const PoseSide side : {PoseSide::Front, PoseSide::Right, PoseSide::Below}) {
        painter.drawImage(x, 0, posePicture(view, side, afterPixels, progress).image);
        x += afterPixels.width();
    }
    return pictures;
}

// Returns the verdict on the job, then its reasons: all that concern this dip or the whole job. Of
// the other dip, only the reasons for this verdict.
QStringList verdictLines(const JobResult& result, std::size_t number) {
    const Advice advice = adviceOf(result);
    QStringList lines{adviceText(advice)};
    for (const JobReason& reason : reasonsOf(result)) {
        if (!reason.dip || *reason.dip == number) {
            lines << reasonText(reason.reason, millimetres);
        } else if (advice != Advice::Print && reason.reason.advice == advice) {
            lines << reasonText(reason, result, millimetres); // with the dip's name
        }
    }
    return lines;
}

// Returns the path of a dip in the frame of the machine, which does not move with the water.
std::vector<MotionPose> machinePath(const ImmersionResult& dip) {
    std::vector<MotionPose> poses;
    for (const solver::PathPose& pose : dip.body->path.poses) {
        const Eigen::Vector3d place = Eigen::Map<const Eigen::Vector3d>(pose.pivot.data()) +
                                      pathOriginInTank(dip.immersion, Seconds(pose.seconds));
        const auto& [w, x, y, z] = pose.rotation;
        poses.push_back({Seconds(pose.seconds),
                         {place.x(), -place.z(), place.y()}, // Z up instead of Y
                         Eigen::Quaterniond(w, x, -z, y)});
    }
    return poses;
}

} // namespace

DipMotion jobMotion(const JobResult& result, std::size_t immersion) {
    const ImmersionResult& dip = result.immersions[immersion];
    const ProcessSettings& process = result.project.process;
    DipMotion motion;
    motion.project = result.project.name;
    motion.immersion = dip.immersion.name;
    motion.job = dip.sheet.job.hash;
    motion.start = Millimetres(startHeight);
    motion.depth = Millimetres(dipDepth(process, *dip.body));
    motion.speed = process.dipSpeed;
    motion.path = machinePath(dip);
    if (const auto& tank = result.project.profiles.tank; tank && tank->speed) {
        motion.approach = std::min(motion.approach, *tank->speed);
    }
    return motion;
}

namespace {

// Returns the traveller without its pictures.
Traveller travellerText(const JobResult& result) {
    const Project& project = result.project;
    Traveller traveller;
    traveller.project = project.name;
    traveller.date = project.date;
    if (const std::vector<OrderCost> costs = jobCosts(result, project); tellsCost(costs)) {
        traveller.order = costSentence(costs.back());
    }
    traveller.film = project.film;
    traveller.profiles = project.profiles;
    traveller.pins =
        datumPins(result.immersions.front().sheet, project.film, project.cradle.pinSpan);
    if (result.mask) {
        traveller.masked = maskedAreas(*result.mask);
    }
    for (std::size_t i = 0; i < result.immersions.size(); ++i) {
        const ImmersionResult& immersion = result.immersions[i];
        TravellerDip dip;
        dip.immersion = immersion.immersion;
        dip.job = immersion.sheet.job.hash;
        dip.passes = immersion.sheet.passes;
        dip.motion = jobMotion(result, i);
        dip.waterAtEnd = dip.motion.depth.value();
        if (i < result.cradles.size()) {
            dip.hasCradle = !result.cradles[i].mesh.triangles.empty();
            dip.cradleNotes = result.cradles[i].notes;
        }
        dip.verdict = verdictLines(result, i);
        dip.canBePrinted = adviceOf(result) == Advice::Print;
        dip.body = boundingBox(immersion.body->mesh);
        traveller.dips.push_back(std::move(dip));
    }
    return traveller;
}

} // namespace

TankJob jobAtTank(const JobResult& result, const QString& path) {
    const Traveller traveller = travellerText(result);
    return {traveller.project, path, travellerJob(traveller), tankTasks(traveller)};
}

Traveller jobTraveller(const JobResult& result, const Progress& progress) {
    Traveller traveller = travellerText(result);
    const auto fine = result.fine ? result.fine : fineBody(result.project.model->mesh);
    const auto after = [&](std::size_t dips) {
        return printedBody(result, dips, *fine, 3.0 * afterPixels.width() * afterPixels.height());
    };
    PaintedBody paint = after(0);
    for (std::size_t i = 0; i < result.immersions.size(); ++i) {
        const ImmersionResult& immersion = result.immersions[i];
        const Cradle* cradle = i < result.cradles.size() ? &result.cradles[i] : nullptr;
        const PoseView view{*immersion.body, *fine, paint, cradle ? &cradle->mesh : nullptr,
                            result.mask.get()};
        TravellerDip& dip = traveller.dips[i];
        dip.front = posePicture(view, PoseSide::Front, posePixels, progress.silent());
        dip.right = posePicture(view, PoseSide::Right, posePixels, progress.silent());
        dip.sheet = reduced(immersion.sheet, sheetPixelsAcross);
        paint = after(i + 1);
        const bool isLast = i + 1 == result.immersions.size(); // then the tape is off
        dip.after =
            afterDip({*immersion.body, *fine, paint, nullptr, isLast ? nullptr : result.mask.get()},
                     progress.silent());
    }
    return traveller;
}

} // namespace dipwright
