// What both readers share: the sandbox, the connection, and the report of errors.
#pragma once

#include "reader/Pipe.h"

#include <functional>

namespace dipwright {

struct ReaderProgram {
    ReaderLimits limits;
    std::function<void()> prepare; // called before the sandbox is entered
    // Reads the job's files and hands over the result. Throws Error or std::bad_alloc.
    std::function<void(const ReaderJob&, Pipe&)> read;
};

// Reads one job and ends the process.
[[noreturn]] void runReader(int argc, char* argv[], const ReaderProgram& program);

} // namespace dipwright
