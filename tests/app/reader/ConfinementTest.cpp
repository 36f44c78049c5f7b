// What a process can still do that is about to read a foreign file.
#include "reader/Confinement.h"

#include "base/Budgets.h"

#include <QFile>
#include <QtTest>

#include <functional>
#include <thread>

#ifdef Q_OS_LINUX
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

using namespace dipwright;

class ConfinementTest : public QObject {
    Q_OBJECT

#ifdef Q_OS_LINUX
private slots:
    void filesCannotBeOpened() {
        QVERIFY(isFalse([] { return ::open("/etc/passwd", O_RDONLY) >= 0; }));
        QVERIFY(isFalse([] { return ::open("confinement", O_CREAT | O_WRONLY, 0600) >= 0; }));
        QVERIFY(isFalse([] { return ::access("/etc/passwd", R_OK) == 0; }));
        QVERIFY(isFalse([] { return ::unlink("confinement") == 0 || errno == ENOENT; }));
    }

    void nobodyCanBeCalled() {
        for (const int family : {AF_INET, AF_INET6, AF_UNIX}) {
            QVERIFY(isFalse([family] { return ::socket(family, SOCK_STREAM, 0) >= 0; }));
        }
    }

    void noOtherProgramCanBeStartedOrHarmed() {
        QVERIFY(isFalse([] { return ::fork() >= 0; }));
        QVERIFY(
            isFalse([] { return ::execl("/bin/true", "true", nullptr) == 0 || errno != EPERM; }));
        QVERIFY(isFalse([] { return ::kill(::getppid(), 0) == 0; }));
    }

    void nothingCanBeMadeAProgram() {
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

    // Libraries spread their work.
    void threadsCanBeStarted() {
        QVERIFY(isTrue([] {
            int answer = 0;
            std::thread([&] { answer = 42; }).join();
            return answer == 42;
        }));
    }

    void memoryIsThatOfTheFile() {
#if defined(DIPWRIGHT_SANITIZED)
        return; // a sanitizer reserves terabytes
#endif
        const auto take = [](qint64 bytes) {
            return ::mmap(nullptr, std::size_t(bytes), PROT_READ | PROT_WRITE,
                          MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) != MAP_FAILED;
        };
        const qint64 most = mostOf(Budget::Memory);
        QVERIFY(isTrue([&] { return take(most / 2); }));
        QVERIFY(isFalse([&] { return take(most); }));
        constexpr qint64 fileBytes = 100 << 20;
        QVERIFY(isTrue([&] {
            allowFor(fileBytes);
            return take(most);
        }));
    }

    void computingForeverEnds() {
        QCOMPARE(outcome([]() -> bool {
                     volatile unsigned turns = 0;
                     while (true) {
                         turns = turns + 1;
                     }
                 }),
                 outOfTime);
    }

private:
    static constexpr int outOfTime = 3, yes = 10, no = 11;

    // How a process ends that asks `question` when it is confined.
    static int outcome(const std::function<bool()>& question) {
        const pid_t child = ::fork();
        if (child == 0) {
            confine();
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

QTEST_GUILESS_MAIN(ConfinementTest)
#include "ConfinementTest.moc"
