#include "parallel/ParallelFor.h"

#include "parallel/Crew.h"
#include "parallel/ForkAndJoin.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace dipwright::parallel {

void forPieces(std::ptrdiff_t begin, std::ptrdiff_t end, std::ptrdiff_t least, Sharing sharing,
               Work work, const void* body) {
    if (begin >= end) {
        return;
    }
    if (Crew* const crew = Crew::ofThisThread()) {
        constexpr std::ptrdiff_t mostPieces = 256;
        const std::ptrdiff_t length = std::max(least, (end - begin) / mostPieces);
        crew->run(begin, end, length, work, body);
        return;
    }
    const ForkAndJoin forkAndJoin{};
    const tbb::blocked_range<std::ptrdiff_t> all(begin, end, static_cast<std::size_t>(least));
    const auto piece = [&](const tbb::blocked_range<std::ptrdiff_t>& range) {
        const ForkAndJoin::Piece between(forkAndJoin);
        work(body, range.begin(), range.end());
    };
    if (sharing == Sharing::Even) {
        tbb::parallel_for(all, piece, tbb::static_partitioner());
    } else {
        tbb::parallel_for(all, piece);
    }
}

} // namespace dipwright::parallel
