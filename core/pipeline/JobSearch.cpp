#include "pipeline/JobSearch.h"

#include "artwork/PaintArtwork.h"
#include "base/Error.h"
#include "base/Sha256.h"
#include "marks/SurfaceMask.h"
#include "model/ModelHash.h"
#include "project/Project.h"
#include "settings/SheetSettings.h"

#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(PoseSearch)
};

// Returns a project with only what a search depends on. It has no poses, because a search tries
// others.
Project searchedPart(const Project& project) {
    Project part;
    part.model = project.model;
    part.artwork = project.artwork;
    part.sheet.white =
        project.sheet.white == WhiteLayer::None ? WhiteLayer::None : WhiteLayer::Last;
    part.film = project.film;
    part.process = project.process;
    part.fieldResolution = project.fieldResolution;
    part.tolerance = project.tolerance;
    part.masks = project.masks;
    part.verdict = project.verdict;
    part.ink = project.ink;
    part.share.registrationError = project.share.registrationError;
    part.profiles.tank = withoutCosts(project.profiles).tank;
    return part;
}

// Returns a hash of everything that the first dips of a search depend on, except the poses.
QByteArray identityOf(Project searched, const QString& solver) {
    searched.verdict = {}; // these three only rank the dips
    searched.share = {};
    searched.profiles.tank.reset();
    QJsonObject counting = toJson(searched);
    counting[QLatin1String("model")] = modelHash(searched.model);
    counting[QLatin1String("solver")] = solver;
    return sha256(QJsonDocument(counting).toJson(QJsonDocument::Compact));
}

// Size of a texel. Coarse texels suffice, because the search only needs to know where the artwork
// has ink.
constexpr double texel = 0.5; // mm

} // namespace

SearchSubject searchSubject(const Project& project, const QString& solver) {
    if (!project.model) {
        throw Error(Text::tr("The project has no model; import one first"), project.name);
    }
    const Project part = searchedPart(project); // so that haveSameSearchSubject() misses nothing
    SearchSubject subject;
    subject.name = project.name;
    subject.identity = identityOf(part, solver);
    subject.model = painted(part.model, part.artwork, texel, {});
    subject.isWhitePrinted = part.sheet.white != WhiteLayer::None;
    subject.film = part.film;
    subject.process = part.process;
    subject.fieldResolution = part.fieldResolution;
    subject.tolerance = part.tolerance;
    subject.mask = surfaceMask(subject.model, part.masks);
    subject.verdict = part.verdict;
    subject.ink = part.ink;
    subject.registrationError = part.share.registrationError;
    subject.tank = part.profiles.tank;
    subject.immersions = project.immersions;
    return subject;
}

bool haveSameSearchSubject(const Project& first, const Project& second) {
    return searchedPart(first) == searchedPart(second);
}

std::shared_ptr<const JobResult> foundDips(Project project, const RankedPoses& poses,
                                           const SolverInfo& solver) {
    if (poses.films.empty() || std::count(poses.films.begin(), poses.films.end(), nullptr) > 0) {
        return nullptr;
    }
    project.immersions = poses.immersions;
    auto result = std::make_shared<JobResult>();
    result->wantedSolver = project.process.solver;
    result->chosenSolver = solver.id;
    for (std::size_t number = 0; number < poses.films.size(); ++number) {
        const std::shared_ptr<const JobFilms>& films = poses.films[number];
        ImmersionResult& dip = result->immersions.emplace_back();
        dip.immersion = project.immersions[number];
        dip.inputs.texture.dip = dipInputs(project, number, solver.id);
        dip.solver = solver;
        dip.laid = films->own;
        // The body belongs to its film, which keeps it alive.
        dip.body = std::shared_ptr<const PosedBody>(films->own, &films->own->body());
        dip.refinement = films->refinement;
        if (films->error->failure.isEmpty()) { // a failed comparison is tried again
            dip.numericalError = films->error;
            dip.coarser = films->coarser;
        }
    }
    result->project = std::move(project);
    return result;
}

} // namespace dipwright
