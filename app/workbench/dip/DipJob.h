// The main job on the worker thread: simulates, reverses the texture, lays out the sheets, records
// the film on its way and makes ready what the window shows of the result.
#pragma once

#include "pipeline/Pipeline.h"
#include "workbench/dip/DipRecording.h"
#include "workbench/dip/FilmReadout.h"
#include "workbench/jobs/Job.h"

namespace dipwright {

// One recording an immersion; shared between the job and who watches it.
using DipRecordings = std::vector<std::shared_ptr<DipRecording>>;
DipRecordings makeRecordings(const Project& project, std::size_t mostPoints);

// A page as it prints, at a resolution for the screen.
struct SheetPreview {
    QImage page;
    QSizeF size; // of the page, mm
    QRectF film; // on the page, mm
};
SheetPreview sheetPreview(const Sheet& sheet); // throws Error as pageSize() does

struct DipOutcome {
    std::shared_ptr<const JobResult> result;
    std::vector<std::shared_ptr<const FilmReadout>> readings; // an immersion each
    std::vector<SheetPreview> sheets;
};

class DipJob : public Job {
public:
    using Done = std::function<void(const DipOutcome&)>;
    using Failed = std::function<void(bool cancelled, std::exception_ptr)>;

    // `previous` (may be null) is taken over as far as it still fits.
    DipJob(const Project& project, const SolverRegistry& registry,
           std::shared_ptr<const JobResult> previous, DipRecordings recordings, Done done,
           Failed failed);

    QString title() const override;
    void process(const Progress& progress) override;
    void finalize(bool cancelled, std::exception_ptr failure) override;

private:
    Project project_;
    const SolverRegistry& registry_;
    std::shared_ptr<const JobResult> previous_;
    DipRecordings recordings_;
    Done done_;
    Failed failed_;
    DipOutcome outcome_;
};

} // namespace dipwright
