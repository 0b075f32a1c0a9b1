// SPDX-License-Identifier: Apache-2.0
// os_serial.h on POSIX systems.
#define _DEFAULT_SOURCE
#define _DARWIN_C_SOURCE
#define _XOPEN_SOURCE 700

#include "compiler/base/os_serial.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

static const struct { unsigned long bits_per_second; speed_t speed; } speeds[] = {
    {1200, B1200}, {2400, B2400}, {4800, B4800}, {9600, B9600}, {19200, B19200}, {38400, B38400},
#ifdef B57600
    {57600, B57600}, {115200, B115200},
#endif
#ifdef B230400
    {230400, B230400},
#endif
#ifdef B460800
    {460800, B460800}, {921600, B921600},
#endif
#ifdef B1000000
    {500000, B500000}, {1000000, B1000000}, {2000000, B2000000},
#endif
};

// Finds the constant of termios for a speed. Returns false for a speed that is not supported.
static bool find_speed(unsigned long bits_per_second, speed_t *speed)
{
    for (size_t i = 0; i < sizeof speeds / sizeof *speeds; i++)
        if (speeds[i].bits_per_second == bits_per_second) {
            *speed = speeds[i].speed;
            return true;
        }
    return false;
}

// Sets the line to bytes without any translation, flow control or echo. Returns false, with errno set, if the device refuses.
static bool set_raw_mode(int fd, speed_t speed)
{
    struct termios t;

    if (tcgetattr(fd, &t) != 0)
        return false;
    t.c_iflag &= ~(tcflag_t)(IGNBRK | BRKINT | PARMRK | ISTRIP | INLCR | IGNCR | ICRNL | IXON | IXOFF);
    t.c_oflag &= ~(tcflag_t)OPOST;
    t.c_lflag &= ~(tcflag_t)(ECHO | ECHONL | ICANON | ISIG | IEXTEN);
    t.c_cflag &= ~(tcflag_t)(CSIZE | PARENB | CSTOPB);
    t.c_cflag |= CS8 | CLOCAL | CREAD;
    t.c_cflag &= ~(tcflag_t)HUPCL;         // DTR stays on at the close, so the next open does not restart an Arduino
    t.c_cc[VMIN] = 1;
    t.c_cc[VTIME] = 0;
    if (cfsetispeed(&t, speed) != 0 || cfsetospeed(&t, speed) != 0 || tcsetattr(fd, TCSANOW, &t) != 0)
        return false;
    tcflush(fd, TCIFLUSH);
#ifdef TIOCEXCL
    ioctl(fd, TIOCEXCL);                   // no other process can use the port meanwhile
#endif
    return true;
}

