/* Library for LD_PRELOAD: adds an offset to the system clock of a program.
 *
 * The offset is in seconds, a double in the file $CLOCK_OFFSET_FILE, and it may change at any time.
 * The monotonic clock stays as it is, as on a machine whose clock is set. libfaketime 0.9.10 does
 * the same, but with it `time.sleep` of Python 3.11 and later fails with EINVAL, and it reads its
 * file at each look at the clock.
 */
#define _GNU_SOURCE
#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

static const volatile double *offset;

__attribute__((constructor)) static void map_offset(void) {
    const char *path = getenv("CLOCK_OFFSET_FILE");
    int file = path ? open(path, O_RDONLY | O_CLOEXEC) : -1;
    if (file < 0)
        return;
    void *place = mmap(NULL, sizeof(double), PROT_READ, MAP_SHARED, file, 0);
    if (place != MAP_FAILED)
        offset = place;
    close(file);
}

static void now_with_offset(struct timespec *now) {
    syscall(SYS_clock_gettime, CLOCK_REALTIME, now);
    now->tv_sec += offset ? (time_t)*offset : 0;
}

int clock_gettime(clockid_t clock, struct timespec *now) {
    if (clock != CLOCK_REALTIME && clock != CLOCK_REALTIME_COARSE)
        return syscall(SYS_clock_gettime, clock, now);
    now_with_offset(now);
    return 0;
}

int gettimeofday(struct timeval *now, void *zone) {
    struct timespec precise;
    (void)zone;
    now_with_offset(&precise);
    now->tv_sec = precise.tv_sec;
    now->tv_usec = precise.tv_nsec / 1000;
    return 0;
}

time_t time(time_t *place) {
    struct timespec now;
    now_with_offset(&now);
    if (place)
        *place = now.tv_sec;
    return now.tv_sec;
}
