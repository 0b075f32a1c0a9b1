// SPDX-License-Identifier: Apache-2.0
// Platform without a network.
#include "runtime-c/pal/socket.h"

SmResult pal_socket_udp(PalSocket *socket, const PalAddress *local)
{
    (void)socket, (void)local;
    return SM_E_UNSUPPORTED;
}

SmResult pal_socket_multicast(PalSocket socket, const uint8_t *group, const uint8_t *interface)
{
    (void)socket, (void)group, (void)interface;
    return SM_E_UNSUPPORTED;
}

SmResult pal_socket_send_to(PalSocket socket, const PalAddress *to, const void *bytes, size_t n)
{
    (void)socket, (void)to, (void)bytes, (void)n;
    return SM_E_UNSUPPORTED;
}

SmResult pal_socket_receive_from(PalSocket socket, PalAddress *from, void *bytes, size_t room, size_t *n, uint64_t timeout)
{
    (void)socket, (void)from, (void)bytes, (void)room, (void)n, (void)timeout;
    return SM_E_UNSUPPORTED;
}

SmResult pal_socket_listen(PalSocket *socket, const PalAddress *local)
{
    (void)socket, (void)local;
    return SM_E_UNSUPPORTED;
}

SmResult pal_socket_listen_local(PalSocket *socket, const char *path)
{
    (void)socket, (void)path;
    return SM_E_UNSUPPORTED;
}

SmResult pal_socket_accept(PalSocket listening, PalSocket *stream, PalAddress *peer, uint64_t timeout)
{
    (void)listening, (void)stream, (void)peer, (void)timeout;
    return SM_E_UNSUPPORTED;
}

SmResult pal_socket_connect(PalSocket *stream, const PalAddress *to, uint64_t timeout)
{
    (void)stream, (void)to, (void)timeout;
    return SM_E_UNSUPPORTED;
}

SmResult pal_socket_connect_start(PalSocket *stream, const PalAddress *to)
{
    (void)stream, (void)to;
    return SM_E_UNSUPPORTED;
}

SmResult pal_socket_connected(PalSocket stream)
{
    (void)stream;
    return SM_E_UNSUPPORTED;
}

SmResult pal_socket_limit(PalSocket stream, size_t room, uint64_t patience)
{
    (void)stream, (void)room, (void)patience;
    return SM_E_UNSUPPORTED;
}

SmResult pal_socket_send(PalSocket stream, const void *bytes, size_t n, size_t *sent, uint64_t timeout)
{
    (void)stream, (void)bytes, (void)n, (void)timeout;
    if (sent)
        *sent = 0;
    return SM_E_UNSUPPORTED;
}

SmResult pal_socket_receive(PalSocket stream, void *bytes, size_t room, size_t *n, uint64_t timeout)
{
    (void)stream, (void)bytes, (void)room, (void)n, (void)timeout;
    return SM_E_UNSUPPORTED;
}

SmResult pal_socket_local_address(PalSocket socket, PalAddress *local)
{
    (void)socket, (void)local;
    return SM_E_UNSUPPORTED;
}

SmResult pal_socket_close(PalSocket socket)
{
    (void)socket;
    return SM_E_UNSUPPORTED;
}
