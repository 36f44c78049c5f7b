// Notes on disk that a module is being loaded, so that one which brings the program down is left
// out at the next start instead of doing it again.
#pragma once

#include <QLockFile>
#include <QString>

namespace dipwright {

// While an object lives, the module counts as being loaded by this process. If the process dies in
// that time, crashedBefore() says so from then on. Nothing is noted where the folder cannot be
// written.
class LoadMarker {
public:
    explicit LoadMarker(const QString& modulePath);

    // Whether an earlier process died while loading this very file (same place, size and time).
    static bool crashedBefore(const QString& modulePath);
    // Forgets what crashedBefore() knows of the module.
    static void forget(const QString& modulePath);

private:
    // Knows whether the process that made it still lives, on every system.
    QLockFile lock_;
};

} // namespace dipwright
