#include "solving/Pipes.h"

#include <csignal>

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#else
#include <unistd.h>
#endif

namespace dipwright {

void leaveInterruptsToStarter() {
    std::signal(SIGINT, SIG_IGN);
    std::signal(SIGTERM, SIG_IGN);
#ifdef SIGHUP
    std::signal(SIGHUP, SIG_IGN);
#endif
}

#ifdef _WIN32

std::FILE* answerPipe() {
    _setmode(_fileno(stdin), _O_BINARY);
    const int answers = _dup(_fileno(stdout));
    _dup2(_fileno(stderr), _fileno(stdout));
    _setmode(answers, _O_BINARY);
    return _fdopen(answers, "wb");
}

#else

std::FILE* answerPipe() {
    const int answers = dup(STDOUT_FILENO);
    dup2(STDERR_FILENO, STDOUT_FILENO);
    return fdopen(answers, "wb");
}

#endif

} // namespace dipwright
