/* guard.h - arrays of exact length between guards, kept on a stack. */
#ifndef GUARD_H
#define GUARD_H

#include "../../../tess.h"
#include <stddef.h>

/* The number of arrays there are. */
extern int narrays;

/* A new array, of so many bytes or tess_ints, filled with 0x5a. */
void *array(size_t length);
tess_int *ints(tess_int n);
/* The length of the k-th array. */
size_t length_of(int k);
/* Free the arrays made since there were keep of them. */
void release(int keep);
/* The number of arrays whose guards were overwritten. */
int overrun(void);
/* L of the least lengths, as tess.h defines it. */
tess_int leaves(tess_int n);
/* Is the array what it was when it was made? */
int untouched(const void *a, size_t length);

#endif
