// Tests which operations the reader's sandbox still allows.
#include "reader/Sandbox.h"
#include "TestFolders.h"

#include "base/Budgets.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <functional>
#include <thread>

#ifdef Q_OS_LINUX
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

using namespace dipwright;

class SandboxTest : public QObject {
    Q_OBJECT

#ifdef Q_OS_LINUX
private slots:
    void sandbox_openFile_isDenied() {
        QVERIFY(isFalse([] { return ::open("/etc/passwd", O_RDONLY) >= 0; }));
        QVERIFY(isFalse([] { return ::open("confinement", O_CREAT | O_WRONLY, 0600) >= 0; }));
        QVERIFY(isFalse([] { return ::access("/etc/passwd", R_OK) == 0; }));
        QVERIFY(isFalse([] { return ::unlink("confinement") == 0 || errno == ENOENT; }));
    }

    void sandbox_openSocket_isDenied() {
        for (const int family : {AF_INET, AF_INET6, AF_UNIX}) {
            QVERIFY(isFalse([family] { return ::socket(family, SOCK_STREAM, 0) >= 0; }));
        }
    }

    void sandbox_startOrKillProcess_isDenied() {
        QVERIFY(isFalse([] { return ::fork() >= 0; }));
        QVERIFY(
            isFalse([] { return ::execl("/bin/true", "true", nullptr) == 0 || errno != EPERM; }));
        QVERIFY(isFalse([] { return ::kill(::getppid(), 0) == 0; }));
    }

    void sandbox_executableMemory_isDenied() {
        QVERIFY(isFalse([] {
            return ::mmap(nullptr, 4096, PROT_READ | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1,
                          0) != MAP_FAILED;
        }));
        QVERIFY(isFalse([] {
            void* page =
                ::mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
            return ::mprotect(page, 4096, PROT_READ | PROT_EXEC) == 0;
        }));
    }

    // Libraries use threads.
    void sandbox_startThread_isAllowed() {
        QVERIFY(isTrue([] {
            int answer = 0;
            std::thread([&] { answer = 42; }).join();
            return answer == 42;
        }));
    }

    void sandbox_memoryLimit_growsWithFile() {
#if defined(DIPWRIGHT_SANITIZED)
        return; // sanitizers reserve terabytes of address space
#endif
        const auto take = [](qint64 bytes) {
            return ::mmap(nullptr, std::size_t(bytes), PROT_READ | PROT_WRITE,
                          MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) != MAP_FAILED;
        };
        const qint64 most = budgetLimit(Budget::Memory);
        QVERIFY(isTrue([&] { return take(most / 2); }));
        QVERIFY(isFalse([&] { return take(most); }));
        constexpr qint64 fileBytes = 100 << 20;
        QVERIFY(isTrue([&] {
            raiseLimits({}, fileBytes);
            return take(most);
        }));
    }

    void sandbox_endlessLoop_isEnded() {
        QCOMPARE(outcome([]() -> bool {
                     volatile unsigned turns = 0;
                     while (true) {
                         turns = turns + 1;
                     }
                 }),
                 outOfTime);
    }

    void sandbox_raiseLimits_isDenied() {
        const auto lift = [] {
            rlimit none{};
            none.rlim_cur = none.rlim_max = RLIM_INFINITY;
            return ::setrlimit(RLIMIT_CPU, &none) == 0 || ::setrlimit(RLIMIT_FSIZE, &none) == 0 ||
                   ::setrlimit(RLIMIT_CORE, &none) == 0;
        };
        const auto becomeNobody = [] { // root may raise any limit
            if (::geteuid() == 0 && ::setuid(65534) != 0) {
                ::_exit(yes);
            }
        };
        QCOMPARE(outcome(lift, becomeNobody), no);
    }

    void sandbox_noSystemFilters_isReported() {
        QCOMPARE(outcome([] { return true; }, refuseFilters), unconfined);
    }

    // DIPWRIGHT_READ_UNCONFINED=1 allows reading without a sandbox.
    void new_noSandbox_readsModelOnlyIfAllowed() {
        const QTemporaryDir folder;
        const QString model = folder.filePath(QStringLiteral("body.obj"));
        QFile file(model);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
        file.close();
        const auto read = [&](const QString& name, const QString& unconfinedToo) {
            QProcess program;
            program.setChildProcessModifier(refuseFilters);
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            environment.remove(QStringLiteral("DIPWRIGHT_READ_UNCONFINED"));
            if (!unconfinedToo.isEmpty()) {
                environment.insert(QStringLiteral("DIPWRIGHT_READ_UNCONFINED"), unconfinedToo);
            }
            program.setProcessEnvironment(environment);
            program.start(binaryFolder("/dipwright-cli"),
                          {QStringLiteral("new"), folder.filePath(name), QStringLiteral("--model"),
                           model, QStringLiteral("--size-mm"), QStringLiteral("40")});
            program.waitForFinished(-1);
            return program.readAllStandardError();
        };
        const QByteArray refused = read(QStringLiteral("refused.dipw"), {});
        QVERIFY2(refused.contains("DIPWRIGHT_READ_UNCONFINED=1"), refused);
        QVERIFY(!QFile::exists(folder.filePath(QStringLiteral("refused.dipw"))));
        const QByteArray trusted = read(QStringLiteral("trusted.dipw"), QStringLiteral("1"));
        QVERIFY2(QFile::exists(folder.filePath(QStringLiteral("trusted.dipw"))), trusted);
    }

private:
    static constexpr int outOfTime = 3, yes = 10, no = 11, unconfined = 12;

    // Makes the system refuse filters to this process and its children, as a system without seccomp
    // does. Both the call seccomp() and the older prctl() fail.
    static void refuseFilters() {
        static sock_filter filter[] = {
            // Lower half of the argument.
            BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
            BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_seccomp, 3, 0),
            BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_prctl, 0, 3),
            BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, args)),
            BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, PR_SET_SECCOMP, 0, 1),
            BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EINVAL),
            BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
        };
        const sock_fprog program{std::size(filter), filter};
        ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
        ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
    }

    // Answers `question` in a sandboxed child process. Returns the exit code of the process, or −N
    // if signal N ended it.
    static int outcome(
        const std::function<bool()>& question, const std::function<void()>& before = [] {}) {
        const pid_t child = ::fork();
        if (child == 0) {
            before();
            if (!enterSandbox({})) {
                ::_exit(unconfined);
            }
            ::_exit(question() ? yes : no);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }
    static bool isTrue(const std::function<bool()>& question) {
        return outcome(question) == yes;
    }
    static bool isFalse(const std::function<bool()>& question) {
        return outcome(question) == no;
    }
#endif
};

QTEST_GUILESS_MAIN(SandboxTest)
#include "SandboxTest.moc"
