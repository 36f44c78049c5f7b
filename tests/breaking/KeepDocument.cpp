// Handles a document's files as the window does, but without a window, so that BreakingTest can
// break it:
//   save JOB               opens, changes and saves a project
//   keep JOB FOLDER        opens and changes a project and keeps a recovery copy in FOLDER
//   recover FOLDER         reads the recovery copies, as the next start does
//   export JOB FOLDER      runs the job and writes its results
//   cycles JOB FOLDER N    opens, changes, saves, exports and closes a project N times; prints the
//                          resources held after a tenth of the cycles and after all, one line each
//   count-allocations JOB  prints how many allocations opening and saving needs
//   allocations JOB FIRST LAST STRIDE
//                          for each number N from FIRST to LAST in steps of STRIDE, opens and
//                          saves in a new process whose allocation N fails; prints the outcomes

#include "base/Error.h"
#include "base/ProgramName.h"
#include "disk/FileVersion.h"
#include "disk/UnfinishedWrites.h"
#include "parallel/Threads.h"
#include "pipeline/Pipeline.h"
#include "pipeline/WriteResults.h"
#include "project/ProjectStore.h"
#include "solver/SolverRegistry.h"
#include "workbench/document/Document.h"
#include "workbench/document/Recovery.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QGuiApplication>
#include <cstdio>
#include <dlfcn.h>
#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace dipwright;

