/* Wishes to stop that come as signals. */
#ifndef TB_STOP_H
#define TB_STOP_H

/** Listen to SIGINT, SIGTERM and SIGHUP; SIGPIPE does nothing. */
void tb_stop_listen(void);

/** How often a stop was asked for, up to 3: once is softly, twice is hard, more is at once. */
int tb_stop_wished(void);

#endif
