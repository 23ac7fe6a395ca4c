/* Sockets between programs of one computer. */
#ifndef TB_UNIX_SOCKET_H
#define TB_UNIX_SOCKET_H

#ifdef __cplusplus
extern "C" {
#endif

/** A socket of a type (SOCK_..., with flags) that is connected to a path, or to a name that is no
 *  file and begins with "@"; -1 with errno where it cannot be. */
int tb_unix_connect(int type, const char *path);

#ifdef __cplusplus
}
#endif

#endif
