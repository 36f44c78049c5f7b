// A process and all that it starts, to be ended together: the system's part. On Windows, which has
// no such groups, a process is its own and no other's.
#pragma once

#include <QtGlobal>

class QProcess;

namespace dipwright {

// Before `process` is started: it is to lead a group of its own, in which all are that it starts,
// but for those that leave it. An interrupt from the keyboard does not come to it any more.
void leadGroup(QProcess& process);

// Kills all that are left in the group of `leader`, and `leader` itself; 0: none. To be called no
// later than when the leader's end is known: afterwards its number may come to be another's.
void endGroup(qint64 leader);

// Ends this process and, where it leads a group, all in that.
[[noreturn]] void endOwnGroup();

} // namespace dipwright
