#include "base/PostToThread.h"

#include "parallel/ForkAndJoin.h"

#include <QObject>

#include <memory>

namespace dipwright {

namespace {

// Deleted by whichever of the two threads lets go of it last.
struct Errand {
    std::function<void()> work;
    parallel::ForkAndJoin crossing{}; // goes before `work`: whoever deletes that sees what it did
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
