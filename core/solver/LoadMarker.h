// What is remembered of modules that brought a program down, so that one which does so again and
// again is left out instead.
#pragma once

#include "disk/LockedFile.h"

#include <QString>

namespace dipwright {

// Crashes count; being killed does not: by the system for want of memory, by a limit of time, by
// the user. A module is known by its very file, place, size and time: one that was replaced starts
// anew.
inline constexpr int crashesAllowed = 1; // one more, and the module is left out

int crashesOf(const QString& modulePath);
void rememberCrash(const QString& modulePath);
void forgetCrashes(const QString& modulePath);

// While an object lives, this process is loading the module. If it dies in that time of a fault of
// its own (a signal such as that of a wrong address), this is told in a file, and crashesOf counts
// it from the next start on. One object at a time. Nothing is told where the user's folder for
// program data cannot be written.
class LoadMarker {
public:
    explicit LoadMarker(const QString& modulePath);
    ~LoadMarker();
    LoadMarker(const LoadMarker&) = delete;
    LoadMarker& operator=(const LoadMarker&) = delete;

private:
    LockedFile file_;
};

} // namespace dipwright
