/* Preloaded into a program. Kills the program, or makes the operation fail, at the Nth operation on
   files below one folder. Can also make the Nth allocation fail, counted from failAllocation().

   DIPWRIGHT_BREAK_BELOW   The folder. Operations elsewhere are neither broken nor counted.
   DIPWRIGHT_BREAK_AT      N, counted from 1. If it is 0 or unset, nothing is broken.
   DIPWRIGHT_BREAK_HOW     kill, EIO or ENOSPC break operation N. ESTALE breaks N, all later
                           operations and all queries about files, like a vanished network folder.
   DIPWRIGHT_BREAK_LOG     A file outside the folder. Each counted operation adds one line to it.

   All these variables may change while the program runs. If the program is killed at a write, half
   of the bytes have been written to the disk. */
#define _GNU_SOURCE
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

#define REAL(result, name, ...)                                                                    \
    static result (*real)(__VA_ARGS__);                                                            \
    if (!real) {                                                                                   \
        *(void**)&real = dlsym(RTLD_NEXT, #name);                                                  \
    }

static int counted;

static const char* below(void) {
    return getenv("DIPWRIGHT_BREAK_BELOW");
}

static int isWatched(const char* path) {
    const char* folder = below();
    char place[PATH_MAX + 16];
    if (!folder || !path) {
        return 0;
    }
    if (path[0] != '/') {
        if (!getcwd(place, PATH_MAX)) {
            return 0;
        }
        return strncmp(place, folder, strlen(folder)) == 0;
    }
    return strncmp(path, folder, strlen(folder)) == 0;
}

static int isWatchedFile(int file) {
    char link[64], path[PATH_MAX];
    if (!below()) {
        return 0;
    }
    snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    const ssize_t length = readlink(link, path, sizeof path - 1);
    if (length <= 0) {
        return 0;
    }
    path[length] = 0;
    return isWatched(path);
}

static void log_line(int number, const char* what, const char* path) {
    const char* name = getenv("DIPWRIGHT_BREAK_LOG");
    if (!name) {
        return;
    }
    REAL(int, open, const char*, int, ...)
    const int file = real(name, O_WRONLY | O_CREAT | O_APPEND, 0666);
    char line[PATH_MAX + 64];
    const int length = snprintf(line, sizeof line, "%d %s %s\n", number, what, path ? path : "");
    static ssize_t (*realWrite)(int, const void*, size_t);
    if (!realWrite) {
        *(void**)&realWrite = dlsym(RTLD_NEXT, "write");
    }
    if (realWrite(file, line, (size_t)length) < 0) {
        abort();
    }
    close(file);
}

/* Counts the operation. Returns 0: continue; −1: kill the program; else fail with this errno. */
static int counts(const char* what, const char* path) {
    const int saved = errno;
    const int number = __atomic_add_fetch(&counted, 1, __ATOMIC_SEQ_CST);
    log_line(number, what, path);
    const char* at = getenv("DIPWRIGHT_BREAK_AT");
    const char* how = getenv("DIPWRIGHT_BREAK_HOW");
    errno = saved;
    const int from = at && how ? atoi(at) : 0;
    if (from > 0 && number >= from && strcmp(how, "ESTALE") == 0) {
        return ESTALE;
    }
    if (from == 0 || number != from) {
        return 0;
    }
    return strcmp(how, "EIO") == 0 ? EIO : strcmp(how, "ENOSPC") == 0 ? ENOSPC : -1;
}

static void die(void) {
    kill(getpid(), SIGKILL);
    for (;;) {
        pause();
    }
}

#define BREAK(what, watched, path, failure)                                                        \
    if (watched) {                                                                                 \
        const int broken = counts(what, path);                                                     \
        if (broken < 0) {                                                                          \
            die();                                                                                 \
        }                                                                                          \
        if (broken > 0) {                                                                          \
            errno = broken;                                                                        \
            return failure;                                                                        \
        }                                                                                          \
    }

static mode_t modeOf(int flags, va_list arguments) {
    return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, mode_t) : 0;
}

#define OPEN(name)                                                                                 \
    int name(const char* path, int flags, ...) {                                                   \
        va_list arguments;                                                                         \
        va_start(arguments, flags);                                                                \
        const mode_t mode = modeOf(flags, arguments);                                              \
        va_end(arguments);                                                                         \
        REAL(int, name, const char*, int, ...)                                                     \
        BREAK("open", isWatched(path), path, -1)                                                   \
        return real(path, flags, mode);                                                            \
    }
OPEN(open)
OPEN(open64)

#define OPENAT(name)                                                                               \
    int name(int folder, const char* path, int flags, ...) {                                       \
        va_list arguments;                                                                         \
        va_start(arguments, flags);                                                                \
        const mode_t mode = modeOf(flags, arguments);                                              \
        va_end(arguments);                                                                         \
        REAL(int, name, int, const char*, int, ...)                                                \
        BREAK("open", isWatched(path), path, -1)                                                   \
        return real(folder, path, flags, mode);                                                    \
    }
OPENAT(openat)
OPENAT(openat64)

ssize_t write(int file, const void* bytes, size_t count) {
    REAL(ssize_t, write, int, const void*, size_t)
    if (isWatchedFile(file)) {
        const int broken = counts("write", "");
        if (broken < 0) {
            if (real(file, bytes, count / 2) >= 0) {
                die();
            }
            die();
        }
        if (broken > 0) {
            errno = broken;
            return -1;
        }
    }
    return real(file, bytes, count);
}

#define ON_FILE(what, name)                                                                        \
    int name(int file) {                                                                           \
        REAL(int, name, int)                                                                       \
        BREAK(what, isWatchedFile(file), "", -1)                                                   \
        return real(file);                                                                         \
    }
