#include "pipeline/JobSearch.h"

#include "artwork/PaintArtwork.h"
#include "base/Error.h"
#include "base/Sha256.h"
#include "marks/SurfaceMask.h"
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

bool isWhitePrinted(const Project& project) {
    return project.sheet.white != WhiteLayer::None;
}

// Returns a hash of everything that the dips of a search depend on, except the poses.
QByteArray identityOf(const Project& project, const QString& solver) {
    const QJsonObject whole = toJson(project);
    QJsonObject counting;
    for (const QLatin1String key :
         {QLatin1String("model"), QLatin1String("artwork"), QLatin1String("film"),
          QLatin1String("process"), QLatin1String("body"), QLatin1String("tolerance"),
          QLatin1String("masks"), QLatin1String("ink")}) {
        if (whole.contains(key)) {
            counting[key] = whole[key];
        }
    }
    counting[QLatin1String("white")] = isWhitePrinted(project);
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
    SearchSubject subject;
    subject.name = project.name;
    subject.identity = identityOf(project, solver);
    subject.model = painted(project.model, project.artwork, texel, {});
    subject.isWhitePrinted = isWhitePrinted(project);
    subject.film = project.film;
    subject.process = project.process;
    subject.fieldResolution = project.fieldResolution;
    subject.tolerance = project.tolerance;
    subject.mask = surfaceMask(subject.model, project.masks);
    subject.verdict = project.verdict;
    subject.ink = project.ink;
    subject.registrationError = project.share.registrationError;
    subject.tank = project.profiles.tank;
    subject.immersions = project.immersions;
    return subject;
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
