// The main job, on the worker thread: computes a draft or the result of a project, records the film
// during the dips, and prepares the previews and readouts for the window.
#pragma once

#include "pipeline/InkOptions.h"
#include "pipeline/JobDraft.h"
#include "pipeline/JobWarnings.h"
#include "workbench/dip/DipRecording.h"
#include "workbench/dip/FilmReadout.h"
#include "workbench/jobs/Job.h"

namespace dipwright {

using DipRecordings = std::vector<std::shared_ptr<const DipRecording>>;

// A sheet's page as it prints, at a resolution for the screen.
struct SheetPreview {
    QImage page;
    QSizeF size; // page size, mm
    QRectF film; // the film's place on the page, mm
};
SheetPreview sheetPreview(const Sheet& sheet); // throws Error as pageSize() does

// How fine a result is (pipeline/JobDraft.h).
struct Fineness {
    int level = 0;               // 0: the job itself
    int coarsest = 0;            // level of the first draft
    std::optional<double> moves; // mm since the previous draft, movesSince(); none: not known
    bool isDraft() const { return level > 0; }
};

struct DipOutcome {
    std::shared_ptr<const JobResult> result;
    std::vector<std::shared_ptr<const FilmReadout>> readings; // one for each dip
    std::vector<SheetPreview> sheets;
    Project project = {}; // the project that was run; `result` of a draft has a coarser one
    Fineness fineness = {};
    std::vector<JobWarning> warnings = {};     // empty for a draft
    std::optional<InkOptions> inkOptions = {}; // none for a draft, or if ink suffices
    QImage portrait = {};                      // portraitOf(); null for a draft
    DipRecordings recordings = {}; // one for each dip; null for a draft or a dip that was reused
};

// Which results a job computes.
enum class DipStage { FirstDraft, NextDraft, Job, Refinement };

class DipJob : public Job {
public:
    // What the job computes, and what it can reuse.
    struct Task {
        Project project;
        DipStage stage = DipStage::Job;
        DipOutcome before;          // for NextDraft: the previous draft
        JobDrafts earlier;          // results to reuse
        std::size_t mostPoints = 0; // number of film points that are recorded, approximately
    };
    using Done = std::function<void(const DipOutcome&)>;
    // `fineness` is that of the failed draft or job.
    using Failed =
        std::function<void(const Fineness& fineness, bool cancelled, std::exception_ptr)>;

    DipJob(Task task, const SolverRegistry& registry, Done done, Failed failed);

    QString title() const override;
    void process(const Progress& progress) override;
    void finalize(bool cancelled, std::exception_ptr failure) override;

private:
    void record(std::size_t immersion, const FilmFrame& frame);

    Task task_;
    const SolverRegistry& registry_;
    Done done_;
    Failed failed_;
    DipOutcome outcome_;
    std::vector<std::vector<std::shared_ptr<DipRecording>>> recordings_; // of each immersion
};

} // namespace dipwright
