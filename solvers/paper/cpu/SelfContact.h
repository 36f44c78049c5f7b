// Contact of the film with itself: points that are neighbours in space but not in the film's grid
// are kept apart (docs/film-model.md, "The paper's model").
#pragma once

#include "common/Vector3.h"

#include <dipwright/FilmSolver.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace dipwright::cpu {

// All points in the world, with their inverse masses; film order.
struct FilmPoints {
    std::vector<numerics::Vector3<float>> positions;
    std::vector<float> weights;
};

// What the contacts of one point ask of it.
struct ContactPush {
    std::uint32_t point = 0;
    int contacts = 0;
    numerics::Vector3<float> sum{}; // of the contacts' corrections, mm
};

class SelfContact {
public:
    explicit SelfContact(const solver::FilmGrid& grid);

    // How far apart points are kept: half the smaller spacing, closer than film lies without
    // folding.
    float distance() const { return distance_; }

    // Finds the pairs that may touch within this step, through a spatial hash.
    void find(const FilmPoints& points);
    bool hasCandidates() const { return !candidates_.empty(); }

    // One entry for each free point that is closer than distance() to another, in film order.
    std::vector<ContactPush> pushes(const FilmPoints& points) const;

private:
    bool areGridNeighbours(std::uint32_t a, std::uint32_t b) const;

    solver::FilmGrid grid_;
    float distance_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> candidates_; // a < b
};

} // namespace dipwright::cpu
