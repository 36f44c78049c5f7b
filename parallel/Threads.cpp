#include "parallel/Threads.h"

#include "parallel/Crew.h"
#include "parallel/ForkAndJoin.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

namespace dipwright {

int coreCount() {
    return tbb::info::default_concurrency();
}

int loopThreads() {
    return tbb::this_task_arena::max_concurrency();
}

struct ThreadLimit::Control {
    tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads) {
    if (threads > 0) {
        control_.reset(new Control{
            {tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)}});
    }
}

ThreadLimit::~ThreadLimit() = default;

struct ThreadTeam::Arena {
    tbb::task_arena arena;
};

ThreadTeam::ThreadTeam(int threads)
    : arena_(new Arena{tbb::task_arena(threads > 0 ? threads : tbb::task_arena::automatic)}) {}

ThreadTeam::~ThreadTeam() = default;

void ThreadTeam::run(const std::function<void()>& work) {
    // If all places in the team are taken, one of its own threads does the work.
    const parallel::ForkAndJoin forkAndJoin{};
    arena_->arena.execute([&] {
        const parallel::ForkAndJoin::Piece piece(forkAndJoin);
        const parallel::Crew crew(loopThreads());
        work();
    });
}

} // namespace dipwright
