// Simulates the dips of many poses in batches. Private to this folder.
#pragma once

#include "accuracy/error/NumericalErrorEstimate.h"
#include "base/Progress.h"
#include "dip/FilledField.h"
#include "search/JudgedPose.h"
#include "search/SearchSubject.h"

#include <functional>
#include <limits>

namespace dipwright {

// The resolution of a dip; never finer than the job's.
struct DipDetail {
    double cells;    // number of film cells along the longest edge of the body's box
    int field;       // number of distance field cells along that edge
    double travel;   // least travel of the contact line in one step, in film cells
    double residual; // solver::Settings::residual
    // Whether to find what the prediction of the job's sheet needs: JudgedPose::jobCell, and a
    // verdict without the numerical error.
    bool predicts = false;
};
// coarseDetail finds poses worth refining; their dips get measures only. finerDetail ranks them and
// predicts. jobDetail is the job's own: its dips get the verdict that the job is expected to give
// after refinement, and JudgedPose::doublings. A dip that fails must not be printed.
inline constexpr DipDetail coarseDetail{20, 128, 0.5, 3e-3},
    finerDetail{40, 128, 0.5, solver::Settings().residual, true},
    jobDetail{std::numeric_limits<double>::infinity(), std::numeric_limits<int>::max(), 0,
              solver::Settings().residual};

// Number of air grid cells along the body's longest edge (posedBody()) in coarse and finer dips.
// Dips of the job's detail have the job's number.
inline constexpr int searchedAirCells = 48;

// Returns the limits of the subject's tank that a dip exceeds. `posed` is the body in its pose
// frame, `path` its path there.
std::vector<TankFault> tankFaultsOf(const SearchSubject& subject, const TriangleMesh& posed,
                                    const solver::BodyPath& path, const Immersion& immersion);

// The films for the dips of a search at one resolution. Keeps a reference to the subject.
class PoseFilms {
public:
    PoseFilms(const SearchSubject& subject, const DipDetail& detail);

    const FilmSettings& film() const { return film_; }
    // Returns the body in the pose of its dip.
    PosedBody posed(const Immersion& immersion) const;
    // Returns the film's points for a pose. Throws like filmUnderBody().
    // `refinement` multiplies the number of cells of the job's film along both edges.
    solver::FilmGrid gridOf(const PosedBody& body, const Immersion& immersion,
                            double refinement = 1) const;
    // Returns the number of points of this film.
    std::size_t pointsFor(const Immersion& immersion) const;
    // Returns the time that a dip takes, within about a third, in units that are the same for all
    // resolutions.
    double cost(const PosedBody& body, const Immersion& immersion) const;
    // Returns the size of the film's cells over the body, mm.
    double cellUnder(const PosedBody& body) const;
    bool areJobs() const { return areJobs_; } // jobDetail

private:
    // Returns the film's points where the search chooses its cells: fine ones over the body.
    solver::FilmGrid gradedGrid(const Immersion& immersion) const;

    const SearchSubject& subject_;
    bool areJobs_;
    FilmSettings film_;
    std::unique_ptr<const SurfaceQuery>
        query_; // of the model; null unless the search chooses the cells
};

// Returns the resolution of the body's usual distance field (cachedDistanceField()) for dips with
// this detail.
int fieldResolution(const SearchSubject& subject, const DipDetail& detail);

class PoseDips {
public:
    // `field` must be the body's distance field of fieldResolution().
    PoseDips(const SearchSubject& subject, const JudgedBody& body,
             const solver::SolverModule& module, const DipDetail& detail,
             std::shared_ptr<const DistanceField> field, const CancelToken& cancelToken);

    // Simulates a dip with each of `immersions` and stores its result in `judged` at the same
    // index; both have the same length. After an exception the results of all batches that the
    // solver finished remain. While the solver simulates a batch, other threads judge the batch
    // before and set up the next. Calls `batchDone` after each batch with the number of finished
    // dips. The first batch has at most `first` dips. A dip that misses the film or becomes
    // unstable has no samples. Throws Error if the solver fails. Throws Cancelled.
    void dip(const std::vector<Immersion>& immersions,
             std::vector<std::shared_ptr<const JudgedPose>>& judged,
             const std::function<void(std::size_t)>& batchDone,
             std::size_t first = std::numeric_limits<std::size_t>::max()) const;

    // Returns these dips with the films with which the job would end: repeats them with smaller
    // cells as the job would. All must have the job's film. A dip that fails with smaller cells, as
    // when the solver fails, keeps the film before and the verdict on it. Calls `roundDone` after
    // each round of dips. Ends after a round in which a dip got its final film and still cannot be
    // printed; then the others may lack their final films. Throws Cancelled.
    std::vector<std::shared_ptr<const JudgedPose>>
    withFinalFilms(std::vector<std::shared_ptr<const JudgedPose>> dips,
                   const std::function<void()>& roundDone) const;

private:
    struct Range {
        std::size_t first = 0, last = 0; // places in the list of immersions; `last` is excluded
    };
    // Dips that are simulated together; they follow each other in the list of immersions.
    struct Batch {
        std::size_t first = 0; // place of the first dip in the list
        std::vector<std::shared_ptr<const PosedBody>> bodies;
        std::vector<std::optional<FilledField>> fields; // empty after simulate()
        std::vector<solver::BatchItem> items;
        std::vector<std::unique_ptr<CoarserDips>> coarser; // null if the film is not the job's
        // The films that have too large cells; null if the film is not refined.
        std::vector<const JobFilms*> before;
    };

    std::vector<Range> batches(const std::vector<Immersion>& immersions, std::size_t first) const;
    // `before`: for each dip of the range, Batch::before; empty: no film is refined.
    Batch setUp(const std::vector<Immersion>& immersions, Range range,
                std::vector<const JobFilms*> before = {}) const;
    void buildFields(const std::vector<solver::FilmGrid>& grids) const;
    void simulate(const std::vector<Immersion>& immersions, Batch& batch) const;
    void judge(const std::vector<Immersion>& immersions, Batch& batch,
               std::vector<std::shared_ptr<const JudgedPose>>& judged) const;
    JudgedPose judgedDip(Batch& batch, std::size_t item, const Immersion& immersion) const;
    // Sets the films, the pale places, the verdict with the numerical error, and the doublings.
    void judgeAsJob(JudgedPose& pose, std::shared_ptr<const LaidFilm> laid, CoarserFilms coarser,
                    const JobFilms* before) const;
    // Repeats each dip with the smaller cells that it needs. Null for dips that fail.
    std::vector<std::shared_ptr<const JudgedPose>>
    refined(const std::vector<std::shared_ptr<const JudgedPose>>& dips) const;
    // The same after a failure, one dip at a time. Null for a single dip.
    std::vector<std::shared_ptr<const JudgedPose>>
    refinedAlone(const std::vector<std::shared_ptr<const JudgedPose>>& dips) const;
    Verdict verdictOf(const LaidFilm& laid, const Coverage& covered,
                      const NumericalErrorEstimate* error,
                      const std::vector<TankFault>& tankFaults) const;

    const SearchSubject& subject_;
    const JudgedBody& body_;
    const solver::SolverModule& module_;
    const CancelToken cancelToken_;
    PoseFilms films_;
    std::unique_ptr<const PoseFilms> jobFilms_; // if sheets are predicted
    ProcessSettings process_;
    double residual_;
    std::shared_ptr<const DistanceField> field_;
};

} // namespace dipwright
