#pragma once

// wasi-libc has no dup2; a page has no descriptors to duplicate.
#include_next <unistd.h>

inline int dup2(int, int) { return -1; }
