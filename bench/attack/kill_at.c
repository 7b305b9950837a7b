/* Counts system calls on files of one folder and kills the program at one of them. Loaded with LD_PRELOAD by killing.py.

   Environment:
     KILL_AT_FOLDER   absolute path, without symbolic links; only calls on files and folders below it count
     KILL_AT_CONTROL  a file of the size of struct control, which the driver and the program map into memory
     KILL_AT_KIND     0 rename, 1 write, 2 fsync; without it, calls are counted but the program is not killed
     KILL_AT_NUMBER   number of the call of that kind since the driver set `armed`, from 1
     KILL_AT_WHEN     before or after

   Calls from within the C library (fwrite) are not intercepted. The program writes its files with write(), SQLite with
   pwrite64(). */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

enum kind { RENAME, WRITE, FSYNC, KINDS };

/* In shared memory, so that the counts survive the program. The layout must equal that of FIELDS in killing.py. */
struct control {
  _Atomic uint64_t armed;
  _Atomic uint64_t struck;
  _Atomic uint64_t calls[KINDS];
};

static struct control *control;
static const char *folder;
static int wanted_kind = -1;
static uint64_t wanted_number;
static int dies_before;

__attribute__((constructor)) static void begin(void) {
  const char *file = getenv("KILL_AT_CONTROL");
  folder = getenv("KILL_AT_FOLDER");
  if (file == NULL || folder == NULL) return;
  const int descriptor = open(file, O_RDWR | O_CLOEXEC);
  if (descriptor < 0) return;
  void *memory = mmap(NULL, sizeof(struct control), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  close(descriptor);
  if (memory == MAP_FAILED) return;
  const char *kind = getenv("KILL_AT_KIND");
  const char *number = getenv("KILL_AT_NUMBER");
  const char *when = getenv("KILL_AT_WHEN");
  if (kind != NULL && number != NULL && when != NULL) {
    wanted_kind = atoi(kind);
    wanted_number = strtoull(number, NULL, 10);
    dies_before = strcmp(when, "before") == 0;
  }
  control = memory;
}

static int is_below_folder(const char *path) {
  const size_t length = strlen(folder);
  return strncmp(path, folder, length) == 0 && (path[length] == '/' || path[length] == '\0');
}

/* Only regular files and folders below the watched folder count; sockets, pipes and terminals do not. */
static int is_watched_descriptor(int descriptor) {
  if (control == NULL) return 0;
  struct stat status;
  if (fstat(descriptor, &status) != 0 || !(S_ISREG(status.st_mode) || S_ISDIR(status.st_mode))) return 0;
  char link[64];
  char path[PATH_MAX];
  snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t length = readlink(link, path, sizeof path - 1);
  if (length < 0) return 0;
  path[length] = '\0';
  return is_below_folder(path);
}

static int is_watched_path(int at, const char *path) {
  if (control == NULL) return 0;
  char whole[PATH_MAX + 64];
  char resolved[PATH_MAX];
  if (path[0] == '/')
    snprintf(whole, sizeof whole, "%s", path);
  else if (at == AT_FDCWD)
    snprintf(whole, sizeof whole, "./%s", path);
  else
    snprintf(whole, sizeof whole, "/proc/self/fd/%d/%s", at, path);
  return realpath(whole, resolved) != NULL && is_below_folder(resolved);
}

/* Counts a call, and returns whether it is the one at which to kill the program. */
static int is_the_one(enum kind kind) {
  if (!atomic_load(&control->armed)) return 0;
  const uint64_t number = atomic_fetch_add(&control->calls[kind], 1) + 1;
  return (int)kind == wanted_kind && number == wanted_number;
}

static void die(void) {
  atomic_store(&control->struck, 1);
  kill(getpid(), SIGKILL);
  for (;;) pause(); /* the signal may reach another thread first */
}

/* Defines a function that replaces that of the C library and calls it. */
#define WATCH(kind, is_watched, result_type, name, parameters, arguments)        \
  result_type name parameters {                                                  \
    static result_type(*real) parameters;                                        \
    if (real == NULL) real = (result_type(*) parameters)dlsym(RTLD_NEXT, #name); \
    const int dies = (is_watched) && is_the_one(kind);                           \
    if (dies && dies_before) die();                                              \
    const result_type result = real arguments;                                   \
    if (dies) die();                                                             \
    return result;                                                               \
  }

WATCH(RENAME, is_watched_path(AT_FDCWD, from), int, rename, (const char *from, const char *to), (from, to))
WATCH(RENAME, is_watched_path(from_at, from), int, renameat, (int from_at, const char *from, int to_at, const char *to),
      (from_at, from, to_at, to))
WATCH(RENAME, is_watched_path(from_at, from), int, renameat2,
      (int from_at, const char *from, int to_at, const char *to, unsigned flags), (from_at, from, to_at, to, flags))

WATCH(WRITE, is_watched_descriptor(file), ssize_t, write, (int file, const void *data, size_t size), (file, data, size))
WATCH(WRITE, is_watched_descriptor(file), ssize_t, pwrite, (int file, const void *data, size_t size, off_t at),
      (file, data, size, at))
WATCH(WRITE, is_watched_descriptor(file), ssize_t, pwrite64, (int file, const void *data, size_t size, off64_t at),
      (file, data, size, at))
WATCH(WRITE, is_watched_descriptor(file), ssize_t, writev, (int file, const struct iovec *parts, int count),
      (file, parts, count))
WATCH(WRITE, is_watched_descriptor(file), ssize_t, pwritev, (int file, const struct iovec *parts, int count, off_t at),
      (file, parts, count, at))
WATCH(WRITE, is_watched_descriptor(file), ssize_t, pwritev64, (int file, const struct iovec *parts, int count, off64_t at),
      (file, parts, count, at))

WATCH(FSYNC, is_watched_descriptor(file), int, fsync, (int file), (file))
WATCH(FSYNC, is_watched_descriptor(file), int, fdatasync, (int file), (file))
WATCH(FSYNC, is_watched_descriptor(file), int, sync_file_range, (int file, off64_t at, off64_t size, unsigned flags),
      (file, at, size, flags))
