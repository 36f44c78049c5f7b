// Pieces of work that go on beside each other and beside the one who begins them.
#pragma once

#include <functional>
#include <memory>

namespace dipwright {

// Tasks that are spread over the threads of the parallel loops, and may contain such loops and
// tasks of their own. Each is called once, in no certain order, on any thread.
class Tasks {
public:
    Tasks();
    // Leaves out what has not begun and waits for the rest, whatever they throw.
    ~Tasks();
    Tasks(const Tasks&) = delete;
    Tasks& operator=(const Tasks&) = delete;

    // May be called by a task, too. What it reads was written before, or by the task itself.
    void run(std::function<void()> task);
    // Returns when all are done, and the caller sees all that they wrote. If a task throws, those
    // not begun are left out, and the first exception is thrown to the caller.
    void wait();

private:
    struct Group;
    std::unique_ptr<Group> group_;
};

// Calls `work` on this thread, which meanwhile takes up nothing but the loops and tasks within it:
// what is begun beside it does not hold it up.
void undisturbed(const std::function<void()>& work);

} // namespace dipwright
