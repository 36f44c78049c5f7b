#include "parallel/Crew.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#if defined(__SSE__) || defined(_M_X64)
#include <immintrin.h>
#endif

namespace dipwright::parallel {

namespace {

thread_local Crew* crewOfThread = nullptr;

// A helper that has found no index for this long gives its thread back.
constexpr std::chrono::microseconds helpersPatience(200);
// The owner waits actively for this long before it sleeps.
constexpr std::chrono::microseconds ownersPatience(50);

void pause() {
#if defined(__SSE__) || defined(_M_X64)
    _mm_pause();
#else
    std::this_thread::yield();
#endif
}

// Waits actively until isDone(), but not much longer than `longest`. Returns whether it is done.
template <typename IsDone>
bool waitActively(std::chrono::microseconds longest, const IsDone& isDone) {
    constexpr int checksPerClock = 32;
    const auto end = std::chrono::steady_clock::now() + longest;
    do {
        for (int check = 0; check < checksPerClock; ++check) {
            if (isDone()) {
                return true;
            }
            pause();
        }
    } while (std::chrono::steady_clock::now() < end);
    return isDone();
}

std::uint64_t packed(std::uint64_t first, std::uint64_t end) {
    return end << 32 | first;
}
std::uint64_t firstOf(std::uint64_t share) {
    return share & 0xffffffffu;
}
std::uint64_t endOf(std::uint64_t share) {
    return share >> 32;
}
bool isEmpty(std::uint64_t share) {
    return firstOf(share) == endOf(share);
}

} // namespace

Crew::Crew(int members)
    : members_(members), shares_(new Share[std::size_t(members)]), outer_(crewOfThread) {
    crewOfThread = this;
}

Crew::~Crew() {
    crewOfThread = outer_;
    isOver_ = true;
    helpers_.wait();
}

Crew* Crew::ofThisThread() {
    return crewOfThread;
}

void Crew::run(std::ptrdiff_t begin, std::ptrdiff_t end, std::ptrdiff_t length, Work work,
               const void* body) {
    const ForkAndJoin forkAndJoin{};
    const std::uint64_t pieces = std::uint64_t((end - begin + length - 1) / length);
    const std::uint64_t members = std::uint64_t(members_);
    work_ = work;
    body_ = body;
    begin_ = begin;
    end_ = end;
    length_ = length;
    loop_ = &forkAndJoin;
    unfinished_.store(std::int64_t(pieces), std::memory_order_relaxed);
    for (std::uint64_t member = members; member-- > 0;) {
        const std::uint64_t first = pieces * member / members;
        const std::uint64_t last = pieces * (member + 1) / members;
        shares_[member].left.store(packed(first, last), std::memory_order_release);
        if (member > 0 && first < last) {
            call(int(member));
        }
    }
    crewOfThread = nullptr; // loops inside a piece run without the crew
    runPieces(0);
    crewOfThread = this;
    waitForHelpers();
    if (hasFailed_) {
        hasFailed_ = false;
        std::rethrow_exception(std::exchange(failure_, nullptr));
    }
}

void Crew::call(int member) {
    Share& share = shares_[std::size_t(member)];
    if (!share.isHelping.load(std::memory_order_acquire)) {
        share.isHelping.store(true, std::memory_order_relaxed);
        helpers_.run([this, member] { help(member); });
    }
}

void Crew::help(int member) {
    Share& own = shares_[std::size_t(member)];
    const auto isWanted = [&] {
        return !isEmpty(own.left.load(std::memory_order_relaxed)) ||
               isOver_.load(std::memory_order_relaxed);
    };
    Crew* const before = std::exchange(crewOfThread, nullptr);
    while (waitActively(helpersPatience, isWanted) && !isOver_) {
        runPieces(member);
    }
    crewOfThread = before;
    own.isHelping.store(false, std::memory_order_release);
}

void Crew::runPieces(int member) {
    for (int other = 0; other < members_; ++other) {
        std::atomic<std::uint64_t>& share = shares_[std::size_t((member + other) % members_)].left;
        std::uint64_t left = share.load(std::memory_order_relaxed);
        while (!isEmpty(left)) {
            const std::uint64_t piece = other == 0 ? firstOf(left) : endOf(left) - 1;
            const std::uint64_t rest =
                other == 0 ? packed(piece + 1, endOf(left)) : packed(firstOf(left), piece);
            if (share.compare_exchange_weak(left, rest, std::memory_order_acquire,
                                            std::memory_order_relaxed)) {
                runPiece(std::ptrdiff_t(piece));
                left = share.load(std::memory_order_relaxed);
            }
        }
    }
}

void Crew::runPiece(std::ptrdiff_t piece) {
    if (!hasFailed_.load(std::memory_order_relaxed)) {
        const ForkAndJoin::Piece between(*loop_);
        const std::ptrdiff_t first = begin_ + piece * length_;
        try {
            work_(body_, first, std::min(first + length_, end_));
        } catch (...) {
            if (!hasFailed_.exchange(true)) {
                failure_ = std::current_exception();
            }
        }
    }
    if (unfinished_.fetch_sub(1, std::memory_order_acq_rel) == 1) {
        unfinished_.notify_one();
    }
}

void Crew::waitForHelpers() {
    const auto isDone = [&] { return unfinished_.load(std::memory_order_acquire) == 0; };
    if (!waitActively(ownersPatience, isDone)) {
        for (std::int64_t left = unfinished_; left != 0; left = unfinished_) {
            unfinished_.wait(left);
        }
    }
}

} // namespace dipwright::parallel