bool os_serial_open(const char *path, unsigned long bits_per_second, int *fd, const char **why)
{
    speed_t speed;

    if (!find_speed(bits_per_second, &speed)) {
        *why = "there is no such speed (115200 is the firmware's)";
        return false;
    }
    if ((*fd = open(path, O_RDWR | O_NOCTTY | O_NONBLOCK)) < 0) {
        *why = errno == EBUSY ? "another program uses it" : strerror(errno);
        return false;
    }
    if (flock(*fd, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        *why = "another program uses it";
    else if (isatty(*fd) && set_raw_mode(*fd, speed))
        return true;
    else
        *why = isatty(*fd) ? strerror(errno) : "it is no serial line";
    close(*fd);
    return false;
}

// Waits until the connection is established.
static bool finish_connect(int fd, const char **why)
{
    struct pollfd p = {fd, POLLOUT, 0};
    int error = 0;
    socklen_t n = sizeof error;

    if (errno == EINPROGRESS && poll(&p, 1, 5000) == 0) {
        *why = "no answer";
        return false;
    }
    if (errno == EINPROGRESS)
        (void)getsockopt(fd, SOL_SOCKET, SO_ERROR, &error, &n);
    else
        error = errno;
    *why = error != 0 ? strerror(error) : NULL;
    return error == 0;
}

// Connects a new socket to the address.
static bool connect_socket(int family, const struct sockaddr *to, socklen_t n, int *fd, const char **why)
{
    const int on = 1;

    if ((*fd = socket(family, SOCK_STREAM, 0)) < 0) {
        *why = strerror(errno);
        return false;
    }
    fcntl(*fd, F_SETFD, FD_CLOEXEC);
    fcntl(*fd, F_SETFL, O_NONBLOCK);
    if (family != AF_UNIX)
        setsockopt(*fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    if (connect(*fd, to, n) == 0 || finish_connect(*fd, why))
        return true;
    close(*fd);
    return false;
}

bool os_socket_open(const char *path, int *fd, const char **why)
{
    struct sockaddr_un a;

    memset(&a, 0, sizeof a);
    a.sun_family = AF_UNIX;
    if (strlen(path) >= sizeof a.sun_path) {
        *why = "the path is too long";
        return false;
    }
    memcpy(a.sun_path, path, strlen(path));
    return connect_socket(AF_UNIX, (const struct sockaddr *)&a, sizeof a, fd, why);
}

bool os_tcp_open(const char *address, int *fd, const char **why)
{
    const char *port = strrchr(address, ':');
    struct addrinfo hints, *all = NULL;
    char host[256];
    int error;
    bool open = false;

    *why = "it is no HOST:PORT with a port from 1 to 65535";
    if (!port || strspn(port + 1, "0123456789") != strlen(port + 1) || strtoul(port + 1, NULL, 10) - 1 > 65534 ||
        (size_t)(port - address) >= sizeof host)
        return false;
    memcpy(host, address, (size_t)(port - address));
    host[port - address] = '\0';
    memset(&hints, 0, sizeof hints);
    hints.ai_family = AF_INET;
    hints.ai_socktype = SOCK_STREAM;
    if ((error = getaddrinfo(host[0] ? host : "127.0.0.1", port + 1, &hints, &all)) != 0) {
        *why = gai_strerror(error);
        return false;
    }
    for (const struct addrinfo *a = all; a && !open; a = a->ai_next)
        open = connect_socket(a->ai_family, a->ai_addr, a->ai_addrlen, fd, why);
    freeaddrinfo(all);
    return open;
}

// Opens a connection to a board or an application: HOST:PORT by TCP, a socket in the file system, or else a serial port.
bool os_line_open(const char *where, unsigned long bits_per_second, int *fd, const char **why)
{
    struct stat s;

    if (stat(where, &s) != 0)
        return strchr(where, ':') && !strchr(where, '/') ? os_tcp_open(where, fd, why) : os_serial_open(where, bits_per_second, fd, why);
    return S_ISSOCK(s.st_mode) ? os_socket_open(where, fd, why) : os_serial_open(where, bits_per_second, fd, why);
}

// Like write.  A socket whose other end is closed raises no signal.
static ssize_t put_bytes(int fd, const uint8_t *bytes, size_t n)
{
    const ssize_t put = send(fd, bytes, n, MSG_NOSIGNAL);

    return put < 0 && errno == ENOTSOCK ? write(fd, bytes, n) : put;
}

// Sends all n bytes.  Returns false if the line accepted no byte for 5 s, or the device is disconnected.
bool os_serial_send(int fd, const uint8_t *bytes, size_t n)
{
    while (n > 0) {
        const ssize_t put = put_bytes(fd, bytes, n);
        struct pollfd p = {fd, POLLOUT, 0};
        if (put > 0) {
            bytes += put;
            n -= (size_t)put;
        } else if (put == 0 || (errno != EAGAIN && errno != EINTR) || (errno == EAGAIN && poll(&p, 1, 5000) == 0)) {
            return false;
        }
    }
    return true;
}

// Waits up to `wait` milliseconds.  Returns the number of bytes received, 0 if none, -1 if the device is disconnected.
int os_serial_receive(int fd, uint8_t *bytes, size_t room, uint32_t wait)
{
    struct pollfd p = {fd, POLLIN, 0};
    const int ready = poll(&p, 1, wait > 60000 ? 60000 : (int)wait);
    ssize_t got;

    if (ready <= 0)
        return ready == 0 || errno == EINTR ? 0 : -1;
    got = read(fd, bytes, room);
    return got > 0 ? (int)got : got < 0 && (errno == EAGAIN || errno == EINTR) ? 0 : -1;
}

void os_serial_close(int fd) { close(fd); }

// Returns the milliseconds since an arbitrary time, modulo 2^32.
uint32_t os_milliseconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (uint32_t)((uint64_t)t.tv_sec * 1000 + (uint64_t)t.tv_nsec / 1000000);
}

// Returns a number that is unlikely to be the same in the next run of the command.
uint16_t os_run_nonce(void)
{
    struct timespec t;

    clock_gettime(CLOCK_REALTIME, &t);
    return (uint16_t)((uint64_t)t.tv_sec * 7919 + (uint64_t)t.tv_nsec / 1000 + (uint64_t)getpid() * 31);
}