ON_FILE("fsync", fsync)
ON_FILE("fsync", fdatasync)

#define TRUNCATE(name, type)                                                                       \
    int name(int file, type length) {                                                              \
        REAL(int, name, int, type)                                                                 \
        BREAK("truncate", isWatchedFile(file), "", -1)                                             \
        return real(file, length);                                                                 \
    }
TRUNCATE(ftruncate, off_t)
TRUNCATE(ftruncate64, off64_t)

int flock(int file, int operation) {
    REAL(int, flock, int, int)
    BREAK("lock", isWatchedFile(file), "", -1)
    return real(file, operation);
}

int fchmod(int file, mode_t mode) {
    REAL(int, fchmod, int, mode_t)
    BREAK("mode", isWatchedFile(file), "", -1)
    return real(file, mode);
}

#define ON_PATH(what, name)                                                                        \
    int name(const char* path) {                                                                   \
        REAL(int, name, const char*)                                                               \
        BREAK(what, isWatched(path), path, -1)                                                     \
        return real(path);                                                                         \
    }
ON_PATH("unlink", unlink)
ON_PATH("rmdir", rmdir)

int remove(const char* path) {
    REAL(int, remove, const char*)
    BREAK("unlink", isWatched(path), path, -1)
    return real(path);
}

int unlinkat(int folder, const char* path, int flags) {
    REAL(int, unlinkat, int, const char*, int)
    BREAK("unlink", isWatched(path), path, -1)
    return real(folder, path, flags);
}

int mkdir(const char* path, mode_t mode) {
    REAL(int, mkdir, const char*, mode_t)
    BREAK("mkdir", isWatched(path), path, -1)
    return real(path, mode);
}

int mkdirat(int folder, const char* path, mode_t mode) {
    REAL(int, mkdirat, int, const char*, mode_t)
    BREAK("mkdir", isWatched(path), path, -1)
    return real(folder, path, mode);
}

int rename(const char* from, const char* to) {
    REAL(int, rename, const char*, const char*)
    BREAK("rename", isWatched(to), to, -1)
    return real(from, to);
}

int renameat(int fromFolder, const char* from, int toFolder, const char* to) {
    REAL(int, renameat, int, const char*, int, const char*)
    BREAK("rename", isWatched(to), to, -1)
    return real(fromFolder, from, toFolder, to);
}

int renameat2(int fromFolder, const char* from, int toFolder, const char* to, unsigned flags) {
    REAL(int, renameat2, int, const char*, int, const char*, unsigned)
    BREAK("rename", isWatched(to), to, -1)
    return real(fromFolder, from, toFolder, to, flags);
}

int linkat(int fromFolder, const char* from, int toFolder, const char* to, int flags) {
    REAL(int, linkat, int, const char*, int, const char*, int)
    BREAK("link", isWatched(to), to, -1)
    return real(fromFolder, from, toFolder, to, flags);
}

/* Operations that only read information about files are not counted. */

static int isGone(const char* path) {
    const char* at = getenv("DIPWRIGHT_BREAK_AT");
    const char* how = getenv("DIPWRIGHT_BREAK_HOW");
    const int from = at && how && strcmp(how, "ESTALE") == 0 ? atoi(at) : 0;
    if (from == 0 || __atomic_load_n(&counted, __ATOMIC_SEQ_CST) + 1 < from || !isWatched(path)) {
        return 0;
    }
    errno = ESTALE;
    return 1;
}

#define LOOK(name, type)                                                                           \
    int name(const char* path, type* seen) {                                                       \
        REAL(int, name, const char*, type*)                                                        \
        return isGone(path) ? -1 : real(path, seen);                                               \
    }
LOOK(stat, struct stat)
LOOK(lstat, struct stat)

int statx(int folder, const char* path, int flags, unsigned mask, struct statx* seen) {
    REAL(int, statx, int, const char*, int, unsigned, struct statx*)
    return isGone(path) ? -1 : real(folder, path, flags, mask, seen);
}

int access(const char* path, int mode) {
    REAL(int, access, const char*, int)
    return isGone(path) ? -1 : real(path, mode);
}

DIR* opendir(const char* path) {
    REAL(DIR*, opendir, const char*)
    return isGone(path) ? NULL : real(path);
}

/* Allocations. */

extern void* __libc_malloc(size_t);
extern void* __libc_calloc(size_t, size_t);
extern void* __libc_realloc(void*, size_t);

static long allocationsLeft = -1; /* −1: allocations are not counted */

/* Makes the Nth allocation from now on fail. 0: only counts. */
void failAllocation(long number) {
    __atomic_store_n(&allocationsLeft, number > 0 ? number : LONG_MAX, __ATOMIC_SEQ_CST);
}

/* Returns the number of allocations since failAllocation() and stops counting. */
long allocations(void) {
    return LONG_MAX - __atomic_exchange_n(&allocationsLeft, -1, __ATOMIC_SEQ_CST);
}

static int failsNow(void) {
    if (__atomic_load_n(&allocationsLeft, __ATOMIC_RELAXED) <= 0) {
        return 0;
    }
    const int fails = __atomic_sub_fetch(&allocationsLeft, 1, __ATOMIC_SEQ_CST) == 0;
    if (fails) {
        errno = ENOMEM;
    }
    return fails;
}

void* malloc(size_t size) {
    return failsNow() ? NULL : __libc_malloc(size);
}

void* calloc(size_t count, size_t size) {
    return failsNow() ? NULL : __libc_calloc(count, size);
}

void* realloc(void* memory, size_t size) {
    return failsNow() ? NULL : __libc_realloc(memory, size);
}
