#include "dip/Dip.h"

#include "base/Error.h"
#include "base/NumberText.h"
#include "dip/FilmFit.h"
#include "dip/FilmUnderBody.h"
#include "film/FilmGrid.h"
#include "film/Growth.h"
#include "geometry/FinerFields.h"
#include "solver/CheckedSolver.h"

#include <QCoreApplication>
#include <algorithm>
#include <chrono>

namespace dipwright {

namespace {

using Clock = std::chrono::steady_clock;

// Interval between calls of the observer.
constexpr auto observerInterval = std::chrono::milliseconds(33);
// Least number of calls of the observer in a short dip.
constexpr int leastObservations = 24;

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Dip)
};

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

Error missedFilm(const Immersion& immersion) {
    return {Text::tr("The part does not meet the film; move it over the film, choose a larger "
                     "film, or give the film smaller cells or more points"),
            immersion.name};
}

// Explains why no film point reached the body.
Error missedFilm(const PosedBody& body, const DistanceField& field, const Immersion& immersion) {
    const double thinnest = thinParts(body.mesh, body.query).thickness;
    if (isFineEnough(field, thinnest)) {
        return missedFilm(immersion);
    }
    return {
        Text::tr(
            "The solver did not find the part: it is only %1 mm thick in places, and the distance "
            "field has cells of %2 mm; make it thicker there, or dip only a section of it")
            .arg(roundedText(thinnest, 2))
            .arg(roundedText(field.spacing, 2)),
        immersion.name};
}

// Checks before any computation that the body comes down on the film and leaves some film round it.
void requireBodyOverFilm(const PosedBody& body, const Immersion& immersion,
                         const FilmSettings& settings, const ProcessSettings& process) {
    const solver::FilmGrid film = filmGrid(settings);
    const BoundingBox box = boundingBox(body.mesh);
    const double x = immersion.offset[0].value();
    const double z = immersion.offset[1].value();
    const Eigen::AlignedBox2d wet = undersideOf(body, process).shadow;
    const Eigen::AlignedBox2d below =
        body.path.isStraightDown()
            ? Eigen::AlignedBox2d(Eigen::Vector2d(box.min().x(), box.min().z()),
                                  Eigen::Vector2d(box.max().x(), box.max().z()))
            : wet;
    const bool over = below.min().x() + x < film.width / 2 &&
                      below.max().x() + x > -film.width / 2 &&
                      below.min().y() + z < film.depth / 2 && below.max().y() + z > -film.depth / 2;
    if (!over) {
        throw missedFilm(immersion);
    }
    requireFilmBeyondBody(wet.translated(Eigen::Vector2d(x, z)), settings, immersion);
}

void requireFollowed(const solver::DipSetup& setup, const solver::SolverModule& module) {
    const bool isProduction =
        solver::isProductionFilm(setup.settings.lattice, setup.settings.support);
    if (!setup.path.isStraightDown() && !(isProduction && module.followsPaths())) {
        throw Error(isProduction
                        ? Text::tr("This solver allows only straight dips; choose another "
                                   "solver, or a straight path")
                        : Text::tr("The film model of the paper allows only straight dips; "
                                   "choose the production film, or a straight path"),
                    QStringLiteral("immersions.path"));
    }
}

// A solver and the loop that drives it. Exceptions of the module pass through.
class Run {
public:
    Run(solver::DipSetup setup, const solver::SolverModule& module) : solver_(module.create()) {
        dip_.setup = std::move(setup);
        dip_.positions.resize(3 * dip_.setup.film.pointCount());
        dip_.states.resize(dip_.setup.film.pointCount());
    }

    void toTheEnd(const Progress& progress, const FilmObserver& observer) {
        if (auto* film = dynamic_cast<StoppableFilm*>(solver_.get())) {
            film->stopOn([user = progress.cancelToken] { return user.isCancelled(); });
        }
        timed([&] { solver_->begin(dip_.setup); });
        Clock::time_point lastShown = Clock::now() - observerInterval;
        double shownDescent = 0;
        const double farthest = dip_.setup.motion.travel / leastObservations;
        while (!state_.finished) {
            progress(state_.descent / dip_.setup.motion.travel, Text::tr("Dipping"));
            const bool isDue = Clock::now() - lastShown >= observerInterval ||
                               state_.descent - shownDescent >= farthest;
            if (observer && isDue && show(observer)) {
                lastShown = Clock::now();
                shownDescent = state_.descent;
            }
            advance();
        }
        dip_.finish(state_, [&](auto positions, auto states, auto marks) {
            solver_->read(positions, states);
            solver_->readMarks(marks);
        });
        if (observer) {
            observer({dip_.setup.film, dip_.positions, dip_.states, state_.descent, state_.steps});
        }
        progress(1, Text::tr("Dipping"));
    }

