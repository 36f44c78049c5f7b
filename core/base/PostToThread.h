// Runs work in another thread's event loop. It wraps QMetaObject::invokeMethod and tells the thread
// sanitizer what passes from one thread to the other.
#pragma once

#include <functional>

class QObject;

namespace dipwright {

// Queues `work` for the event loop of `receiver`'s thread. It is not called if `receiver` is
// destroyed before. May be called from any thread. Exceptions that `work` throws are lost.
void postToThread(QObject& receiver, std::function<void()> work);

// Does the same and waits until it is done. May be called from any thread except the receiver's.
void postToThreadAndWait(QObject& receiver, const std::function<void()>& work);

} // namespace dipwright
