#include "base/SanitizerFindings.h"

#include <QProcess>

#if defined(DIPWRIGHT_SANITIZED)
#include <QRegularExpression>

#include <cstdio>
#include <cstdlib>
#endif
#if defined(DIPWRIGHT_THREAD_SANITIZER) && defined(__linux__)
#include <cstdarg>
#include <sys/types.h>
#endif

namespace dipwright {

#if defined(DIPWRIGHT_SANITIZED)

void silence(QProcess&) {}

namespace {

// A library that is built without the sanitizer may crash. The sandbox has then done its work, so
// this is no finding.
bool isCrashOfOthers(const QString& words) {
    static const QRegularExpression inOurCode(QStringLiteral("#0 .*dipwright"));
    return words.contains(QLatin1String("DEADLYSIGNAL")) && !words.contains(inOurCode);
}

} // namespace

void endOnFinding(QProcess& process) {
    const QString words = QString::fromUtf8(process.readAllStandardError());
    const bool isFinding = words.contains(QLatin1String("Sanitizer: ")) ||
                           words.contains(QLatin1String("runtime error: "));
    if (isFinding && !isCrashOfOthers(words)) {
        std::fputs(qPrintable(words), stderr);
        std::abort();
    }
}

#else

void silence(QProcess& process) {
    process.setStandardErrorFile(QProcess::nullDevice());
}

void endOnFinding(QProcess&) {}

#endif

} // namespace dipwright

#if defined(DIPWRIGHT_THREAD_SANITIZER) && defined(__linux__)

extern "C" {

int __clone(int (*)(void*), void*, int, void*, ...);

// Replaces the sanitizer's own wrapper of clone(). Qt starts a process by a clone that shares this
// process's memory until the new program runs. The sanitizer's wrapper treats this clone as a fork.
// The sanitizer would then lose track of the calling thread, and would end the program when the
// next thread starts.
__attribute__((visibility("default"))) int clone(int (*function)(void*), void* stack, int flags,
                                                 void* argument, ...) {
    std::va_list more;
    va_start(more, argument);
    auto* const parent = va_arg(more, pid_t*);
    auto* const storage = va_arg(more, void*);
    auto* const child = va_arg(more, pid_t*);
    va_end(more);
    return __clone(function, stack, flags, argument, parent, storage, child);
}

} // extern "C"

#endif
