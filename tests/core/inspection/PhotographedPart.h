// A part dipped with a film whose numbers are hidden, photographed by a camera of its own: what a
// fit is given, and what it has to find.
#pragma once

#include "dip/LaidFilm.h"
#include "inspection/FilmFit.h"
#include "solver/SolverRegistry.h"

#include <random>

namespace dipwright::test {

struct Hidden {
    double swellX = 1, swellY = 1;
    double relaxation = 0; // s
    double shiftX = 0, shiftZ = 0, turn = 0;
};

// Where a camera stands: degrees round the vertical, and above the horizon; it looks at the middle
// of the body.
struct Standpoint {
    double round = 0, above = 0;
};

// Pinholes written down once more, with distortion; `pixels` wide and as high.
class TrueCamera {
public:
    TrueCamera(const std::vector<Standpoint>& from, const Eigen::Vector3d& middle, double distance,
               double focalLength, int pixels);
    Eigen::Vector2d seen(int photo, const Eigen::Vector3d& model) const;
    bool faces(int photo, const Eigen::Vector3d& model, const Eigen::Vector3d& outward) const;
    QSize picture() const { return {pixels_, pixels_}; }

private:
    struct Photo {
        Eigen::Matrix3d turn;
        Eigen::Vector3d shift;
    };
    std::vector<Photo> photos_;
    double focalLength_; // half diagonals
    int pixels_;
};

// The project as its owner believes it to be, and the film that was really on the body, of other
// cells and with other steps.
class PhotographedPart {
public:
    PhotographedPart(Project believed, const Hidden& hidden, double cell,
                     const SolverRegistry& registry);

    const Project& project() const { return believed_; }
    const DistanceField& field() const { return *field_; }
    std::shared_ptr<const LaidFilm> believedFilm() const { return meant_; }
    // `printed` places in each photo and `body` of the body's own, each off by `noise` pixels.
    FitPairs pairs(const TrueCamera& camera, int photos, int printed, int body, double noise,
                   int seed) const;

private:
    struct Corner {
        Eigen::Vector2d sheet;
        Eigen::Vector3d lies, outward, meant;
    };
    Project believed_;
    std::shared_ptr<const DistanceField> field_;
    std::shared_ptr<const LaidFilm> meant_;
    std::vector<Corner> corners_; // of a chessboard on the sheet, all that are on the body
    std::vector<Corner> body_;    // spread over it
};

// An egg 56 mm wide and so many times as high, on film with cells of so many mm.
Project eggToFit(double height, double cell);

} // namespace dipwright::test
