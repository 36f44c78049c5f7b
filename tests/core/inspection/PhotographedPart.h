// Provides photos of a part that was dipped with a film of hidden values. Tests fit the photos and
// compare the result with the hidden values.
#pragma once

#include "PartPhoto.h"
#include "inspection/FilmFit.h"
#include "project/Project.h"

namespace dipwright::test {

struct Hidden {
    double swellX = 1, swellY = 1;
    double relaxation = 0; // s
    double shiftX = 0, shiftZ = 0, turn = 0;
    double deeper = 0; // mm, than the project's depth
};

// The direction to a camera: degrees around the vertical and degrees above the horizon.
struct Standpoint {
    double round = 0, above = 0;
};

// Returns one camera at several standpoints. It looks approximately at the model's origin from
// `distance` mm. Its pictures are `pixels` wide and high.
std::vector<PhotoCamera> camerasAround(const std::vector<Standpoint>& from, double distance,
                                       double focalLength, int pixels);

// Returns a solver that stands for the tank, independent of the program. It is the reference solver
// of solvers/production/reference, which shares no arithmetic with the fitted solver. Slow.
const solver::SolverModule& referenceTank();

// A project with the values that its owner believes, and the film that was really on the body. The
// real film has other cells and steps than the project's.
class PhotographedPart {
public:
    // `cell` is the cell of the film in the tank, mm.
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
    // Returns the pairs of one photo from each camera. There are up to `printed` places of the
    // print and up to `body` places of the body, with `noise` pixels of error.
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
    std::vector<Corner> corners_; // corners of the sheet's chessboard that are on the body
    std::vector<Corner> body_;    // places spread over the body
};

// Returns the place on the model where the film of a place of the sheet lies; none if this film is
// not on the body.
std::optional<Eigen::Vector3d> onModel(const LaidFilm& laid, const Eigen::Vector2d& sheet,
                                       const FilmSettings& film);

// Returns a project with an egg that is 56 mm wide and `height` times as high. `cell` is the film's
// cell, mm.
Project eggToFit(double height, double cell);

} // namespace dipwright::test
