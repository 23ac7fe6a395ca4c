#include "seal.h"

#include <errno.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <stddef.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include "say.h"

#if defined(__x86_64__)
#define ARCHITECTURE AUDIT_ARCH_X86_64
#elif defined(__aarch64__)
#define ARCHITECTURE AUDIT_ARCH_AARCH64
#elif defined(__arm__) && defined(__ARM_EABI__) && !defined(__ARMEB__)
#define ARCHITECTURE AUDIT_ARCH_ARM
#elif defined(__riscv) && (__riscv_xlen == 64)
#define ARCHITECTURE AUDIT_ARCH_RISCV64
#else
#error "the seal does not know this processor"
#endif

#define FIELD(name) BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, name))
#define KILL BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS)
#define ALLOW BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)
#define IF_EQUAL_NEXT_ELSE_SKIP(value) BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, (value), 0, 1)
#define ALLOW_CALL(name) IF_EQUAL_NEXT_ELSE_SKIP(SYS_##name), ALLOW

static struct sock_filter const filter[] = {
    FIELD(arch),
    BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, ARCHITECTURE, 1, 0),
    KILL,
    FIELD(nr),
    ALLOW_CALL(clock_nanosleep),
    ALLOW_CALL(clock_gettime),
    /* frames, signs of life; at the end the report, and what the writer of the record answers */
    ALLOW_CALL(read),
    ALLOW_CALL(write),
    ALLOW_CALL(recvfrom),
    ALLOW_CALL(recvmsg),
    ALLOW_CALL(recvmmsg),
    ALLOW_CALL(sendto),
    ALLOW_CALL(sendmsg),
    ALLOW_CALL(sendmmsg),
    /* a signal came */
    ALLOW_CALL(rt_sigreturn),
    ALLOW_CALL(restart_syscall),
    /* the end: adapters are closed, serial lines set back */
    ALLOW_CALL(close),
    ALLOW_CALL(ioctl),
    ALLOW_CALL(fcntl),
#ifdef __arm__
    /* the same calls as the C library makes them on 32 bits, with and without 64 bits of time */
    ALLOW_CALL(clock_nanosleep_time64),
    ALLOW_CALL(clock_gettime64),
    ALLOW_CALL(recvmmsg_time64),
    ALLOW_CALL(recv),
    ALLOW_CALL(send),
    ALLOW_CALL(sigreturn),
    ALLOW_CALL(fcntl64),
#endif
    ALLOW_CALL(exit),
    ALLOW_CALL(exit_group),
    KILL,
};

bool tb_seal(void)
{
    struct sock_fprog program = {.len = sizeof filter / sizeof filter[0]};
    program.filter = (struct sock_filter *)filter; /* read by the kernel, never written */
    if ((prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) ||
        (prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0)) {
        tb_say("--seal: this kernel does not filter system calls: %s", strerror(errno));
        return false;
    }
    return true;
}
