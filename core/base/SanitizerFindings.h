// Reports what a sanitizer finds in a sandboxed process. That process's output is not read and its
// crashes are handled, so a finding would otherwise pass for a fault of the file or plugin.
#pragma once

class QProcess;

namespace dipwright {

// Call before `process` is started. Its standard error is discarded; a build with sanitizers keeps
// it for endOnFinding().
void silence(QProcess& process);

// Call after `process` has ended. In a build with sanitizers, prints what a sanitizer found in it
// on standard error and aborts this program. Otherwise does nothing.
void endOnFinding(QProcess& process);

} // namespace dipwright
