/* Preloaded into LinuxCNC's processes: their clock runs CLOCK_RATE times faster than the wall's.
 *
 * The real-time thread counts servo periods and never measures them, so its log is the same at any
 * rate as long as the interpreter keeps the motion queue filled. Both clocks count from boot; a time
 * scaled from that common origin converts the same way whether it is absolute or a difference.
 *
 * SPDX-License-Identifier: LGPL-2.1-or-later
 */
#define _GNU_SOURCE
#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

enum { BILLION = 1000000000 };
static double rate = 1.0;

/* Scripts, halcmd and halsampler keep the wall's clock: their time-outs are the user's. */
__attribute__((constructor)) static void read_rate(void) {
  static const char* const scaled[] = {"rtapi_app", "milltask", "io"};
  const char* text = getenv("CLOCK_RATE");
  for (size_t i = 0; text && i < sizeof scaled / sizeof *scaled; ++i)
    if (!strcmp(program_invocation_short_name, scaled[i])) rate = atof(text);
  if (!(rate > 0.0)) rate = 1.0;
}

static struct timespec times(const struct timespec* t, long double factor) {
  const long double whole = ((long double)t->tv_sec * BILLION + t->tv_nsec) * factor;
  const int64_t nanoseconds = (int64_t)whole;
  return (struct timespec){nanoseconds / BILLION, nanoseconds % BILLION};
}

static int raw_clock(clockid_t id, struct timespec* t) {
  return (int)syscall(SYS_clock_gettime, id, t);
}

int clock_gettime(clockid_t id, struct timespec* t) {
  const int status = raw_clock(id, t);
  if (!status && id == CLOCK_MONOTONIC) *t = times(t, rate);
  return status;
}

int gettimeofday(struct timeval* restrict tv, void* restrict zone) {
  (void)zone;
  struct timespec t;
  const int status = raw_clock(rate == 1.0 ? CLOCK_REALTIME : CLOCK_MONOTONIC, &t);
  t = times(&t, rate);
  *tv = (struct timeval){t.tv_sec, t.tv_nsec / 1000};
  return status;
}

static int pause_for(clockid_t id, int flags, const struct timespec* request,
                     struct timespec* left) {
  const struct timespec real = times(request, 1.0L / rate);
  return syscall(SYS_clock_nanosleep, id, flags, &real, left) ? errno : 0;
}

int clock_nanosleep(clockid_t id, int flags, const struct timespec* request,
                    struct timespec* left) {
  return pause_for(id, flags, request, left);
}

int nanosleep(const struct timespec* request, struct timespec* left) {
  const int status = pause_for(CLOCK_MONOTONIC, 0, request, left);
  if (status) errno = status;
  return status ? -1 : 0;
}
