// A part dipped with a film whose numbers are hidden, photographed by cameras of its own: what a
// fit is given, and what it has to find.
#pragma once

#include "PartPhoto.h"
#include "inspection/FilmFit.h"
#include "project/Project.h"

namespace dipwright::test {

struct Hidden {
    double swellX = 1, swellY = 1;
    double relaxation = 0; // s
    double shiftX = 0, shiftZ = 0, turn = 0;
};

// Where a camera stands: degrees round the vertical, and above the horizon.
struct Standpoint {
    double round = 0, above = 0;
};

// One camera, seen from several places; looks all but at the model's origin from `distance` mm.
// `pixels` wide and as high.
std::vector<PhotoCamera> camerasRound(const std::vector<Standpoint>& from, double distance,
                                      double focalLength, int pixels);

// A solver whose film is that of solvers/production/reference, which shares no arithmetic with the
// one that is fitted: a tank that the program knows nothing of. Slow.
const solver::SolverModule& referenceTank();

// The project as its owner believes it to be, and the film that was really on the body, of other
// cells and with other steps.
class PhotographedPart {
public:
    // `cell`: of the film in the tank, mm.
    PhotographedPart(Project believed, const Hidden& hidden, double cell,
                     const solver::SolverModule& program, const solver::SolverModule& tank);
    PhotographedPart(Project believed, const Hidden& hidden, double cell,
                     const solver::SolverModule& both)
        : PhotographedPart(std::move(believed), hidden, cell, both, both) {}

    const Project& project() const { return believed_; }
    const DistanceField& field() const { return *field_; }
    std::shared_ptr<const LaidFilm> believedFilm() const { return meant_; }
    std::shared_ptr<const LaidFilm> filmInTank() const { return truly_; }
    const FilmSettings& settingsInTank() const { return real_; }
    // A photo from each camera: `printed` places in each, or all that it sees where that is fewer,
    // and `body` of the body's own, each off by `noise` pixels.
    FitPairs pairs(const std::vector<PhotoCamera>& cameras, int printed, int body, double noise,
                   int seed) const;

private:
    struct Corner {
        Eigen::Vector2d sheet;
        Eigen::Vector3d lies, outward, meant;
    };
    std::shared_ptr<const LaidFilm> dipped(const Project& project,
                                           const solver::SolverModule& module) const;
    void gatherCorners();

    Project believed_;
    FilmSettings real_;
    std::shared_ptr<const DistanceField> field_;
    std::shared_ptr<const LaidFilm> meant_, truly_;
    std::vector<Corner> corners_; // of a chessboard on the sheet, all that are on the body
    std::vector<Corner> body_;    // spread over it
};

// Where a place of the sheet lies on the model on which that film has come to lie; nothing where it
// does not lie on the body.
std::optional<Eigen::Vector3d> onModel(const LaidFilm& laid, const Eigen::Vector2d& sheet,
                                       const FilmSettings& film);

// An egg 56 mm wide and so many times as high, on film with cells of so many mm.
Project eggToFit(double height, double cell);

} // namespace dipwright::test
