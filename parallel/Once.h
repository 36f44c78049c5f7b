// Does a piece of work once, although several threads ask for it.
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

    // Calls `work`, unless an earlier call did so without an exception. If another thread is doing
    // the work, waits for it and helps with its loops. If `work` throws, its caller gets the
    // exception, and another caller does its own `work`. The caller sees everything that the work
    // wrote. `work` must not call the same object.
    void call(const std::function<void()>& work);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace dipwright
