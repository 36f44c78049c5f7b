// Work for another thread's event loop: QMetaObject::invokeMethod, of which the thread sanitizer is
// told what goes over from one thread to the other.
#pragma once

#include <functional>

class QObject;

namespace dipwright {

// Calls `work` on the thread of `receiver`, once that comes to it; not at all where `receiver` is
// gone by then. From any thread. What `work` throws reaches nobody.
void postToThread(QObject& receiver, std::function<void()> work);

// The same, and waits until it is done. From any thread but the receiver's.
void postToThreadAndWait(QObject& receiver, const std::function<void()>& work);

} // namespace dipwright
