// The threads of a team while they run many short loops, one after the other. Between two loops the
// helpers wait actively for a short time, because waking a thread that sleeps takes longer than
// many a loop. The owner needs no helper: it also runs the pieces that no helper has taken. So a
// helper that has no core at the moment delays a loop only if it has begun a piece.
#pragma once

#include "parallel/ForkAndJoin.h"
#include "parallel/ParallelFor.h"

#include <tbb/task_group.h>

#include <atomic>
#include <cstdint>
#include <exception>
#include <memory>

namespace dipwright::parallel {

class Crew {
public:
    // The calling thread owns the crew. The helpers are tasks in its present arena.
    explicit Crew(int members);
    ~Crew();
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    // The crew of this thread, or null. A thread that runs a piece of a loop has none.
    static Crew* ofThisThread();

    // Calls work(body, first, last) for pieces of [begin, end) with `length` indices. Each member
    // begins with its own share of the pieces, which is the same in all loops of this length. Only
    // the owner may call it.
    void run(std::ptrdiff_t begin, std::ptrdiff_t end, std::ptrdiff_t length, Work work,
             const void* body);

private:
    // A member's pieces that nobody has taken: the first and the end. The member takes from the
    // front, others take from the back.
    struct Share {
        alignas(64) std::atomic<std::uint64_t> left{0};
        std::atomic<bool> isHelping{false}; // or will soon
    };

    void call(int member);
    void help(int member);
    // Runs pieces until no member has any left.
    void runPieces(int member);
    void runPiece(std::ptrdiff_t piece);
    void waitForHelpers();

    const int members_;
    const std::unique_ptr<Share[]> shares_;
    Crew* const outer_; // the crew that this thread had before
    tbb::task_group helpers_;
    std::atomic<bool> isOver_ = false;

    // The loop that runs now. Helpers read it only after they have taken a piece.
    Work work_ = nullptr;
    const void* body_ = nullptr;
    std::ptrdiff_t begin_ = 0, end_ = 0, length_ = 0;
    const ForkAndJoin* loop_ = nullptr;
    alignas(64) std::atomic<std::int64_t> unfinished_ = 0; // pieces
    std::atomic<bool> hasFailed_ = false;
    std::exception_ptr failure_;
};

} // namespace dipwright::parallel
