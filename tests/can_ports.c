/* What Python needs of the CAN ports and cannot see: sizes, and functions that are inline. */
#include <stddef.h>

#include "loopback.h"
#include "slcan.h"
#include "socketcan.h"

size_t size_of_loopback(void)
{
    return sizeof(tb_loopback);
}
size_t size_of_slcan(void)
{
    return sizeof(tb_slcan);
}
size_t size_of_socketcan(void)
{
    return sizeof(tb_socketcan);
}
size_t size_of_reader(void)
{
    return sizeof(tb_slcan_reader);
}

tb_can_result port_send(tb_can_port *port, const tb_can_frame *frame)
{
    return tb_can_send(port, frame);
}
tb_can_result port_receive(tb_can_port *port, tb_can_frame *frame)
{
    return tb_can_receive(port, frame);
}
tb_can_state port_state(tb_can_port *port)
{
    return tb_can_port_state(port);
}
void port_close(tb_can_port *port)
{
    tb_can_close(port);
}
void count(uint32_t *counter, uint32_t more)
{
    tb_can_count(counter, more);
}
bool slcan_answers(const tb_slcan *slcan)
{
    return slcan->answers;
}
