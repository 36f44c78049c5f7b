// Loops spread over all cores. Which thread does what, and when, differs from run to run: a body
// writes nothing that another index reads or writes. Each returns when all indices are done, and
// the caller sees all that they wrote. If a body throws, those not begun are left out, and one of
// the exceptions is thrown to the caller. A body may contain a loop of its own.
#pragma once

#include <cstddef>

namespace dipwright {

namespace parallel {

enum class Sharing {
    Balanced, // pieces are cut smaller where threads are idle
    Even      // as many pieces as threads; a thread mostly gets the one it had in the last loop
};

// Calls work(body, first, last) for pieces of [begin, end), none of which was halved that had no
// more than `least` indices.
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

// The same for bodies that all take as long: every thread gets as many, and in the next loop of
// this length mostly the same ones, whose data may still be in its cache.
template <typename Index, typename Body>
void parallelForEvenly(Index begin, Index end, const Body& body) {
    parallel::forEach(begin, end, parallel::Sharing::Even, body);
}

// Calls body(first, last) for pieces of [begin, end) that together are all of it. None is halved
// that has no more than `least` indices: for bodies that are short, or prepare something.
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
