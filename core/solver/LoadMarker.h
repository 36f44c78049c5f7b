// Remembers modules that crashed a program, so that a module that crashes repeatedly is disabled.
#pragma once

#include "disk/LockedFile.h"

#include <QString>

namespace dipwright {

// Only crashes count. A kill by the system for lack of memory, by a time limit or by the user is no
// crash. A module is identified by its file's path, size and time, so that a replaced module starts
// with no crashes counted.
inline constexpr int crashesAllowed = 1; // one more disables the module

int crashesOf(const QString& modulePath);
void rememberCrash(const QString& modulePath);
void forgetCrashes(const QString& modulePath);

// While an object lives, this process is loading the module. If the process crashes in that time (a
// signal such as SIGSEGV), a file records the crash. From the next start, crashesOf() counts it.
// One object at a time. Nothing is recorded if the user's folder for program data cannot be
// written.
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
