#include "solver/CrashSignals.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace dipwright {
namespace {

#ifdef _WIN32
constexpr std::array crashSignals{SIGSEGV, SIGILL, SIGFPE, SIGABRT};
#else
constexpr std::array crashSignals{SIGSEGV, SIGILL, SIGFPE, SIGABRT, SIGBUS};
#endif

// A global, because a signal handler has no other way to find the file.
std::atomic<int> crashFile = -1;

extern "C" void onCrash(int number) {
    const int handle = crashFile.load();
    if (handle >= 0) {
#ifdef _WIN32
        _write(handle, "x", 1);
#else
        [[maybe_unused]] const auto written = write(handle, "x", 1);
#endif
    }
    std::signal(number, SIG_DFL);
    std::raise(number);
}

#ifndef _WIN32

// After a stack overflow the stack has no room for a handler.
std::array<char, 65536> handlerStack;

void install(int number) {
    struct sigaction action {};
    action.sa_handler = onCrash;
    action.sa_flags = SA_ONSTACK;
    sigaction(number, &action, nullptr);
}

void useOwnStack() {
    stack_t stack{};
    stack.ss_sp = handlerStack.data();
    stack.ss_size = handlerStack.size();
    sigaltstack(&stack, nullptr);
}

#else

void install(int number) {
    std::signal(number, onCrash);
}

void useOwnStack() {}

#endif

} // namespace

bool isCrash([[maybe_unused]] int signal) {
#ifdef _WIN32
    return true; // no signals between processes on Windows
#else
    return std::find(crashSignals.begin(), crashSignals.end(), signal) != crashSignals.end();
#endif
}

void reportCrashesTo(int handle) {
    crashFile = handle;
    if (handle >= 0) {
        useOwnStack();
    }
    for (const int number : crashSignals) {
        if (handle >= 0) {
            install(number);
        } else {
            std::signal(number, SIG_DFL);
        }
    }
}

} // namespace dipwright
