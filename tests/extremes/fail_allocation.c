/* Loaded before the C library (LD_PRELOAD): allocation number FAIL_ALLOCATION fails, counted from 0 where main begins, or
   with EXHAUST_MEMORY from then on all but what has been given back since. At the end the file COUNT_ALLOCATIONS is
   given their number. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <malloc.h>
#include <stdio.h>
#include <stdlib.h>

extern void* __libc_malloc(size_t);
extern void* __libc_calloc(size_t, size_t);
extern void* __libc_realloc(void*, size_t);
extern void* __libc_memalign(size_t, size_t);
extern void __libc_free(void*);

static long allocations = -1; /* below 0: none is counted */
static long failing = -1;
static int exhausts = 0;
static long given_back = 0; /* bytes, once memory is exhausted */

static int fails(size_t size) {
  if (__atomic_load_n(&allocations, __ATOMIC_RELAXED) < 0) return 0;
  const long number = __atomic_fetch_add(&allocations, 1, __ATOMIC_RELAXED);
  if (failing < 0 || number < failing || (number > failing && !exhausts)) return 0;
  if (__atomic_fetch_sub(&given_back, (long)size, __ATOMIC_RELAXED) >= (long)size) return 0;
  __atomic_fetch_add(&given_back, (long)size, __ATOMIC_RELAXED);
  errno = ENOMEM;
  return 1;
}

void* malloc(size_t size) { return fails(size) ? NULL : __libc_malloc(size); }
void* calloc(size_t count, size_t size) { return fails(count * size) ? NULL : __libc_calloc(count, size); }
void* realloc(void* old, size_t size) { return fails(size) ? NULL : __libc_realloc(old, size); }
void* memalign(size_t alignment, size_t size) { return fails(size) ? NULL : __libc_memalign(alignment, size); }
void* aligned_alloc(size_t alignment, size_t size) { return memalign(alignment, size); }
int posix_memalign(void** memory, size_t alignment, size_t size) {
  *memory = memalign(alignment, size);
  return *memory ? 0 : ENOMEM;
}
void free(void* memory) {
  if (memory && failing >= 0 && __atomic_load_n(&allocations, __ATOMIC_RELAXED) > failing)
    __atomic_fetch_add(&given_back, (long)malloc_usable_size(memory), __ATOMIC_RELAXED);
  __libc_free(memory);
}

typedef int Main(int, char**, char**);
typedef int StartMain(Main*, int, char**, void (*)(void), void (*)(void), void (*)(void), void*);

static Main* program;

/* At its first allocation oneTBB loads a library, and glibc's dlopen crashes where memory ends (2.36: _dlerror_run uses
   what it could not allocate); neither is ours to mend. */
static void load_tbb_allocator(void) {
  void* (*allocate)(size_t) = (void* (*)(size_t))dlsym(RTLD_DEFAULT, "_ZN3tbb6detail2r115allocate_memoryEm");
  if (allocate) allocate(1);
}

static int counted_main(int argc, char** argv, char** environment) {
  const char* number = getenv("FAIL_ALLOCATION");
  if (number) failing = atol(number);
  exhausts = getenv("EXHAUST_MEMORY") != NULL;
  load_tbb_allocator();
  allocations = 0;
  return program(argc, argv, environment);
}

/* Where the C library begins main, once all that is static has been made. */
int __libc_start_main(Main* main, int argc, char** argv, void (*init)(void), void (*fini)(void), void (*end)(void),
                      void* stack) {
  program = main;
  StartMain* start = (StartMain*)dlsym(RTLD_NEXT, "__libc_start_main");
  return start(counted_main, argc, argv, init, fini, end, stack);
}

__attribute__((destructor)) static void end(void) {
  const long counted = allocations;
  const char* name = getenv("COUNT_ALLOCATIONS");
  allocations = -1;
  FILE* file = name ? fopen(name, "w") : NULL;
  if (!file) return;
  fprintf(file, "%ld\n", counted);
  fclose(file);
}
