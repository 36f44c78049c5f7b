// Parallel loops over all cores. The order and the threads differ from run to run. So a body must
// not write anything that another index reads or writes. Each loop returns when all indices are
// done, and the caller sees everything they wrote. If a body throws, indices that have not begun
// are skipped and one of the exceptions is thrown to the caller. Loops may be nested.
#pragma once

#include <cstddef>

namespace dipwright {

namespace parallel {

// How threads share a loop. In a team (Threads.h), all loops are shared as Crew::run() says.
enum class Sharing {
    Balanced, // splits pieces further where threads are idle
    Even      // one piece for each thread; a thread mostly gets the same piece as in the last loop
};

// Calls work(body, first, last) for pieces of [begin, end). Pieces with at most `least` indices are
// not split.
using Work = void (*)(const void* body, std::ptrdiff_t first, std::ptrdiff_t last);
void forPieces(std::ptrdiff_t begin, std::ptrdiff_t end, std::ptrdiff_t least, Sharing sharing,
               Work work, const void* body);

template <typename Index, typename Body>
void forEach(Index begin, Index end, Sharing sharing, const Body& body) {
    const Work work = [](const void* each, std::ptrdiff_t first, std::ptrdiff_t last) {
        for (std::ptrdiff_t index = first; index < last; ++index) {
            (*static_cast<const Body*>(each))(static_cast<Index>(index));
        }
    };
    forPieces(static_cast<std::ptrdiff_t>(begin), static_cast<std::ptrdiff_t>(end), 1, sharing,
              work, &body);
}

} // namespace parallel

// Calls body(index) for every index from `begin` to before `end`.
template <typename Index, typename Body>
void parallelFor(Index begin, Index end, const Body& body) {
    parallel::forEach(begin, end, parallel::Sharing::Balanced, body);
}

// Like parallelFor(), but for bodies of equal cost. Every thread gets the same number of indices.
// In the next loop of this length it mostly gets the same indices, whose data may still be in its
// cache.
template <typename Index, typename Body>
void parallelForEvenly(Index begin, Index end, const Body& body) {
    parallel::forEach(begin, end, parallel::Sharing::Even, body);
}

// Calls body(first, last) for pieces that together cover [begin, end). Pieces with at most `least`
// indices are not split. Use it for bodies that are short or have setup costs.
template <typename Index, typename Body>
void parallelForPieces(Index begin, Index end, Index least, const Body& body) {
    const parallel::Work work = [](const void* each, std::ptrdiff_t first, std::ptrdiff_t last) {
        (*static_cast<const Body*>(each))(static_cast<Index>(first), static_cast<Index>(last));
    };
    parallel::forPieces(static_cast<std::ptrdiff_t>(begin), static_cast<std::ptrdiff_t>(end),
                        static_cast<std::ptrdiff_t>(least), parallel::Sharing::Balanced, work,
                        &body);
}

} // namespace dipwright
