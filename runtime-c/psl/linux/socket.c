// SPDX-License-Identifier: Apache-2.0
// Sockets: non-blocking sockets of the system.  All waiting happens in psl_wait_for_events.
#define _GNU_SOURCE
#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <string.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "runtime-c/pal/socket.h"
#include "runtime-c/psl/linux/linux.h"

typedef enum SocketKind { DATAGRAMS, LISTENING, CONNECTING, STREAM } SocketKind;

typedef struct SocketEntry {
    int fd;
    SocketKind kind;
} SocketEntry;

static bool used[PAL_SOCKETS];
static SocketEntry entries[PAL_SOCKETS];

// ---- addresses ----

static struct sockaddr_in to_sockaddr(const PalAddress *a)
{
    struct sockaddr_in s;

    memset(&s, 0, sizeof s);
    s.sin_family = AF_INET;
    s.sin_port = htons(a->port);
    memcpy(&s.sin_addr, a->ip, sizeof a->ip);              // both are in written order (network byte order)
    return s;
}

static PalAddress from_sockaddr(const struct sockaddr_in *s)
{
    PalAddress a;

    memcpy(a.ip, &s->sin_addr, sizeof a.ip);
    a.port = ntohs(s->sin_port);
    return a;
}

// ---- errors of the network ----

// Whether an error is about a peer, a route or an earlier packet, and not about the socket (accept(2), ip(7)).  The system reports
// such an error once, by whatever call comes next.
static bool is_network_error(int error)
{
    switch (error) {
    case ENETDOWN: case ENETUNREACH: case EHOSTDOWN: case EHOSTUNREACH: case ENONET: case EPROTO: case ENOPROTOOPT: case EOPNOTSUPP:
    case ETIMEDOUT: case ECONNABORTED: case ECONNRESET: case ECONNREFUSED: return true;
    default: return false;
    }
}

// Converts an errno of a connected stream to a result.  A peer that no longer answers ends the stream, too.
static SmResult stream_result(int error)
{
    return is_network_error(error) ? SM_E_CLOSED : psl_result_of_errno(error);
}

// Converts an errno of a connect to a result.  No route or no listening socket: SM_E_UNREACHABLE.  No answer (ETIMEDOUT): SM_E_TIMEOUT.
static SmResult connect_result(int error)
{
    return is_network_error(error) && error != ETIMEDOUT ? SM_E_UNREACHABLE : psl_result_of_errno(error);
}

// ---- the table ----

// Checks that the handle is open and of the given kind; *fd receives its descriptor.
static SmResult find_socket(PalSocket socket, SocketKind kind, int *fd)
{
    if (!psl_table_is_used(used, PAL_SOCKETS, socket.id))
        return SM_E_HANDLE;
    *fd = entries[socket.id - 1].fd;
    return entries[socket.id - 1].kind == kind ? SM_OK : SM_E_ARGUMENT;
}

// Returns the handle number of a free entry, which it takes; 0 if all are in use.
static uint8_t allocate_entry(void)
{
    uint8_t id;

    psl_lock_tables();
    id = psl_table_allocate(used, PAL_SOCKETS);
    if (id != 0)
        entries[id - 1].fd = -1;
    psl_unlock_tables();
    return id;
}

static void free_entry(uint8_t id)
{
    psl_lock_tables();
    used[id - 1] = false;
    psl_unlock_tables();
}

// If r is SM_OK, stores the descriptor in the entry.  Otherwise closes the descriptor and frees the entry.
static SmResult finish_open(PalSocket *s, uint8_t id, int fd, SocketKind kind, SmResult r)
{
    if (r == SM_OK) {
        entries[id - 1].fd = fd;
        entries[id - 1].kind = kind;
        s->id = id;
        return SM_OK;
    }
    if (fd >= 0)
        close(fd);
    free_entry(id);
    return r;
}

// ---- opening ----

