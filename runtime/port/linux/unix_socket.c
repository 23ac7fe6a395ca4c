#define _GNU_SOURCE /* SOCK_CLOEXEC */
#include "unix_socket.h"

#include <errno.h>
#include <stddef.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

static int connect_to(int descriptor, const char *path)
{
    struct sockaddr_un address = {.sun_family = AF_UNIX};
    size_t const length = strlen(path);
    if ((length == 0) || (length >= sizeof address.sun_path)) {
        errno = EINVAL;
        return -1;
    }
    memcpy(address.sun_path, path, length);
    if (path[0] == '@') {
        address.sun_path[0] = '\0'; /* a name that is no file begins with 0 */
    }
    socklen_t const bytes = (socklen_t)(offsetof(struct sockaddr_un, sun_path) + length);
    return connect(descriptor, (const struct sockaddr *)&address, bytes);
}

int tb_unix_connect(int type, const char *path)
{
    int const descriptor = socket(AF_UNIX, type | SOCK_CLOEXEC, 0);
    if ((descriptor >= 0) && (connect_to(descriptor, path) != 0)) {
        int const reason = errno;
        close(descriptor);
        errno = reason;
        return -1;
    }
    return descriptor;
}
