#include "parallel/Once.h"

#include <tbb/collaborative_call_once.h>

#include <atomic>

namespace dipwright {

struct Once::State {
    tbb::collaborative_once_flag flag;
    // For the thread sanitizer, which does not see how TBB orders memory accesses.
    std::atomic<bool> isDone = false;
};

Once::Once() : state_(new State) {}

Once::~Once() = default;

void Once::call(const std::function<void()>& work) {
    tbb::collaborative_call_once(state_->flag, [&] {
        work();
        state_->isDone = true;
    });
    state_->isDone.load();
}

} // namespace dipwright
