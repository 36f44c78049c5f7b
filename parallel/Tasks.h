// Tasks that run in parallel with each other and with the thread that starts them.
#pragma once

#include <functional>
#include <memory>

namespace dipwright {

// A group of tasks on the threads of the parallel loops. Tasks may contain loops and further tasks.
// Each task is called once, in any order, on any thread.
class Tasks {
public:
    Tasks();
    // Skips tasks that have not begun and waits for the others. Ignores their exceptions.
    ~Tasks();
    Tasks(const Tasks&) = delete;
    Tasks& operator=(const Tasks&) = delete;

    // Starts a task. Tasks may call this function too. A task sees everything that was written
    // before run().
    void run(std::function<void()> task);
    // Returns when all tasks are done; the caller sees everything they wrote. If a task throws,
    // tasks that have not begun are skipped and the first exception is thrown to the caller.
    void wait();

private:
    struct Group;
    std::unique_ptr<Group> group_;
};

// Calls `work` on this thread. While this thread waits inside `work`, it runs only loops and tasks
// that `work` has started. So other tasks do not delay `work`.
void runIsolated(const std::function<void()>& work);

} // namespace dipwright
