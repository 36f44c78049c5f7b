#include "reader/Confinement.h"

#include "base/Budgets.h"
#include "import/ReaderMessages.h"

#if defined(Q_OS_UNIX)
#include <csignal>
#include <sys/resource.h>
#include <unistd.h>
#endif
#if defined(Q_OS_LINUX)
#include <cerrno>
#include <cstddef>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <vector>
#endif
#if defined(Q_OS_WIN)
#include <fcntl.h>
#include <io.h>
#include <windows.h>
#endif

namespace dipwright {

namespace {

#if defined(Q_OS_UNIX)
// It can be raised again up to `ever`, never beyond.
void limit(int resource, rlim_t most, rlim_t ever) {
    rlimit now{};
    getrlimit(resource, &now);
    now.rlim_max = std::min(ever, now.rlim_max);
    now.rlim_cur = std::min(most, now.rlim_max);
    setrlimit(resource, &now);
}

constexpr qint64 anyFile = qint64(1) << 50; // bytes: the largest budget of all
#endif

#if defined(Q_OS_LINUX) && (defined(__x86_64__) || defined(__aarch64__))
#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#else
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#endif

// Calls that only compute, talk over streams that are open, or end.
const int harmlessCalls[] = {
    SYS_read,
    SYS_readv,
    SYS_write,
    SYS_writev,
    SYS_close,
    SYS_lseek,
    SYS_fstat,
    SYS_fcntl,
    SYS_ppoll,
    SYS_munmap,
    SYS_mremap,
    SYS_madvise,
    SYS_brk,
    SYS_futex,
    SYS_sched_yield,
    SYS_sched_getaffinity,
    SYS_set_robust_list,
    SYS_rseq,
    SYS_membarrier,
    SYS_rt_sigaction,
    SYS_rt_sigprocmask,
    SYS_rt_sigreturn,
    SYS_sigaltstack,
    SYS_restart_syscall,
    SYS_getpid,
    SYS_gettid,
    SYS_getuid,
    SYS_geteuid,
    SYS_getgid,
    SYS_getegid,
    SYS_getrandom,
    SYS_uname,
    SYS_sysinfo,
    SYS_getrusage,
    SYS_clock_gettime,
    SYS_clock_getres,
    SYS_clock_nanosleep,
    SYS_nanosleep,
    SYS_gettimeofday,
    SYS_eventfd2,
    SYS_pipe2,
    SYS_exit,
    SYS_exit_group,
#if defined(__x86_64__)
    SYS_poll,
    SYS_time,
#endif
};

using Filter = std::vector<sock_filter>;

void load(Filter& filter, std::size_t offset) {
    filter.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, std::uint32_t(offset)));
}
void answer(Filter& filter, std::uint32_t verdict) {
    filter.push_back(BPF_STMT(BPF_RET | BPF_K, verdict));
}
// The next instruction alone holds for calls where the word just loaded is this.
void ifEqual(Filter& filter, std::uint32_t value) {
    filter.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0, 1));
}

constexpr std::uint32_t refuse = SECCOMP_RET_ERRNO | EPERM;
constexpr std::size_t numberOffset = offsetof(seccomp_data, nr);
constexpr std::size_t argumentOffset(int index) { // its lower half
    return offsetof(seccomp_data, args) + std::size_t(index) * sizeof(std::uint64_t);
}

// A call that is harmless where `mask` of an argument is `wanted`: five instructions that others
// pass over.
void allowWhere(Filter& filter, int call, int argument, std::uint32_t mask, std::uint32_t wanted) {
    filter.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, std::uint32_t(call), 0, 5));
    load(filter, argumentOffset(argument));
    filter.push_back(BPF_STMT(BPF_ALU | BPF_AND | BPF_K, mask));
    ifEqual(filter, wanted);
    answer(filter, SECCOMP_RET_ALLOW);
    answer(filter, refuse);
}

