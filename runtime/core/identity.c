#include "identity.h"

#include "runtime_version.h"
#include "tb_machine.h"

#ifdef TB_REAL_FLOAT
#define PRECISION "float"
#else
#define PRECISION "double"
#endif

#if defined(__x86_64__)
#define PROCESSOR "x86-64"
#elif defined(__aarch64__)
#define PROCESSOR "AArch64"
#elif defined(__ARM_ARCH_PROFILE) && (__ARM_ARCH_PROFILE == 'A') && (__ARM_ARCH == 7)
#define PROCESSOR "ARMv7"
#elif defined(__ARM_ARCH_PROFILE) && (__ARM_ARCH_PROFILE == 'M')
#define PROCESSOR "Cortex-M"
#elif defined(__riscv) && (__riscv_xlen == 64)
#define PROCESSOR "RISC-V 64"
#else
#define PROCESSOR "another processor"
#endif

const char tb_identity[] = TB_IDENTITY_MARK TB_MACHINE_NAME
    " " TB_MACHINE_HASH ", " PRECISION ", Turnbuckle " TB_RUNTIME_VERSION_TEXT ", " PROCESSOR;
