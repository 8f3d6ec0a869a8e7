/* SPDX-License-Identifier: MIT
 * Preloaded into the program, this lets one call fail: the FAULT_AT-th of the kind FAULT_CALL, or
 * from that one on with FAULT_STAYS=1. FAULT_HOW says how: the number of an error, "short" for a
 * short write, or "kill". Only files whose path has FAULT_UNDER in it count. With FAULT_CALL=new the
 * FAULT_AT-th allocation after the start of main() throws. Once one has failed, a file FAULT_MARK is
 * there. FAULT_CLOCK sets the wall clock forward by so many seconds at every other look, and back at
 * the next. Libraries with FAULT_LIBRARY in their names are not there. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <time.h>
#include <unistd.h>

int isDue(const char* call);
extern atomic_int faultInMain;

static atomic_long calls;
atomic_int faultInMain;

static const char* setting(const char* name)
{
    const char* value = getenv(name);
    return value != NULL ? value : "";
}

/* Whether this call is to fail. */
int isDue(const char* call)
{
    if (strcmp(setting("FAULT_CALL"), call) != 0)
    {
        return 0;
    }
    const long at = atol(setting("FAULT_AT"));
    const long now = atomic_fetch_add(&calls, 1) + 1;
    if (now != at && !(now > at && strcmp(setting("FAULT_STAYS"), "1") == 0))
    {
        return 0;
    }
    const int mark = (int)syscall(SYS_openat, AT_FDCWD, setting("FAULT_MARK"), O_CREAT | O_RDWR, 0600);
    if (mark >= 0)
    {
        syscall(SYS_close, mark);
    }
    if (strcmp(setting("FAULT_HOW"), "kill") == 0)
    {
        kill(getpid(), SIGKILL);
    }
    errno = atoi(setting("FAULT_HOW"));
    return 1;
}

static int isUnder(const char* path)
{
    const char* under = setting("FAULT_UNDER");
    return path != NULL && *under != '\0' && strstr(path, under) != NULL;
}

static int isOpenUnder(int descriptor)
{
    char link[64];
    char path[PATH_MAX];
    snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
    const ssize_t size = readlink(link, path, sizeof path - 1);
    path[size > 0 ? size : 0] = '\0';
    return isUnder(path);
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

int open(const char* path, int flags, ...)
{
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    if ((flags & O_CREAT) != 0 && isUnder(path) && isDue("open"))
    {
        return -1;
    }
    return REAL(open)(path, flags, mode);
}

ssize_t write(int descriptor, const void* bytes, size_t size)
{
    if (isOpenUnder(descriptor) && isDue("write"))
    {
        if (strcmp(setting("FAULT_HOW"), "short") != 0)
        {
            return -1;
        }
        size = size > 1 ? size / 2 : size;
    }
    return REAL(write)(descriptor, bytes, size);
}

int fsync(int descriptor)
{
    return isOpenUnder(descriptor) && isDue("fsync") ? -1 : REAL(fsync)(descriptor);
}

int close(int descriptor)
{
    if (isOpenUnder(descriptor) && isDue("close"))
    {
        const int error = errno;
        REAL(close)(descriptor);
        errno = error;
        return -1;
    }
    return REAL(close)(descriptor);
}

int rename(const char* from, const char* to)
{
    return isUnder(to) && isDue("rename") ? -1 : REAL(rename)(from, to);
}

int unlink(const char* path)
{
    return isUnder(path) && isDue("unlink") ? -1 : REAL(unlink)(path);
}

void* dlopen(const char* name, int flags)
{
    const char* missing = setting("FAULT_LIBRARY");
    const int isMissing = name != NULL && *missing != '\0' && strstr(name, missing) != NULL;
    return isMissing ? NULL : REAL(dlopen)(name, flags);
}

int clock_gettime(clockid_t clock, struct timespec* now)
{
    static atomic_long looks;
    const int result = REAL(clock_gettime)(clock, now);
    const long step = atol(setting("FAULT_CLOCK"));
    if (clock == CLOCK_REALTIME && step != 0)
    {
        now->tv_sec += atomic_fetch_add(&looks, 1) % 2 == 0 ? step : -step;
    }
    return result;
}

static int (*realMain)(int, char**, char**);

static int markedMain(int count, char** words, char** environment)
{
    atomic_store(&faultInMain, 1);
    const int code = realMain(count, words, environment);
    atomic_store(&faultInMain, 0);
    return code;
}

int __libc_start_main(int (*main)(int, char**, char**), int count, char** words,
                      void (*init)(void), void (*fini)(void), void (*linkerFini)(void), void* stack)
{
    realMain = main;
    return ((__typeof__(&__libc_start_main))dlsym(RTLD_NEXT, "__libc_start_main"))(
        markedMain, count, words, init, fini, linkerFini, stack);
}
