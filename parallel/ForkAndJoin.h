// Tells the thread sanitizer how a fork and a join order memory accesses. Pieces see what was
// written before the fork, and the code after the join sees what the pieces wrote. One piece does
// not see what another wrote. The sanitizer cannot know this by itself, because the threading
// libraries are not built with it. In other builds these types do nothing. Use these types only in
// sources that CMake declares by dipwright_threads_meet_in().
#pragma once

#ifdef DIPWRIGHT_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace dipwright::parallel {

#ifdef DIPWRIGHT_THREAD_SANITIZER

// Construct it before the fork and destroy it after the join.
class ForkAndJoin {
public:
    ForkAndJoin() { __tsan_release(&fork_); }
    ~ForkAndJoin() { __tsan_acquire(&join_); }
    ForkAndJoin(const ForkAndJoin&) = delete;
    ForkAndJoin& operator=(const ForkAndJoin&) = delete;

    // Construct it when a piece begins and destroy it when the piece ends.
    class Piece {
    public:
        explicit Piece(const ForkAndJoin& whole) : whole_(whole) { __tsan_acquire(&whole_.fork_); }
        ~Piece() { __tsan_release(&whole_.join_); }
        Piece(const Piece&) = delete;
        Piece& operator=(const Piece&) = delete;

    private:
        const ForkAndJoin& whole_;
    };

private:
    mutable char fork_ = 0, join_ = 0; // only their addresses matter
};

#else

struct ForkAndJoin {
    struct Piece {
        explicit Piece(const ForkAndJoin&) {}
    };
};

#endif

} // namespace dipwright::parallel