    DippedFilm film(const Immersion& immersion) const {
        DippedFilm film = dippedFilm(dip_, immersion);
        film.wallSeconds = seconds_;
        return film;
    }

private:
    template <typename Work>
    double timed(const Work& work) {
        const Clock::time_point start = Clock::now();
        work();
        const double seconds = secondsSince(start);
        seconds_ += seconds;
        return seconds;
    }
    // Takes a batch of steps that lasts about a millisecond. Calling a GPU for every single step
    // would cost more time than the step itself.
    void advance() {
        constexpr int mostSteps = 1024;
        constexpr double shortest = 0.5e-3, longest = 2e-3; // s
        const double seconds = timed([&] { state_ = solver_->advance(stepsAtOnce_); });
        if (seconds < shortest && stepsAtOnce_ < mostSteps) {
            stepsAtOnce_ *= 2;
        } else if (seconds > longest && stepsAtOnce_ > 1) {
            stepsAtOnce_ /= 2;
        }
    }
    // Returns whether a film was shown. It may still be in transfer from another device.
    bool show(const FilmObserver& observer) {
        solver::DipState shown = state_;
        const bool hasArrived = solver_->peek(dip_.positions, dip_.states, shown);
        if (hasArrived) {
            observer({dip_.setup.film, dip_.positions, dip_.states, shown.descent, shown.steps});
        }
        return hasArrived;
    }

    solver::BatchItem dip_;
    std::unique_ptr<solver::FilmSolver> solver_;
    solver::DipState state_;
    int stepsAtOnce_ = 1;
    double seconds_ = 0;
};

void requireStable(const DippedFilm& film, double travel, const QString& where) {
    if (!isStable(film, travel)) {
        throw Error(Text::tr("The simulation became unstable; choose a smaller step or time step "
                             "(Dipping > Accuracy)"),
                    where);
    }
}

} // namespace

solver::FilmGrid dipGrid(const PosedBody& body, const Immersion& immersion,
                         const FilmSettings& film, const ProcessSettings& process) {
    return isGraded(film) ? filmUnderBody(film, undersideOf(body, process), immersion.offset)
                          : filmGrid(film);
}

const DistanceField& fieldForFilm(const DistanceField& own, const solver::FilmGrid& grid,
                                  const Progress& progress) {
    return fieldAtLevel(own, fieldLevel(own, grid.leastSpacing()), progress);
}

solver::DipSetup dipSetup(const PosedBody& body, const FilledField& field,
                          const Immersion& immersion, const FilmSettings& film,
                          const ProcessSettings& process) {
    return dipSetup(body, field, immersion, film, dipGrid(body, immersion, film, process), process);
}

solver::DipSetup dipSetup(const PosedBody& body, const FilledField& field,
                          const Immersion& immersion, const FilmSettings& film,
                          const solver::FilmGrid& grid, const ProcessSettings& process) {
    solver::DipSetup setup;
    setup.film = grid;
    const DistanceField& samples = field.field();
    setup.field.distance = samples.distance.data();
    setup.field.size = samples.size;
    setup.field.spacing = samples.spacing;
    Eigen::Map<Eigen::Vector3d>(setup.field.origin.data()) = samples.origin;

    using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    Eigen::Map<RowMajor>(setup.motion.rotation.data()) = body.bodyToPose.linear();
    Eigen::Map<Eigen::Vector3d>(setup.motion.start.data()) =
        body.bodyToPose.translation() + poseToWorld(immersion, 0);
    setup.motion.travel = dipTravel(process, body);
    setup.motion.speed = process.dipSpeed.value();
    if (!body.path.isStraightDown()) {
        setup.path = pathOfModel(body.path, body.bodyToPose, immersion);
    }

    setup.settings.lattice = film.lattice;
    setup.settings.support = film.support;
    setup.settings.contactDistance = film.contactDistance.value();
    setup.settings.relaxationTime = film.relaxationTime.value();
    setup.settings.timeStep = process.timeStep.value();
    setup.settings.iterations = process.iterations;
    setup.settings.relaxation = process.relaxation;
    setup.settings.selfContact = process.selfContact;
    setup.settings.contactTravel = process.contactTravel;
    setup.settings.overhang = radians(process.overhang);
    setup.settings.gripFade = radians(film.gripFade);
    setup.settings.tearStretch = process.tearStretch;
    setup.settings.gatheringStretch = film.gatheringStretch;
    setup.settings.growthRate = film.growthRate;
    setup.settings.growthLimit = film.growthLimit;
    setup.pinned = pinnedPoints(film.edges, setup.film);
    return setup;
}

