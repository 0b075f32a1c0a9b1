// SPDX-License-Identifier: Apache-2.0
// os_serial.h on Windows.
#include "compiler/base/os_serial.h"
#include "compiler/base/os.h"
#include "compiler/base/os_windows.h"

#include <winsock2.h>
#include <ws2tcpip.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SEND_TIMEOUT_MS = 5000, WAIT_MOST_MS = 60000 };

// Returns the path of a port for Windows, on the heap.  Of COM1, COM2 … only those up to COM9 are names without the prefix.
static wchar_t *port_path(const char *path)
{
    char prefixed[64];

    if (_strnicmp(path, "COM", 3) != 0 || strspn(path + 3, "0123456789") != strlen(path + 3) || strlen(path) > 20)
        return windows_path(path);
    snprintf(prefixed, sizeof prefixed, "\\\\.\\%s", path);
    return windows_wide(prefixed);
}

// Sets the port to bytes without any translation or flow control. Returns false if it is no serial line, or refuses.
static bool set_raw_mode(HANDLE port, unsigned long bits_per_second, const char **why)
{
    DCB dcb;

    memset(&dcb, 0, sizeof dcb);
    dcb.DCBlength = sizeof dcb;
    *why = "it is no serial line";
    if (!GetCommState(port, &dcb))
        return false;
    dcb.BaudRate = bits_per_second;
    dcb.ByteSize = 8;
    dcb.Parity = NOPARITY;
    dcb.StopBits = ONESTOPBIT;
    dcb.fBinary = TRUE;
    dcb.fParity = dcb.fOutxCtsFlow = dcb.fOutxDsrFlow = dcb.fDsrSensitivity = dcb.fOutX = dcb.fInX = dcb.fErrorChar = dcb.fNull = dcb.fAbortOnError = 0;
    dcb.fDtrControl = DTR_CONTROL_ENABLE;
    dcb.fRtsControl = RTS_CONTROL_ENABLE;
    *why = "the port does not offer this speed (115200 is the firmware's)";
    return SetCommState(port, &dcb) && PurgeComm(port, PURGE_RXCLEAR | PURGE_RXABORT);
}

bool os_serial_open(const char *path, unsigned long bits_per_second, int *fd, const char **why)
{
    wchar_t *wide = port_path(path);
    const HANDLE port = wide ? CreateFileW(wide, GENERIC_READ | GENERIC_WRITE, 0, NULL, OPEN_EXISTING, 0, NULL) : INVALID_HANDLE_VALUE;
    const DWORD error = wide ? GetLastError() : ERROR_NOT_ENOUGH_MEMORY;

    free(wide);
    *fd = windows_number(port);
    if (port == INVALID_HANDLE_VALUE) {
        *why = error == ERROR_ACCESS_DENIED && !os_is_folder(path) ? "another program uses it" : windows_reason(error);
        return false;
    }
    if (set_raw_mode(port, bits_per_second, why))
        return true;
    CloseHandle(port);
    return false;
}

// ---- TCP ----

// Starts Winsock, which a process must do before its first socket; a further start is harmless.
static bool start_winsock(const char **why)
{
    WSADATA data;

    *why = "this system has no network";
    return WSAStartup(MAKEWORD(2, 2), &data) == 0;
}

// Waits at most 5 s until one event of the socket is there.  Returns false if it is not, or the socket is closed or failed.
static bool wait_for_socket(SOCKET socket, short events, int wait)
{
    WSAPOLLFD p = {socket, events, 0};

    return WSAPoll(&p, 1, wait) == 1 && (p.revents & (POLLERR | POLLNVAL)) == 0;
}

// Connects to one address.  The socket never blocks.
static bool connect_socket(const struct addrinfo *to, int *fd)
{
    const SOCKET s = socket(to->ai_family, SOCK_STREAM, 0);
    u_long on = 1;
    const BOOL no_delay = TRUE;

    if (s == INVALID_SOCKET)
        return false;
    ioctlsocket(s, (long)FIONBIO, &on);
    setsockopt(s, IPPROTO_TCP, TCP_NODELAY, (const char *)&no_delay, sizeof no_delay);
    if (connect(s, to->ai_addr, (int)to->ai_addrlen) == 0 || (WSAGetLastError() == WSAEWOULDBLOCK && wait_for_socket(s, POLLOUT, SEND_TIMEOUT_MS))) {
        *fd = windows_number((HANDLE)s);
        return true;
    }
    closesocket(s);
    return false;
}

