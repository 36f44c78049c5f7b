#include "cli/Terminal.h"

#include <csignal>
#include <cstdio>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace dipwright::cli {
namespace {

// A signal handler can reach only global variables.
CancelToken* signalSwitch = nullptr;

extern "C" void onSignal(int number) {
    std::signal(number, SIG_DFL);
    signalSwitch->cancel();
}

// Does not change signals that are ignored; nohup relies on this.
void cancelOn(int number) {
    if (std::signal(number, onSignal) == SIG_IGN) {
        std::signal(number, SIG_IGN);
    }
}

} // namespace

bool standardErrorIsTerminal() {
#ifdef _WIN32
    return _isatty(_fileno(stderr)) != 0;
#else
    return isatty(STDERR_FILENO) != 0;
#endif
}

void cancelOnSignals(const CancelToken& cancelToken) {
    static CancelToken shared = cancelToken;
    signalSwitch = &shared;
    cancelOn(SIGINT);
    cancelOn(SIGTERM);
#ifdef SIGHUP
    cancelOn(SIGHUP); // the terminal was closed
#endif
#ifdef SIGXFSZ
    std::signal(SIGXFSZ, SIG_IGN);
#endif
}

} // namespace dipwright::cli
