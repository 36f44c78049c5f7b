#include "workbench/dip/DipJob.h"

#include "sheet/page/SheetLayout.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>

namespace dipwright {

namespace {

constexpr std::size_t mostFrames = 240;
constexpr double previewResolution = 150; // dpi
constexpr double longestPreview = 2800;   // pixels
constexpr double dipDone = 0.95;

} // namespace

DipRecordings makeRecordings(const Project& project, std::size_t mostPoints) {
    DipRecordings recordings;
    for (const Immersion& immersion : project.immersions) {
        recordings.push_back(std::make_shared<DipRecording>(immersion, mostPoints, mostFrames));
    }
    return recordings;
}

SheetPreview sheetPreview(const Sheet& sheet) {
    const SheetLayout layout = sheetLayout(sheet);
    SheetPreview preview{{}, layout.page, layout.film};
    const double longest = std::max(layout.page.width(), layout.page.height());
    const double pixels =
        std::min(previewResolution / millimetresPerInch, longestPreview / longest);
    preview.page = QImage((layout.page * pixels).toSize(), QImage::Format_RGB32);
    preview.page.fill(Qt::white);
    QPainter painter(&preview.page);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    painter.scale(preview.page.width() / layout.page.width(),
                  preview.page.height() / layout.page.height());
    paintSheet(painter, sheet);
    return preview;
}

DipJob::DipJob(const Project& project, const SolverRegistry& registry,
               std::shared_ptr<const JobResult> previous, DipRecordings recordings, Done done,
               Failed failed)
    : project_(project), registry_(registry), previous_(std::move(previous)),
      recordings_(std::move(recordings)), done_(std::move(done)), failed_(std::move(failed)) {}

QString DipJob::title() const {
    return QCoreApplication::translate("DipJob", "Simulating the dip");
}

void DipJob::process(const Progress& progress) {
    JobOptions options;
    options.observer = [this](std::size_t immersion, const FilmFrame& frame) {
        recordings_[immersion]->add(frame);
    };
    outcome_.result = std::make_shared<JobResult>(
        runJob(project_, registry_, options, previous_.get(), progress.part(0, dipDone)));
    for (const ImmersionResult& immersion : outcome_.result->immersions) {
        progress(dipDone, QCoreApplication::translate("DipJob", "Preparing the views"));
        outcome_.readings.push_back(std::make_shared<FilmReadout>(immersion.laid));
        progress.cancelToken.throwIfCancelled();
        outcome_.sheets.push_back(sheetPreview(immersion.sheet));
    }
}

void DipJob::finalize(bool cancelled, std::exception_ptr failure) {
    if (cancelled || failure) {
        failed_(cancelled, failure);
    } else {
        done_(outcome_);
    }
}

} // namespace dipwright
