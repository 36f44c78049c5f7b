// A photographed part that was dipped with a film of hidden values. Tests give a fit the photos and
// compare it with the hidden values.
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

// The direction to a camera: degrees round the vertical and above the horizon.
struct Standpoint {
    double round = 0, above = 0;
};

// One camera that photographs from several places. It looks nearly at the model's origin from
// `distance` mm. Its pictures are `pixels` wide and high.
std::vector<PhotoCamera> camerasRound(const std::vector<Standpoint>& from, double distance,
                                      double focalLength, int pixels);

// A tank that is independent of the program: the reference solver of solvers/production/reference,
// which shares no arithmetic with the fitted solver. Slow.
const solver::SolverModule& referenceTank();

// A project with the values that its owner believes, and the film that was really on the body. That
// film has other cells and steps.
class PhotographedPart {
public:
    // `cell`: the cell of the film in the tank, mm.
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
    // The pairs of one photo from each camera: up to `printed` places of the print and up to `body`
    // places of the body, with `noise` pixels of error.
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
    std::vector<Corner> corners_; // those of the sheet's chessboard that are on the body
    std::vector<Corner> body_;    // places spread over the body
};

// The place on the model where the film of the sheet's place lies; nothing if it is not on the
// body.
std::optional<Eigen::Vector3d> onModel(const LaidFilm& laid, const Eigen::Vector2d& sheet,
                                       const FilmSettings& film);

// A project with an egg 56 mm wide and `height` times as high. `cell`: the film's cell, mm.
Project eggToFit(double height, double cell);

} // namespace dipwright::test
