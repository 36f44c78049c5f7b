// Handles the film's self-contact: keeps points apart that are close in space but not adjacent in
// the film's grid (docs/film-model.md, "The paper's model").
#pragma once

#include "common/Vector3.h"

#include <dipwright/FilmSolver.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace dipwright::cpu {

// All points in world coordinates with their inverse masses, in film order.
struct FilmPoints {
    std::vector<numerics::Vector3<float>> positions;
    std::vector<float> weights;
};

// The sum of the contact corrections of one point.
struct ContactPush {
    std::uint32_t point = 0;
    int contacts = 0;
    numerics::Vector3<float> sum{}; // mm
};

class SelfContact {
public:
    explicit SelfContact(const solver::FilmGrid& grid);

    // Returns the distance that points keep, mm: half the smaller spacing. The points of unfolded
    // film never come closer than this.
    float distance() const { return distance_; }

    // Finds the pairs that may touch within this step, with a spatial hash.
    void find(const FilmPoints& points);
    bool hasCandidates() const { return !candidates_.empty(); }

    // Returns one entry for each free point that is closer than distance() to another, in film
    // order.
    std::vector<ContactPush> pushes(const FilmPoints& points) const;

private:
    bool areGridNeighbours(std::uint32_t a, std::uint32_t b) const;

    solver::FilmGrid grid_;
    float distance_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> candidates_; // a < b
};

} // namespace dipwright::cpu
