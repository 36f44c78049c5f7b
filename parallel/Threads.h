// The number of threads of the parallel loops.
#pragma once

#include <functional>
#include <memory>

namespace dipwright {

int coreCount();   // cores of this machine that this process may use
int loopThreads(); // number of threads of a loop that this thread starts

// Limits the number of computing threads of the whole process while an object of this class lives.
class ThreadLimit {
public:
    explicit ThreadLimit(int threads); // 0: no limit
    ~ThreadLimit();

private:
    struct Control;
    std::unique_ptr<Control> control_;
};

// A separate set of threads for the loops of one computation.
class ThreadTeam {
public:
    explicit ThreadTeam(int threads); // 0: one for each core
    ~ThreadTeam();

    // Calls `work` once and waits for it. Loops inside run on this team, whose threads wait
    // actively for the next loop for up to 0.2 ms. Throws what `work` throws.
    void run(const std::function<void()>& work);

private:
    struct Arena;
    std::unique_ptr<Arena> arena_;
};

} // namespace dipwright