namespace {

Eigen::Isometry3d bodyToPose(const solver::DipSetup& setup, const Immersion& immersion) {
    using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
    result.linear() = Eigen::Map<const RowMajor>(setup.motion.rotation.data());
    result.translation() =
        Eigen::Map<const Eigen::Vector3d>(setup.motion.start.data()) - poseToWorld(immersion, 0);
    return result;
}

// Returns the translation from the pose frame to the world at the end of a dip.
Eigen::Vector3d shiftAtEnd(const solver::DipSetup& setup, const Immersion& immersion) {
    const double travel = setup.motion.travel;
    if (setup.path.isStraightDown()) {
        return poseToWorld(immersion, travel);
    }
    return (placeOnPath(setup.path, travel) * bodyToPose(setup, immersion).inverse()).translation();
}

// Returns, per film point, how much the film had grown when the point was touched. Assumes that
// this happened when the point's place on the body reached the water.
std::vector<float> grownWhenTouched(const DippedFilm& film, const solver::DipSetup& setup,
                                    const Immersion& immersion) {
    std::vector<float> grown;
    const double begin = poseToWorld(immersion, 0).y();
    const Eigen::Isometry3d toBody = bodyToPose(setup, immersion).inverse();
    for (const Eigen::Vector3f& place : film.positions) {
        double seconds = (begin + double(place.y())) / setup.motion.speed;
        if (!setup.path.isStraightDown()) {
            const auto way = firstUnderWater(setup.path, toBody * place.cast<double>());
            seconds = secondsOnPath(setup.path, way.value_or(setup.motion.travel));
        }
        grown.push_back(float(grownLength(std::max(seconds, 0.0), setup.settings)));
    }
    return grown;
}

} // namespace

void simulateDips(std::vector<solver::BatchItem>& dips, const solver::SolverModule& module,
                  std::function<bool()> isCancelled) {
    const auto cancelled = [](void* context) {
        return (*static_cast<const std::function<bool()>*>(context))();
    };
    bool isDone = dips.empty();
    for (const solver::BatchItem& dip : dips) {
        requireFollowed(dip.setup, module);
    }
    try {
        isDone = isDone || module.runBatch(dips, cancelled, &isCancelled);
    } catch (const std::exception& failure) {
        throw Error(Text::tr("The solver failed: %1").arg(QString::fromUtf8(failure.what())), {});
    }
    if (!isDone) {
        throw Cancelled();
    }
}

bool isAccepted(const DippedFilm& dipped, const PosedBody& body, const Immersion& immersion,
                const FilmSettings& film, const ProcessSettings& process) {
    try {
        requireBodyOverFilm(body, immersion, film, process);
    } catch (const Error&) {
        return false;
    }
    return dipped.adheresAnywhere();
}

DippedFilm dippedFilm(const solver::BatchItem& dip, const Immersion& immersion) {
    DippedFilm film;
    film.grid = dip.setup.film;
    film.isotropic = dip.setup.settings.lattice == solver::Lattice::Isotropic;
    film.states = dip.states;
    film.marks = dip.marks;
    film.steps = dip.steps;
    film.equilibrium = dip.equilibrium;
    const Eigen::Vector3d shift = shiftAtEnd(dip.setup, immersion);
    film.positions.reserve(dip.states.size());
    for (std::size_t point = 0; point < dip.states.size(); ++point) {
        const Eigen::Vector3d world =
            Eigen::Map<const Eigen::Vector3f>(&dip.positions[3 * point]).cast<double>();
        film.positions.push_back((world - shift).cast<float>());
    }
    if (grows(dip.setup.settings)) {
        film.grown = grownWhenTouched(film, dip.setup, immersion);
    }
    return film;
}

bool isStable(const DippedFilm& film, double travel) {
    const double farthest = 10 * (film.grid.width + film.grid.depth + travel);
    return std::all_of(
        film.positions.begin(), film.positions.end(), [&](const Eigen::Vector3f& position) {
            return position.allFinite() && double(position.cwiseAbs().maxCoeff()) <= farthest;
        });
}

DippedFilm simulateDip(const PosedBody& body, const DistanceField& field,
                       const Immersion& immersion, const FilmSettings& film,
                       const ProcessSettings& process, const solver::SolverModule& module,
                       const Progress& progress, const FilmObserver& observer) {
    requireBodyOverFilm(body, immersion, film, process);
    const solver::FilmGrid grid = dipGrid(body, immersion, film, process);
    const FilledField filled(body, fieldForFilm(field, grid, progress.part(0, 0)));
    const solver::DipSetup setup = dipSetup(body, filled, immersion, film, grid, process);
    requireFollowed(setup, module);
    DippedFilm dipped;
    try {
        Run run(setup, module);
        run.toTheEnd(progress, observer);
        dipped = run.film(immersion);
    } catch (const Cancelled&) {
        throw;
    } catch (const Error&) {
        throw;
    } catch (const std::exception& failure) {
        throw Error(Text::tr("The solver failed: %1").arg(QString::fromUtf8(failure.what())),
                    immersion.name);
    } catch (...) {
        throw Error(Text::tr("The solver failed with an unknown exception"), immersion.name);
    }
    requireStable(dipped, setup.motion.travel, immersion.name);
    if (!dipped.adheresAnywhere()) {
        throw missedFilm(body, field, immersion);
    }
    return dipped;
}

} // namespace dipwright
