// Work that several threads may need, but only one does.
#pragma once

#include <functional>
#include <memory>

namespace dipwright {

class Once {
public:
    Once();
    ~Once();
    Once(const Once&) = delete;
    Once& operator=(const Once&) = delete;

    // Calls `work` unless an earlier call has returned from it. Meanwhile, other threads that call
    // this function help with the loops in `work`. If `work` throws, the caller gets the exception,
    // and the next thread calls its own `work`. The caller sees everything that `work` wrote.
    void call(const std::function<void()>& work);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace dipwright
