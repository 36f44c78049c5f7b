// How many threads the parallel loops are spread over.
#pragma once

#include <functional>
#include <memory>

namespace dipwright {

int coreCount();   // of this machine, as far as this process may use them
int loopThreads(); // that a loop begun here is spread over

// No more than so many threads compute, in the whole process, while an object of this class lives.
class ThreadLimit {
public:
    explicit ThreadLimit(int threads); // 0: no limit
    ~ThreadLimit();

private:
    struct Control;
    std::unique_ptr<Control> control_;
};

// Threads of its own for the loops of one computation.
class ThreadTeam {
public:
    explicit ThreadTeam(int threads); // 0: one a core
    ~ThreadTeam();

    // Calls work once and returns after it; loops within are spread over this team. Throws what
    // `work` throws.
    void run(const std::function<void()>& work);

private:
    struct Arena;
    std::unique_ptr<Arena> arena_;
};

} // namespace dipwright
