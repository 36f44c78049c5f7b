#include "reader/Sandbox.h"

#include "import/trusted/ReaderMessages.h"

#if defined(Q_OS_UNIX)
#include <csignal>
#include <sys/resource.h>
#include <unistd.h>
#endif
#if defined(Q_OS_LINUX)
#include <QByteArrayList>
#include <cerrno>
#include <memory>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif
#if defined(Q_OS_WIN)
#include <fcntl.h>
#include <io.h>
#include <windows.h>
#endif

namespace dipwright {

namespace {

#if defined(Q_OS_UNIX)
// Sets the current limit to `most`. The limit can be raised later, but never above `ever`.
void limit(int resource, rlim_t most, rlim_t ever) {
    rlimit now{};
    getrlimit(resource, &now);
    now.rlim_max = std::min(ever, now.rlim_max);
    now.rlim_cur = std::min(most, now.rlim_max);
    setrlimit(resource, &now);
}

constexpr qint64 anyFile = qint64(1) << 50; // bytes; larger than any budget
#endif

#if defined(Q_OS_LINUX) && (defined(__x86_64__) || defined(__aarch64__))
// System calls that are always allowed. They only compute, use open streams or end the process.
constexpr char harmlessCalls[] =
    "read readv write writev close lseek fstat fcntl poll ppoll munmap mremap madvise brk "
    "futex sched_yield sched_getaffinity set_robust_list rseq membarrier rt_sigaction "
    "rt_sigprocmask rt_sigreturn sigaltstack restart_syscall getpid gettid getuid geteuid "
    "getgid getegid getrandom uname sysinfo getrusage time clock_gettime clock_getres "
    "clock_nanosleep nanosleep gettimeofday eventfd2 pipe2 exit exit_group";

// A call that is allowed only if the masked bits of an argument have this value. Compares only the
// lower half of the argument, because the kernel reads no more.
struct LimitedCall {
    int call;
    scmp_arg_cmp argument;
};

bool filterCalls() {
    constexpr auto bits = SCMP_CMP_MASKED_EQ;
    constexpr std::uint32_t all = 0xffffffffu;
    const LimitedCall limitedCalls[] = {
        {SCMP_SYS(clone), {0, bits, CLONE_THREAD, CLONE_THREAD}},
        {SCMP_SYS(mmap), {2, bits, PROT_EXEC, 0}},
        {SCMP_SYS(mprotect), {2, bits, PROT_EXEC, 0}},
        {SCMP_SYS(prctl), {0, bits, all, PR_SET_NAME}},
        {SCMP_SYS(prlimit64), {0, bits, all, 0}}, // of this process only
        {SCMP_SYS(tgkill), {0, bits, all, std::uint32_t(getpid())}},
    };
    const std::unique_ptr<void, decltype(&seccomp_release)> filter(
        seccomp_init(SCMP_ACT_ERRNO(EPERM)), seccomp_release);
    // Kernels before 4.14 do not know this action; they end only the thread.
    seccomp_attr_set(filter.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS);
    // Reports clone3 as missing, so that the C library uses clone, whose flags the filter can read.
    int refused = seccomp_rule_add(filter.get(), SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0);
    for (const QByteArray& name : QByteArray(harmlessCalls).split(' ')) {
        const int call = seccomp_syscall_resolve_name(name.constData());
        refused |= seccomp_rule_add(filter.get(), SCMP_ACT_ALLOW, call, 0);
    }
    for (const auto& [call, argument] : limitedCalls) {
        refused |= seccomp_rule_add_array(filter.get(), SCMP_ACT_ALLOW, call, 1, &argument);
    }
    return refused == 0 && seccomp_load(filter.get()) == 0;
}
#else
bool filterCalls() {
    return true;
}
#endif

} // namespace

#if defined(Q_OS_UNIX)

void closeInheritedFiles() {
#if defined(Q_OS_LINUX)
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    prctl(PR_SET_DUMPABLE, 0);
#if defined(SYS_close_range)
    syscall(SYS_close_range, 3u, ~0u, 0u);
#endif
#endif
}

bool enterSandbox(const ReaderLimits& limits) {
    // Ends at once, because a message could be written into the middle of another message.
    std::signal(SIGXCPU, [](int) { _exit(readerOutOfTime); });
    limit(RLIMIT_CORE, 0, 0);
    limit(RLIMIT_FSIZE, 0, 0);
    raiseLimits(limits, 0);
    return filterCalls();
}

void raiseLimits(const ReaderLimits& limits, qint64 fileBytes) {
    constexpr qint64 second = 1000;
    const qint64 time = budgetLimit(limits.time, fileBytes);
    // After the last second, the kernel kills the process. One second earlier it sends the signal
    // that lets the process report the reason.
    limit(RLIMIT_CPU, rlim_t((time + second - 1) / second),
          rlim_t(budgetLimit(limits.time, anyFile) / second + 2));
#if !defined(DIPWRIGHT_SANITIZED) // sanitizers reserve terabytes of address space
#if defined(Q_OS_LINUX)
    const int memory = RLIMIT_DATA; // limits written memory only, because more is reserved
#else
    const int memory = RLIMIT_AS;
#endif
    limit(memory, rlim_t(budgetLimit(limits.memory, fileBytes)),
          rlim_t(budgetLimit(limits.memory, anyFile)));
#endif
}

#elif defined(Q_OS_WIN)

void closeInheritedFiles() {
    for (const int stream : {0, 1}) {
        _setmode(stream, _O_BINARY);
    }
}

// Allows one process, and the memory for the largest file, because the limits of a Windows job
// object cannot be raised later.
bool enterSandbox(const ReaderLimits& limits) {
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION job{};
    job.BasicLimitInformation.LimitFlags =
        JOB_OBJECT_LIMIT_ACTIVE_PROCESS | JOB_OBJECT_LIMIT_PROCESS_MEMORY;
    job.BasicLimitInformation.ActiveProcessLimit = 1;
    job.ProcessMemoryLimit = SIZE_T(budgetLimit(limits.memory, budgetLimit(Budget::FileBytes)));
    const HANDLE handle = CreateJobObjectW(nullptr, nullptr);
    return SetInformationJobObject(handle, JobObjectExtendedLimitInformation, &job, sizeof job) !=
               0 &&
           AssignProcessToJobObject(handle, GetCurrentProcess()) != 0;
}

void raiseLimits(const ReaderLimits& /*limits*/, qint64 /*fileBytes*/) {}

#endif

} // namespace dipwright