Filter filterOfCalls() {
    constexpr std::uint32_t all = 0xffffffffu;
    constexpr std::uint32_t threadFlag = 0x10000; // CLONE_THREAD, linux/sched.h
    Filter filter;
    load(filter, offsetof(seccomp_data, arch));
    filter.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, architecture, 1, 0));
    answer(filter, SECCOMP_RET_KILL_PROCESS);
    load(filter, numberOffset);
    for (const int call : harmlessCalls) {
        ifEqual(filter, std::uint32_t(call));
        answer(filter, SECCOMP_RET_ALLOW);
    }
    // Says that there is no such call, at which the C library takes clone, whose flags can be seen.
    ifEqual(filter, SYS_clone3);
    answer(filter, SECCOMP_RET_ERRNO | ENOSYS);
    allowWhere(filter, SYS_clone, 0, threadFlag, threadFlag);
    allowWhere(filter, SYS_mmap, 2, PROT_EXEC, 0);
    allowWhere(filter, SYS_mprotect, 2, PROT_EXEC, 0);
    allowWhere(filter, SYS_prctl, 0, all, PR_SET_NAME);
    allowWhere(filter, SYS_prlimit64, 0, all, 0); // its own
    allowWhere(filter, SYS_tgkill, 0, all, std::uint32_t(getpid()));
    answer(filter, refuse);
    return filter;
}

bool filterCalls() {
    Filter filter = filterOfCalls();
    const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}
#else
bool filterCalls() {
    return true;
}
#endif

} // namespace

#if defined(Q_OS_UNIX)

void leaveSurroundings() {
#if defined(Q_OS_LINUX)
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    prctl(PR_SET_DUMPABLE, 0);
#if defined(SYS_close_range)
    syscall(SYS_close_range, 3u, ~0u, 0u);
#endif
#endif
}

bool confine() {
    // Ends at once: nothing can be told while it is not known what is being written.
    std::signal(SIGXCPU, [](int) { _exit(readerOutOfTime); });
    limit(RLIMIT_CORE, 0, 0);
    limit(RLIMIT_FSIZE, 0, 0);
    allowFor(0);
    return filterCalls();
}

void allowFor(qint64 fileBytes) {
    constexpr qint64 second = 1000;
    const qint64 time = mostOf(Budget::Milliseconds, fileBytes);
    // Past the last second the system kills; a second before it still says why.
    limit(RLIMIT_CPU, rlim_t((time + second - 1) / second),
          rlim_t(mostOf(Budget::Milliseconds, anyFile) / second + 2));
#if !defined(DIPWRIGHT_SANITIZED) // a sanitizer reserves terabytes for itself
#if defined(Q_OS_LINUX)
    const int memory = RLIMIT_DATA; // what is written to; reserved is more
#else
    const int memory = RLIMIT_AS;
#endif
    limit(memory, rlim_t(mostOf(Budget::Memory, fileBytes)),
          rlim_t(mostOf(Budget::Memory, anyFile)));
#endif
}

#elif defined(Q_OS_WIN)

void leaveSurroundings() {
    for (const int stream : {0, 1}) {
        _setmode(stream, _O_BINARY);
    }
}

// One process with the memory of the largest file: a job's limits are for good.
bool confine() {
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
    limits.BasicLimitInformation.LimitFlags =
        JOB_OBJECT_LIMIT_ACTIVE_PROCESS | JOB_OBJECT_LIMIT_PROCESS_MEMORY;
    limits.BasicLimitInformation.ActiveProcessLimit = 1;
    limits.ProcessMemoryLimit = SIZE_T(mostOf(Budget::Memory, mostOf(Budget::FileBytes)));
    const HANDLE job = CreateJobObjectW(nullptr, nullptr);
    return SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits,
                                   sizeof limits) != 0 &&
           AssignProcessToJobObject(job, GetCurrentProcess()) != 0;
}

void allowFor(qint64 /*fileBytes*/) {}

#endif

} // namespace dipwright
