#include "parallel/Once.h"

#include "parallel/ForkAndJoin.h"

#include <tbb/collaborative_call_once.h>

namespace dipwright {

struct Once::State {
    tbb::collaborative_once_flag flag;
    parallel::Handover result;
};

Once::Once() : state_(new State) {}

Once::~Once() = default;

void Once::call(const std::function<void()>& work) {
    tbb::collaborative_call_once(state_->flag, [&] {
        work();
        state_->result.give();
    });
    state_->result.take();
}

} // namespace dipwright
