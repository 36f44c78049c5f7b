// Ends a process together with everything that it started. System-dependent: Windows has no such
// groups, so there only the process itself is ended.
#pragma once

#include <QtGlobal>

class QProcess;

namespace dipwright {

// Call before `process` is started. It then leads its own group, which contains everything that it
// starts, except processes that leave the group. Keyboard interrupts no longer reach it.
void leadGroup(QProcess& process);

// Kills all processes left in the group of `leader`, and `leader` itself. Does nothing if `leader`
// is 0. Call it at the latest when the leader's end is known: afterwards its number may belong to
// another process.
void endGroup(qint64 leader);

// Ends this process and, if it leads a group, everything in that group.
[[noreturn]] void endOwnGroup();

} // namespace dipwright
