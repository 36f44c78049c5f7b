// Simulates where printed places lie on the body, in one dip and in dips with slightly changed
// unknowns. Private to this folder.
#pragma once

#include "base/Progress.h"
#include "dip/FilledField.h"
#include "dip/LaidFilm.h"
#include "inspection/JointFit.h"

namespace dipwright {

struct Project;

class SimulatedPlaces {
public:
    // Keeps references. Builds the distance fields that the films need; this may take seconds.
    // Throws Error if a place names a dip that does not exist; Cancelled.
    SimulatedPlaces(const Project& project, const DistanceField& field,
                    const std::vector<PrintedPlace>& printed, const solver::SolverModule& module,
                    const QString& where, const Progress& progress);

    const FittedDips& dips() const { return dips_; }
    // Simulates at `centre` and with each free unknown moved by its step to either side. Uses all
    // cores. Throws Error, Cancelled.
    PlacesNear near(const std::vector<FitUnknown>& unknowns, const Eigen::VectorXd& centre,
                    const std::vector<bool>& isFree, const Progress& progress);
    int dipsDone() const { return dipsDone_; }

private:
    // One entry per printed place, in model coordinates, mm; set only for places that the dip
    // painted.
    using Places = std::vector<std::optional<Eigen::Vector3d>>;
    struct Tried {
        int dip = 0;
        std::vector<double> values; // one per unknown
    };
    std::vector<Places> simulate(const std::vector<FitUnknown>& unknowns,
                                 const std::vector<Tried>& tried, const Progress& progress);
    Places placesOn(const LaidFilm& laid, int dip) const;

    const Project& project_;
    const std::vector<PrintedPlace>& printed_;
    const solver::SolverModule& module_;
    std::vector<std::shared_ptr<const PosedBody>> bodies_; // one per dip
    std::vector<FilledField> fields_;                      // one per dip
    FittedDips dips_;
    int dipsDone_ = 0;
};

} // namespace dipwright