namespace {

void change(Document& document) {
    document.edit(QStringLiteral("Swell"), {},
                  [](Project& project) { project.film.swellX = 1.125; });
}

void saveNow(Document& document) {
    const DocumentSnapshot snapshot = document.beginSave();
    document.endSave(snapshot, snapshot.write({}));
}

void save(const QString& job) {
    const FileVersion version = FileVersion::of(job);
    Document document(loadProject(job), job, version);
    document.lock();
    change(document);
    saveNow(document);
}

void keep(const QString& job, const QString& folder) {
    Document document(loadProject(job), job);
    AutoSaver saver(document, folder);
    change(document);
    saver.keepNow();
    saver.waitForCopy();
    if (QDir(folder, QStringLiteral("*.dipw")).isEmpty()) {
        throw Error(QStringLiteral("Nothing was kept"), folder);
    }
}

void exportResults(const QString& job, const QString& folder) {
    JobOptions options;
    options.estimatesNumericalError = false;
    const Project project = loadProject(job);
    writeResults(project, runJob(project, SolverRegistry(), options, nullptr, {}), folder, {});
}

int entriesBelow(const QString& folder) {
    QDirIterator all(folder, QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot,
                     QDirIterator::Subdirectories);
    int count = 0;
    for (; all.hasNext(); all.next()) {
        ++count;
    }
    return count;
}

// Prints the resources that the process holds. They are allocated memory in kB, open files, and
// entries in the folder for temporary files. The memory is complete only with MALLOC_ARENA_MAX=1,
// and does not include memory that the allocator caches.
void printResources() {
    const struct mallinfo2 memory = mallinfo2();
    std::printf("%ld %d %d\n", long((memory.uordblks + memory.hblkhd) / 1024),
                int(QDir(QStringLiteral("/proc/self/fd")).count()), entriesBelow(QDir::tempPath()));
}

void cycle(const QString& job, const QString& folder, int number) {
    const FileVersion version = FileVersion::of(job);
    Document document(loadProject(job), job, version);
    document.lock();
    AutoSaver saver(document, folder + QStringLiteral("/recovery"));
    document.edit(QStringLiteral("Swell"), {},
                  [&](Project& project) { project.film.swellX = 1 + 0.01 * (number % 9 + 1); });
    saver.keepNow();
    saver.waitForCopy();
    saveNow(document);
    exportResults(job, folder + QStringLiteral("/out"));
}

void cycles(const QString& job, const QString& folder, int count) {
    for (int number = 1; number <= count; ++number) {
        cycle(job, folder, number);
        if (number == count / 10 || number == count) {
            printResources();
        }
    }
}

// Calls the function of the preloaded library (BreakFiles.c).
void failAllocation(long number) {
    const auto call = reinterpret_cast<void (*)(long)>(dlsym(RTLD_DEFAULT, "failAllocation"));
    call(number);
}
// Calls the function of the preloaded library.
long allocations() {
    return reinterpret_cast<long (*)()>(dlsym(RTLD_DEFAULT, "allocations"))();
}

constexpr unsigned processTimeoutSeconds = 60;

enum Exit { Done = 0, ErrorReported = 1, OtherException = 2, Damaged = 3 };

// Runs `work` in a separate process in which the given allocation fails. Returns the exit code, or
// −1 if the process crashed.
template <typename Work>
int lifeWith(long allocation, const Work& work) {
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        alarm(processTimeoutSeconds); // TBB sometimes waits for ever
        int code = Done;
        failAllocation(allocation);
        try {
            work();
        } catch (const Error&) {
            code = ErrorReported;
        } catch (const std::bad_alloc&) {
            code = ErrorReported;
        } catch (...) {
            code = OtherException;
        }
        const long count = allocations();
        if (allocation == 0) {
            std::printf("%ld\n", count);
            std::fflush(stdout);
        }
        _exit(code);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

QByteArray contentsOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

// Opens and saves a copy of the job while one allocation fails, for each number from `first` to
// `last` in steps of `stride`. Prints how often each outcome occurred.
void allocationsOf(const QString& job, long first, long last, long stride) {
    const QString copy = job + QStringLiteral(".copy");
    QFile::remove(copy);
    QFile::copy(job, copy);
    const QByteArray before = contentsOf(copy);
    const auto both = [&] {
        const ThreadLimit one(1);
        Project project = loadProject(copy);
        project.film.swellX = 1.25;
        saveProject(project, copy);
    };
    lifeWith(LONG_MAX - 1, both);
    const QByteArray after = contentsOf(copy);
    long outcomes[4] = {}, crashes = 0, lost = 0, lives = 0;
    for (long number = first; number <= last; number += stride) {
        QFile file(copy);
        file.open(QIODevice::WriteOnly);
        file.write(before);
        file.close();
        const int code = lifeWith(number, both);
        ++lives;
        ++(code < 0 ? crashes : outcomes[code]);
        const QByteArray now = contentsOf(copy);
        lost += now != before && now != after ? 1 : 0;
        recoverUnfinishedWrites();
    }
    std::printf("allocations %ld done %ld told %ld other %ld crashed %ld lost %ld\n", lives,
                outcomes[Done], outcomes[ErrorReported], outcomes[OtherException], crashes, lost);
}

int run(const QStringList& words) {
    const QString& what = words.value(1);
    if (what == QLatin1String("save")) {
        save(words.value(2));
    } else if (what == QLatin1String("keep")) {
        keep(words.value(2), words.value(3));
    } else if (what == QLatin1String("recover")) {
        findRecoveredDocuments(words.value(2));
    } else if (what == QLatin1String("export")) {
        exportResults(words.value(2), words.value(3));
    } else if (what == QLatin1String("cycles")) {
        cycles(words.value(2), words.value(3), words.value(4).toInt());
    } else if (what == QLatin1String("count-allocations")) {
        lifeWith(0, [&] {
            const ThreadLimit one(1);
            saveProject(loadProject(words.value(2)), words.value(2));
        });
    } else if (what == QLatin1String("allocations")) {
        allocationsOf(words.value(2), words.value(3).toLong(), words.value(4).toLong(),
                      words.value(5).toLong());
    } else {
        return 2;
    }
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication application(argc, argv);
    nameProgram();
    recoverUnfinishedWrites();
    try {
        return run(QCoreApplication::arguments());
    } catch (const Error& error) {
        std::fprintf(stderr, "error: %s\n", qPrintable(error.sentence()));
        return 1;
    }
}
