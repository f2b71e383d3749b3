/* The machine that this is, for a record's fingerprint. */
#ifndef AOB_BASE_MACHINE_H
#define AOB_BASE_MACHINE_H
#include <stddef.h>

void aob_machine_processor(char *name, size_t size); /* "AMD EPYC ..." or "unknown" */
/* Bytes that this process may use at most: what the machine has, its container may take, or `ulimit -m` or `-v`
 * leaves. */
size_t aob_machine_memory(void);

int aob_machine_cores(void); /* those that this process may use */
#endif
