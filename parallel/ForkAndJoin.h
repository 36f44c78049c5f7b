// Tells the thread sanitizer that what was written before a fork is seen by its pieces, and what
// these write after the join, but not what one piece writes by another. The sanitizer cannot see it
// by itself: the libraries by which threads meet are not built with it. In other builds there is
// nothing of this. For sources that are declared by dipwright_threads_meet_in() only.
#pragma once

#ifdef DIPWRIGHT_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace dipwright::parallel {

#ifdef DIPWRIGHT_THREAD_SANITIZER

// Lives from before the fork to after the join.
class ForkAndJoin {
public:
    ForkAndJoin() { __tsan_release(&fork_); }
    ~ForkAndJoin() { __tsan_acquire(&join_); }
    ForkAndJoin(const ForkAndJoin&) = delete;
    ForkAndJoin& operator=(const ForkAndJoin&) = delete;

    // Lives while a piece is worked on.
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