bool os_tcp_open(const char *address, int *fd, const char **why)
{
    const char *port = strrchr(address, ':');
    struct addrinfo hints, *all = NULL;
    char host[256];
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
    if (!start_winsock(why))
        return false;
    *why = "there is no such host";
    if (getaddrinfo(host[0] ? host : "127.0.0.1", port + 1, &hints, &all) != 0)
        return false;
    *why = "nothing listens there";
    for (const struct addrinfo *a = all; a && !open; a = a->ai_next)
        open = connect_socket(a, fd);
    freeaddrinfo(all);
    return open;
}

bool os_socket_open(const char *path, int *fd, const char **why)
{
    (void)path, (void)fd;
    *why = "on Windows, smc reaches an application by HOST:PORT or a serial line";
    return false;
}

// Opens a connection to a board or an application: HOST:PORT by TCP, or else a serial port.  A number after the last ':' cannot be part of a path
// of Windows.
bool os_line_open(const char *where, unsigned long bits_per_second, int *fd, const char **why)
{
    const char *port = strrchr(where, ':');
    const bool is_address = port && port[1] && strspn(port + 1, "0123456789") == strlen(port + 1) && !strpbrk(where, "/\\");

    return is_address ? os_tcp_open(where, fd, why) : os_serial_open(where, bits_per_second, fd, why);
}

// Whether os_line_open has opened a socket, not a serial port.
static bool is_socket(int fd)
{
    int type, n = sizeof type;

    return getsockopt((SOCKET)windows_handle(fd), SOL_SOCKET, SO_TYPE, (char *)&type, &n) == 0;
}

// Sends all n bytes. Returns false if the connection accepts none for SEND_TIMEOUT_MS, or is closed.
static bool send_to_socket(SOCKET s, const uint8_t *bytes, size_t n)
{
    while (n > 0) {
        const int put = send(s, (const char *)bytes, (int)n, 0);

        if (put < 0 && (WSAGetLastError() != WSAEWOULDBLOCK || !wait_for_socket(s, POLLOUT, SEND_TIMEOUT_MS)))
            return false;
        bytes += put > 0 ? put : 0;
        n -= put > 0 ? (size_t)put : 0;
    }
    return true;
}

// os_serial_receive for a socket: returns the number of bytes received, 0 after `wait` ms without any, -1 if the connection is closed.
static int receive_from_socket(SOCKET s, uint8_t *bytes, size_t room, uint32_t wait)
{
    WSAPOLLFD p = {s, POLLIN, 0};
    const int ready = WSAPoll(&p, 1, (int)wait);
    const int got = ready > 0 ? recv(s, (char *)bytes, (int)room, 0) : 0;

    return ready == 0 ? 0 : got > 0 ? got : -1;
}

// ---- reading and writing ----

// Sets how long a read waits: until the first byte, at most `wait` ms.  (With MAXDWORD twice, Windows returns as soon as a byte is there.)
static bool set_port_timeouts(HANDLE port, uint32_t wait)
{
    COMMTIMEOUTS t = {MAXDWORD, MAXDWORD, wait, 0, SEND_TIMEOUT_MS};

    if (wait == 0)
        t.ReadTotalTimeoutMultiplier = 0;             // returns at once
    return SetCommTimeouts(port, &t);
}

bool os_serial_send(int fd, const uint8_t *bytes, size_t n)
{
    const HANDLE port = windows_handle(fd);
    DWORD put;

    if (is_socket(fd))
        return send_to_socket((SOCKET)port, bytes, n);
    for (; n > 0; bytes += put, n -= put)
        if (!set_port_timeouts(port, 0) || !WriteFile(port, bytes, (DWORD)n, &put, NULL) || put == 0)
            return false;
    return true;
}

int os_serial_receive(int fd, uint8_t *bytes, size_t room, uint32_t wait)
{
    const HANDLE port = windows_handle(fd);
    DWORD got = 0, state;

    if (wait > WAIT_MOST_MS)
        wait = WAIT_MOST_MS;
    if (is_socket(fd))
        return receive_from_socket((SOCKET)port, bytes, room, wait);
    if (!set_port_timeouts(port, wait) || !ReadFile(port, bytes, (DWORD)room, &got, NULL))
        return -1;
    // the device may be gone: some drivers then report 0 bytes read instead of an error
    return got > 0 ? (int)got : ClearCommError(port, &state, NULL) ? 0 : -1;
}

void os_serial_close(int fd)
{
    if (is_socket(fd))
        closesocket((SOCKET)windows_handle(fd));
    else
        CloseHandle(windows_handle(fd));
}

uint32_t os_milliseconds(void) { return (uint32_t)(uint64_t)(os_seconds() * 1000); }

uint16_t os_run_nonce(void)
{
    LARGE_INTEGER now;

    QueryPerformanceCounter(&now);
    return (uint16_t)((uint64_t)now.QuadPart + GetTickCount() * 7919ull + GetCurrentProcessId() * 31ull);
}
