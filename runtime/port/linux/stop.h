/* Wishes to stop that come as signals. */
#ifndef TB_STOP_H
#define TB_STOP_H

#ifdef __cplusplus
extern "C" {
#endif

/** Listen to SIGINT, SIGTERM and SIGHUP; SIGPIPE does nothing. */
void tb_stop_listen(void);

/** How often a stop was asked for: 0 not at all, 1 a soft stop, 2 an end at once. */
int tb_stop_wished(void);

#ifdef __cplusplus
}
#endif

#endif
