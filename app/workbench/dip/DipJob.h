// The main job, on the worker thread: computes the result of a project, records the film during the
// dips, and prepares the previews and readouts for the window.
#pragma once

#include "pipeline/Pipeline.h"
#include "workbench/dip/DipRecording.h"
#include "workbench/dip/FilmReadout.h"
#include "workbench/jobs/Job.h"

namespace dipwright {

// Makes one recording for each dip. The job and the view share the recordings.
using DipRecordings = std::vector<std::shared_ptr<DipRecording>>;
DipRecordings makeRecordings(const Project& project, std::size_t mostPoints);

// A sheet's page as it prints, at a resolution for the screen.
struct SheetPreview {
    QImage page;
    QSizeF size; // page size, mm
    QRectF film; // the film's place on the page, mm
};
SheetPreview sheetPreview(const Sheet& sheet); // throws Error as pageSize() does

struct DipOutcome {
    std::shared_ptr<const JobResult> result;
    std::vector<std::shared_ptr<const FilmReadout>> readings; // one for each dip
    std::vector<SheetPreview> sheets;
};

class DipJob : public Job {
public:
    using Done = std::function<void(const DipOutcome&)>;
    using Failed = std::function<void(bool cancelled, std::exception_ptr)>;

    // Reuses the parts of `previous` (may be null) that still fit the project.
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
