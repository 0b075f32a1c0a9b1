// SPDX-License-Identifier: Apache-2.0
// os_serial.h on Windows.
#include "compiler/base/os_serial.h"
#include "compiler/base/os.h"
#include "compiler/base/os_windows.h"

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

// Returns false if the device is no serial line, or refuses the mode.
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

// Sets how long a read waits: until the first byte, at most `wait` ms.  (With MAXDWORD twice, Windows returns as soon as a byte is there.)
static bool set_timeouts(HANDLE port, uint32_t wait)
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

    for (; n > 0; bytes += put, n -= put)
        if (!set_timeouts(port, 0) || !WriteFile(port, bytes, (DWORD)n, &put, NULL) || put == 0)
            return false;
    return true;
}

int os_serial_receive(int fd, uint8_t *bytes, size_t room, uint32_t wait)
{
    const HANDLE port = windows_handle(fd);
    DWORD got = 0, state;

    if (!set_timeouts(port, wait > WAIT_MOST_MS ? WAIT_MOST_MS : wait) || !ReadFile(port, bytes, (DWORD)room, &got, NULL))
        return -1;
    return got > 0 ? (int)got : ClearCommError(port, &state, NULL) ? 0 : -1;      // some drivers read nothing from a device that is gone
}

void os_serial_close(int fd) { CloseHandle(windows_handle(fd)); }

uint32_t os_milliseconds(void) { return (uint32_t)(uint64_t)(os_seconds() * 1000); }

uint16_t os_run_nonce(void)
{
    LARGE_INTEGER now;

    QueryPerformanceCounter(&now);
    return (uint16_t)((uint64_t)now.QuadPart + GetTickCount() * 7919ull + GetCurrentProcessId() * 31ull);
}
