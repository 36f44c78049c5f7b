// Runs work in another thread's event loop. It wraps QMetaObject::invokeMethod. It also tells the
// thread sanitizer how the two threads are synchronised.
#pragma once

#include <functional>

class QObject;

namespace dipwright {

// Queues `work` for the event loop of `receiver`'s thread. `work` is not called if `receiver` is
// destroyed before that. May be called from any thread. Exceptions that `work` throws are lost.
void postToThread(QObject& receiver, std::function<void()> work);

// Queues `work` in the same way and waits until it is done. May be called from any thread except
// the receiver's.
void postToThreadAndWait(QObject& receiver, const std::function<void()>& work);

} // namespace dipwright