// Returns the descriptor of a new socket, or -1 with errno set.
static int new_socket(int type)
{
    return socket(AF_INET, type | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
}

// Sets a socket option to 1.
static SmResult set_option(int fd, int level, int option)
{
    int on = 1;

    return setsockopt(fd, level, option, &on, sizeof on) == 0 ? SM_OK : psl_result_of_errno(errno);
}

static bool is_group(const uint8_t *ip) { return ip[0] >= 224 && ip[0] <= 239; }

static SmResult bind_to(int fd, const PalAddress *local)
{
    struct sockaddr_in a = to_sockaddr(local);

    return bind(fd, (struct sockaddr *)&a, sizeof a) == 0 ? SM_OK : psl_result_of_errno(errno);
}

// Opens a socket of this kind with one option set, bound to `local`.
static SmResult open_bound(PalSocket *s, const PalAddress *local, SocketKind kind, int option)
{
    uint8_t id;
    SmResult r;
    int fd;

    if (!s || !local)
        return SM_E_ARGUMENT;
    id = allocate_entry();
    if (id == 0)
        return SM_E_FULL;
    fd = new_socket(kind == DATAGRAMS ? SOCK_DGRAM : SOCK_STREAM);
    r = fd < 0 ? psl_result_of_errno(errno) : set_option(fd, SOL_SOCKET, option);
    if (r == SM_OK && kind == DATAGRAMS && is_group(local->ip))       // several programs of a computer may receive a group
        r = set_option(fd, SOL_SOCKET, SO_REUSEADDR);
    if (r == SM_OK)
        r = bind_to(fd, local);
    if (r == SM_OK && kind == LISTENING && listen(fd, PAL_SOCKETS) != 0)
        r = psl_result_of_errno(errno);
    return finish_open(s, id, fd, kind, r);
}

SmResult pal_socket_udp(PalSocket *s, const PalAddress *local) { return open_bound(s, local, DATAGRAMS, SO_BROADCAST); }

SmResult pal_socket_multicast(PalSocket s, const uint8_t *group, const uint8_t *interface)
{
    struct ip_mreq joined;
    SmResult r;
    int fd;

    if (!interface || (group && !is_group(group)))
        return SM_E_ARGUMENT;
    r = find_socket(s, DATAGRAMS, &fd);
    if (r != SM_OK)
        return r;
    memcpy(&joined.imr_interface, interface, 4);
    if (group)
        memcpy(&joined.imr_multiaddr, group, 4);
    if (setsockopt(fd, IPPROTO_IP, IP_MULTICAST_IF, &joined.imr_interface, sizeof joined.imr_interface) != 0 ||
        (group && setsockopt(fd, IPPROTO_IP, IP_ADD_MEMBERSHIP, &joined, sizeof joined) != 0))
        return psl_result_of_errno(errno);
    return SM_OK;
}

// With SO_REUSEADDR, the port of a program that has just ended is immediately available again.
SmResult pal_socket_listen(PalSocket *s, const PalAddress *local) { return open_bound(s, local, LISTENING, SO_REUSEADDR); }

// ---- paths ----

enum { LOCK_TRIES = 2000, LOCK_PAUSE = 1000 };   // LOCK_PAUSE: microseconds

// Whether a program listens at the path.  If its queue is full, connect fails with EAGAIN.
static bool is_listening_at(const struct sockaddr_un *a)
{
    const int fd = socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    const bool refused = fd >= 0 && connect(fd, (const struct sockaddr *)a, sizeof *a) != 0 && errno == ECONNREFUSED;

    if (fd >= 0)
        close(fd);
    return !refused;
}

// Removes a socket at which no program listens any more.  Any other file stays.
static SmResult remove_stale_socket(const struct sockaddr_un *a)
{
    struct stat s;

    if (lstat(a->sun_path, &s) != 0)
        return errno == ENOENT ? SM_OK : psl_result_of_errno(errno);
    if (!S_ISSOCK(s.st_mode))
        return SM_E_FOREIGN;
    if (is_listening_at(a))
        return SM_E_BUSY;
    return unlink(a->sun_path) == 0 || errno == ENOENT ? SM_OK : psl_result_of_errno(errno);
}

// Opens and locks the folder of a path, so that no other program replaces a socket in it.  Returns -1 and an errno if that is not possible.
// Other programs hold this lock for a few calls only, so it is free after a short wait.
static int lock_folder(const char *path)
{
    const int fd = psl_open_folder(path);
    int error = 0;

    for (int tries = 0; fd >= 0 && flock(fd, LOCK_EX | LOCK_NB) != 0; tries++) {
        error = errno == EWOULDBLOCK ? EBUSY : errno;
        if ((error != EBUSY && error != EINTR) || tries == LOCK_TRIES) {
            close(fd);
            errno = error;
            return -1;
        }
        (void)usleep(LOCK_PAUSE);
    }
    return fd;
}

// Binds a socket to a path and listens.  The mode is set before the path exists, so that no other user can ever connect: the file gets the mode of
// the unbound socket (unix(7)).
static SmResult bind_to_path(int fd, const struct sockaddr_un *a)
{
    SmResult r = remove_stale_socket(a);

    if (r != SM_OK)
        return r;
    if (fchmod(fd, S_IRUSR | S_IWUSR) != 0 || bind(fd, (const struct sockaddr *)a, sizeof *a) != 0)
        return psl_result_of_errno(errno);
    if (listen(fd, PAL_SOCKETS) == 0)
        return SM_OK;
    r = psl_result_of_errno(errno);
    unlink(a->sun_path);
    return r;
}

// Like bind_to_path, with the folder locked: of several programs that find a stale socket, the first to lock replaces it. The others then find that
// a program listens.
static SmResult listen_at_path(int fd, const struct sockaddr_un *a)
{
    const int folder = lock_folder(a->sun_path);
    SmResult r;

    if (folder < 0)
        return psl_result_of_errno(errno);
    r = bind_to_path(fd, a);
    close(folder);
    return r;
}

SmResult pal_socket_listen_local(PalSocket *s, const char *path)
{
    struct sockaddr_un a;
    uint8_t id;
    int fd;

    if (!s || !path || *path == '\0' || strlen(path) > PAL_SOCKET_PATH)
        return SM_E_ARGUMENT;
    id = allocate_entry();
    if (id == 0)
        return SM_E_FULL;
    memset(&a, 0, sizeof a);
    a.sun_family = AF_UNIX;
    memcpy(a.sun_path, path, strlen(path));
    fd = socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    return finish_open(s, id, fd, LISTENING, fd < 0 ? psl_result_of_errno(errno) : listen_at_path(fd, &a));
}

// Removes the file of a socket that listens at a path.
static void remove_path(int fd)
{
    struct sockaddr_un a;
    socklen_t n = sizeof a;

    memset(&a, 0, sizeof a);
    if (getsockname(fd, (struct sockaddr *)&a, &n) == 0 && a.sun_family == AF_UNIX && a.sun_path[0] != '\0')
        unlink(a.sun_path);
}

// ---- connections ----

// Waits until the pending connection is established.
static SmResult wait_until_connected(int fd, uint64_t deadline)
{
    SmResult r = psl_wait_for_events(fd, POLLOUT, deadline);
    int error = 0;
    socklen_t n = sizeof error;

    if (r != SM_OK)
        return r;
    return getsockopt(fd, SOL_SOCKET, SO_ERROR, &error, &n) == 0 ? connect_result(error) : psl_result_of_errno(errno);
}

static SmResult connect_to(int fd, const PalAddress *to, uint64_t deadline)
{
    struct sockaddr_in a = to_sockaddr(to);

    if (connect(fd, (struct sockaddr *)&a, sizeof a) == 0)
        return SM_OK;
    return errno == EINPROGRESS || errno == EINTR ? wait_until_connected(fd, deadline) : connect_result(errno);
}

// Allocates an entry and connects a new socket for it; finish_open completes the entry.  SM_E_FULL: all entries are in use.
static SmResult connect_new(const PalAddress *to, uint64_t deadline, uint8_t *id, int *fd)
{
    SmResult r;

    *id = allocate_entry();
    if (*id == 0)
        return SM_E_FULL;
    *fd = new_socket(SOCK_STREAM);
    r = *fd < 0 ? psl_result_of_errno(errno) : set_option(*fd, IPPROTO_TCP, TCP_NODELAY);
    return r == SM_OK ? connect_to(*fd, to, deadline) : r;
}

SmResult pal_socket_connect(PalSocket *stream, const PalAddress *to, uint64_t timeout)
{
    uint64_t deadline = pal_clock_now() + timeout;
    uint8_t id;
    SmResult r;
    int fd;

    if (!stream || !to || timeout > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    r = connect_new(to, deadline, &id, &fd);
    if (id == 0)
        return r;
    return finish_open(stream, id, fd, STREAM, r);
}

SmResult pal_socket_connect_start(PalSocket *stream, const PalAddress *to)
{
    uint8_t id;
    SmResult r;
    int fd;

    if (!stream || !to)
        return SM_E_ARGUMENT;
    r = connect_new(to, 0, &id, &fd);
    if (id == 0)
        return r;
    return r == SM_E_TIMEOUT ? finish_open(stream, id, fd, CONNECTING, SM_OK) : finish_open(stream, id, fd, STREAM, r);
}

// Checks whether a connection is established.  Only the connecting thread changes the kind of its entry, from CONNECTING to STREAM.
SmResult pal_socket_connected(PalSocket stream)
{
    int fd;
    SmResult r = find_socket(stream, STREAM, &fd);

    if (r != SM_E_ARGUMENT)
        return r;
    r = find_socket(stream, CONNECTING, &fd);
    if (r == SM_OK)
        r = wait_until_connected(fd, 0);
    if (r == SM_OK)
        entries[stream.id - 1].kind = STREAM;
    return r;
}

// Limits the unsent bytes and the time without acknowledgement.  Linux doubles `room`, for its own records, and raises it to a minimum.
SmResult pal_socket_limit(PalSocket stream, size_t room, uint64_t patience)
{
    const unsigned milliseconds = (unsigned)(patience / PAL_MILLISECOND);
    int fd, bytes = (int)room;
    SmResult r;

    if (room == 0 || room > 1u << 20 || milliseconds == 0 || patience > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    r = find_socket(stream, STREAM, &fd);
    if (r != SM_OK)
        return r;
    if (setsockopt(fd, SOL_SOCKET, SO_SNDBUF, &bytes, sizeof bytes) != 0 ||
        setsockopt(fd, IPPROTO_TCP, TCP_USER_TIMEOUT, &milliseconds, sizeof milliseconds) != 0)
        return psl_result_of_errno(errno);
    return SM_OK;
}

// Accepts a connection.  Ignores a peer whose connection broke before it was accepted, and waits for the next one.  A stream from a path has no
// TCP_NODELAY. A deadline of 0 saves the system call that would wait.
static SmResult accept_one(int listening, int *fd, struct sockaddr_in *a, uint64_t deadline)
{
    for (;;) {
        socklen_t n = sizeof *a;

        *fd = accept4(listening, (struct sockaddr *)a, &n, SOCK_NONBLOCK | SOCK_CLOEXEC);
        if (*fd >= 0)
            return a->sin_family == AF_INET ? set_option(*fd, IPPROTO_TCP, TCP_NODELAY) : SM_OK;
        if (errno == EAGAIN && deadline == 0)
            return SM_E_TIMEOUT;
        if (errno == EAGAIN || is_network_error(errno)) {
            SmResult r = psl_wait_for_events(listening, POLLIN, deadline);

            if (r != SM_OK)
                return r;
        } else if (errno != EINTR)
            return psl_result_of_errno(errno);
    }
}

SmResult pal_socket_accept(PalSocket listening, PalSocket *stream, PalAddress *peer, uint64_t timeout)
{
    const uint64_t deadline = timeout ? pal_clock_now() + timeout : 0;
    struct sockaddr_in a;
    int fd, from;
    SmResult r;
    uint8_t id;

    if (!stream || timeout > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    r = find_socket(listening, LISTENING, &from);
    if (r != SM_OK)
        return r;
    id = allocate_entry();
    if (id == 0)
        return SM_E_FULL;
    memset(&a, 0, sizeof a);
    r = accept_one(from, &fd, &a, deadline);
    r = finish_open(stream, id, fd, STREAM, r);
    if (r == SM_OK && peer)
        *peer = a.sin_family == AF_INET ? from_sockaddr(&a) : (PalAddress){{0, 0, 0, 0}, 0};
    return r;
}

// ---- datagrams ----

SmResult pal_socket_send_to(PalSocket s, const PalAddress *to, const void *bytes, size_t n)
{
    struct sockaddr_in a;
    SmResult r;
    int fd;

    if (!to || !bytes || n > PAL_DATAGRAM_MAX)
        return SM_E_ARGUMENT;
    r = find_socket(s, DATAGRAMS, &fd);
    if (r != SM_OK)
        return r;
    a = to_sockaddr(to);
    while (sendto(fd, bytes, n, MSG_NOSIGNAL, (struct sockaddr *)&a, sizeof a) < 0)
        if (errno != EINTR)
            return errno == EAGAIN || errno == ENOBUFS ? SM_E_BUSY : psl_result_of_errno(errno);
    return SM_OK;
}

// Waits until the socket is ready and receives.  On failure returns -1 and sets *r.  A network error ends a stream.  For
// datagrams it is ignored, because it concerns an earlier one.  A deadline of 0 saves the system call that would wait.
static ssize_t receive_message(int fd, SocketKind kind, struct msghdr *m, uint64_t deadline, SmResult *r)
{
    for (;;) {
        ssize_t got = recvmsg(fd, m, 0);

        if (got >= 0)
            return got;
        if (errno == EAGAIN && deadline == 0)
            *r = SM_E_TIMEOUT;
        else if (errno == EAGAIN || (kind == DATAGRAMS && is_network_error(errno)))
            *r = psl_wait_for_events(fd, POLLIN, deadline);
        else if (errno != EINTR)
            *r = stream_result(errno);
        if (*r != SM_OK)
            return -1;
    }
}

SmResult pal_socket_receive_from(PalSocket s, PalAddress *from, void *bytes, size_t room, size_t *n, uint64_t timeout)
{
    const uint64_t deadline = timeout ? pal_clock_now() + timeout : 0;
    struct sockaddr_in a;
    struct iovec part = {bytes, room};
    struct msghdr m;
    SmResult r;
    ssize_t got;
    int fd;

    if (!bytes || !n || timeout > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    r = find_socket(s, DATAGRAMS, &fd);
    if (r != SM_OK)
        return r;
    memset(&a, 0, sizeof a);
    memset(&m, 0, sizeof m);
    m.msg_name = &a;
    m.msg_namelen = sizeof a;
    m.msg_iov = &part;
    m.msg_iovlen = 1;
    got = receive_message(fd, DATAGRAMS, &m, deadline, &r);
    if (got < 0)
        return r;
    *n = (size_t)got;
    if (from)
        *from = from_sockaddr(&a);
    return m.msg_flags & MSG_TRUNC ? SM_E_SIZE : SM_OK;
}

// ---- streams ----

SmResult pal_socket_send(PalSocket stream, const void *bytes, size_t n, size_t *sent, uint64_t timeout)
{
    uint64_t deadline = pal_clock_now() + timeout;
    const uint8_t *next = bytes;
    SmResult r;
    int fd;

    if (sent)
        *sent = 0;
    if (!bytes || !sent || timeout > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    r = find_socket(stream, STREAM, &fd);
    while (r == SM_OK && *sent < n) {
        ssize_t taken = send(fd, next + *sent, n - *sent, MSG_NOSIGNAL);

        if (taken > 0)
            *sent += (size_t)taken;
        else if (errno == EAGAIN)
            r = psl_wait_for_events(fd, POLLOUT, deadline);
        else if (errno != EINTR)
            r = stream_result(errno);
    }
    return r;
}

SmResult pal_socket_receive(PalSocket stream, void *bytes, size_t room, size_t *n, uint64_t timeout)
{
    const uint64_t deadline = timeout ? pal_clock_now() + timeout : 0;
    struct iovec part = {bytes, room};
    struct msghdr m;
    SmResult r;
    ssize_t got;
    int fd;

    if (!bytes || !n || room == 0 || timeout > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    r = find_socket(stream, STREAM, &fd);
    if (r != SM_OK)
        return r;
    memset(&m, 0, sizeof m);
    m.msg_iov = &part;
    m.msg_iovlen = 1;
    got = receive_message(fd, STREAM, &m, deadline, &r);
    if (got == 0)
        return SM_E_CLOSED;
    if (got > 0)
        *n = (size_t)got;
    return r;
}

// ---- all ----

SmResult pal_socket_local_address(PalSocket s, PalAddress *local)
{
    struct sockaddr_in a;
    socklen_t n = sizeof a;

    if (!local)
        return SM_E_ARGUMENT;
    if (!psl_table_is_used(used, PAL_SOCKETS, s.id))
        return SM_E_HANDLE;
    if (getsockname(entries[s.id - 1].fd, (struct sockaddr *)&a, &n) != 0)
        return psl_result_of_errno(errno);
    if (a.sin_family != AF_INET)
        return SM_E_UNSUPPORTED;
    *local = from_sockaddr(&a);
    return SM_OK;
}

SmResult pal_socket_close(PalSocket s)
{
    SmResult r = SM_E_HANDLE;

    psl_lock_tables();
    if (psl_table_is_used(used, PAL_SOCKETS, s.id)) {
        if (entries[s.id - 1].kind == LISTENING)
            remove_path(entries[s.id - 1].fd);
        close(entries[s.id - 1].fd);
        used[s.id - 1] = false;
        r = SM_OK;
    }
    psl_unlock_tables();
    return r;
}
