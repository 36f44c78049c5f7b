#include "base/SanitizerFindings.h"

#include <QProcess>

#if defined(DIPWRIGHT_SANITIZED)
#include <QRegularExpression>

#include <cstdio>
#include <cstdlib>
#endif

namespace dipwright {

#if defined(DIPWRIGHT_SANITIZED)

void silence(QProcess&) {}

namespace {

// Where a library crashes, which is not compiled with the sanitizer, containing it is all there is
// to do.
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
