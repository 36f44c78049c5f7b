// What a sanitizer finds in a process that is contained must not pass for a fault of the file or
// the plugin for whose sake it is: nobody reads that process's words, and whatever ends it is
// expected.
#pragma once

class QProcess;

namespace dipwright {

// Before `process` is started: what it writes to its standard error is no one's, and goes nowhere;
// in a build with sanitizers it is kept for endOnFinding.
void silence(QProcess& process);

// When `process` has ended: in a build with sanitizers, where one of them has found something in
// it, says that on the standard error and aborts this program. Else it does nothing.
void endOnFinding(QProcess& process);

} // namespace dipwright
