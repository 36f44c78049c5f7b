#include "solver/ProcessGroup.h"

#include <QProcess>
#include <cstdlib>

#ifndef _WIN32
#include <csignal>
#include <unistd.h>
#endif

namespace dipwright {

#ifdef _WIN32

void leadGroup(QProcess&) {}

void endGroup(qint64) {}

void endOwnGroup() {
    std::_Exit(0);
}

#else

void leadGroup(QProcess& process) {
    process.setChildProcessModifier([] { ::setpgid(0, 0); });
}

void endGroup(qint64 leader) {
    if (leader > 1) { // 0 and 1 would mean this process's own group, or all processes
        ::kill(-pid_t(leader), SIGKILL);
    }
}

void endOwnGroup() {
    if (::getpgrp() == ::getpid()) {
        ::kill(0, SIGKILL);
    }
    std::_Exit(0);
}

#endif

} // namespace dipwright
