#include "base/PostToThread.h"

#include "parallel/ForkAndJoin.h"

#include <QObject>

#include <memory>

namespace dipwright {

namespace {

// Shared by two threads. The thread that releases the errand last deletes it.
struct Errand {
    std::function<void()> work;
    // destroyed before `work`, so that the deleting thread sees what `work` wrote
    parallel::ForkAndJoin crossing{};
};

} // namespace

void postToThread(QObject& receiver, std::function<void()> work) {
    std::unique_ptr<Errand> errand(new Errand{std::move(work)});
    QMetaObject::invokeMethod(
        &receiver,
        [errand = std::move(errand)] {
            const parallel::ForkAndJoin::Piece piece(errand->crossing);
            errand->work();
        },
        Qt::QueuedConnection);
}

void postToThreadAndWait(QObject& receiver, const std::function<void()>& work) {
    const parallel::ForkAndJoin crossing{};
    QMetaObject::invokeMethod(
        &receiver,
        [&] {
            const parallel::ForkAndJoin::Piece piece(crossing);
            work();
        },
        Qt::BlockingQueuedConnection);
}

} // namespace dipwright
