#include "parallel/Tasks.h"

#include "parallel/ForkAndJoin.h"

#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <exception>
#include <list>
#include <mutex>

namespace dipwright {

// Exceptions are caught here, because one that reached TBB would cancel the loops of the other
// tasks.
struct Tasks::Group {
    tbb::task_group group;
    std::mutex mutex;
    std::exception_ptr failure;
    bool isGivenUp = false; // tasks that have not begun are skipped
    // one for each task; destroyed before `failure`, which a task creates
    std::list<parallel::ForkAndJoin> forks;

    const parallel::ForkAndJoin& fork() {
        const std::scoped_lock lock(mutex);
        return forks.emplace_back();
    }
    bool isWanted() {
        const std::scoped_lock lock(mutex);
        return !isGivenUp;
    }
    void giveUp(std::exception_ptr reason) {
        const std::scoped_lock lock(mutex);
        isGivenUp = true;
        failure = failure ? failure : std::move(reason);
    }
};

Tasks::Tasks() : group_(new Group) {}

Tasks::~Tasks() {
    group_->giveUp(nullptr);
    group_->group.wait();
}

void Tasks::run(std::function<void()> task) {
    Group& group = *group_;
    const parallel::ForkAndJoin& fork = group.fork();
    group.group.run([&group, &fork, task = std::move(task)] {
        const parallel::ForkAndJoin::Piece piece(fork);
        if (!group.isWanted()) {
            return;
        }
        try {
            task();
        } catch (...) {
            group.giveUp(std::current_exception());
        }
    });
}

void Tasks::wait() {
    group_->group.wait();
    group_->forks.clear();
    group_->isGivenUp = false;
    if (const std::exception_ptr failure = std::exchange(group_->failure, nullptr)) {
        std::rethrow_exception(failure);
    }
}

void runIsolated(const std::function<void()>& work) {
    tbb::this_task_arena::isolate(work);
}

} // namespace dipwright
