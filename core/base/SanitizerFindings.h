// Reports what a sanitizer finds in a sandboxed process. The program does not read that process's
// output, and it survives that process's crashes. Without these functions, a finding would look
// like a fault of the file or plugin.
#pragma once

class QProcess;

namespace dipwright {

// Call before `process` is started. Its standard error is discarded; a build with sanitizers keeps
// it for endOnFinding().
void silence(QProcess& process);

// Call after `process` has ended. If a sanitizer found something in `process`, prints the finding
// to standard error and aborts this program. Does nothing in a build without sanitizers.
void endOnFinding(QProcess& process);

} // namespace dipwright
