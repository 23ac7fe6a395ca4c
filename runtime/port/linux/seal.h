/* The seal: a filter of the kernel (seccomp) that ends the program at any system call which the
 * control loop does not need. So there is no heap, no lock and no file in the cyclic path. */
#ifndef TB_SEAL_H
#define TB_SEAL_H

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Seal the program; there is no way back. False, with a message, where the kernel has no filter. */
bool tb_seal(void);

#ifdef __cplusplus
}
#endif

#endif
