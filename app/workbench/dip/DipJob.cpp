#include "workbench/dip/DipJob.h"

#include "pipeline/PrintedBody.h"
#include "sheet/page/SheetLayout.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>

namespace dipwright {

namespace {

constexpr std::size_t mostFrames = 240;
constexpr double previewResolution = 150; // dpi, if the sheet has as many
constexpr double longestPreview = 2800;   // pixels
constexpr double dipDone = 0.95;
constexpr QSize portraitSize(384, 240);

} // namespace

SheetPreview sheetPreview(const Sheet& sheet) {
    const SheetLayout layout = sheetLayout(sheet);
    SheetPreview preview{{}, layout.page, layout.film};
    const double longest = std::max(layout.page.width(), layout.page.height());
    const double resolution = std::min(previewResolution, sheet.settings.resolution.value());
    const double pixels = std::min(resolution / millimetresPerInch, longestPreview / longest);
    preview.page = QImage((layout.page * pixels).toSize(), QImage::Format_RGB32);
    preview.page.fill(Qt::white);
    QPainter painter(&preview.page);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    painter.scale(preview.page.width() / layout.page.width(),
                  preview.page.height() / layout.page.height());
    paintSheet(painter, sheet);
    return preview;
}

DipJob::DipJob(Task task, const SolverRegistry& registry, Done done, Failed failed)
    : task_(std::move(task)), registry_(registry), done_(std::move(done)),
      failed_(std::move(failed)) {}

QString DipJob::title() const {
    return task_.stage == DipStage::Refinement
               ? QCoreApplication::translate("DipJob", "Refining the film")
               : QCoreApplication::translate("DipJob", "Simulating the dip");
}

// A film that is refined is dipped several times, each time with more points. One of these dips is
// the result.
void DipJob::record(std::size_t immersion, const FilmFrame& frame) {
    auto& recordings = recordings_[immersion];
    if (recordings.empty() || recordings.back()->grid().pointCount() != frame.grid.pointCount()) {
        recordings.push_back(std::make_shared<DipRecording>(task_.project.immersions[immersion],
                                                            task_.mostPoints, mostFrames));
    }
    recordings.back()->add(frame);
}

void DipJob::process(const Progress& progress) {
    outcome_.project = task_.project;
    Fineness& fineness = outcome_.fineness;
    if (task_.stage == DipStage::FirstDraft) {
        fineness.coarsest = coarsestDraft(task_.project, task_.earlier);
        fineness.level = fineness.coarsest;
    } else if (task_.stage == DipStage::NextDraft) {
        fineness.coarsest = task_.before.fineness.coarsest;
        fineness.level = task_.before.fineness.level - 1;
    } else if (task_.stage == DipStage::Refinement) {
        fineness.level = refinedLevel;
    }
    recordings_.resize(task_.project.immersions.size());
    const auto result = std::make_shared<const JobResult>(runLevel(
        task_.project, fineness.level, fineness.coarsest, registry_, task_.earlier,
        progress.part(0, dipDone),
        [this](std::size_t immersion, const FilmFrame& frame) { record(immersion, frame); }));
    for (std::size_t number = 0; number < recordings_.size(); ++number) {
        const std::size_t points = result->immersions[number].laid->film().grid.pointCount();
        const auto& recordings = recordings_[number];
        const auto found =
            std::find_if(recordings.begin(), recordings.end(), [&](const auto& recording) {
                return recording->grid().pointCount() == points;
            });
        outcome_.recordings.push_back(found == recordings.end() ? nullptr : *found);
    }
    if (fineness.isDraft() && task_.before.result) {
        fineness.moves = movesSince(*task_.before.result, *result);
    }
    outcome_.result = result;
    for (const ImmersionResult& immersion : result->immersions) {
        progress(dipDone, QCoreApplication::translate("DipJob", "Preparing the views"));
        outcome_.readings.push_back(std::make_shared<FilmReadout>(immersion.laid));
        progress.cancelToken.throwIfCancelled();
        outcome_.sheets.push_back(sheetPreview(immersion.sheet));
    }
    if (!fineness.isDraft()) {
        outcome_.warnings = jobWarnings(*result);
        outcome_.inkOptions = inkOptions(*result, progress.silent());
        outcome_.portrait = portraitOf(*result, portraitSize, progress.cancelToken);
    }
}

void DipJob::finalize(bool cancelled, std::exception_ptr failure) {
    if (cancelled || failure) {
        failed_(outcome_.fineness, cancelled, failure);
    } else {
        done_(outcome_);
    }
}

} // namespace dipwright
