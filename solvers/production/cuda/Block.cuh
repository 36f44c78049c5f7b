// The memory that a block of threads shares.
#pragma once

#include "common/cuda/Team.cuh"
#include "production/cuda/ProductionModel.h"
#include "production/formulas/FilmBackend.h"

namespace dipwright::cuda {

// A block's small least-squares problem of GMRES. It is identical in all blocks of a team.
struct SmallProblem {
    numerics::GmresProblem problem;
    float factors[numerics::mostBasisVectors + 1]; // factors on the stored basis vectors
    double answer;
};

// What a block knows of its film. Functions that are not inlined address it directly, because it
// has a fixed place in shared memory.
struct Block : ProductionFilm {
    Team team;
    SmallProblem small;
    int listed; // number of triangles in a list (CudaBackend::forListed)
};
union BlockMemory {
    __device__ BlockMemory() {}
    Block block;
};
__shared__ BlockMemory thisBlock;
extern __shared__ float2 tileMemory[]; // for tiles and levels

} // namespace dipwright::cuda
