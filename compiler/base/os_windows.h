// SPDX-License-Identifier: Apache-2.0
// What the files os_windows.c and os_*_windows.c share.  Texts outside them are UTF-8, and Windows receives UTF-16.
#ifndef SMC_OS_WINDOWS_H
#define SMC_OS_WINDOWS_H

#ifndef _WIN32_WINNT
#define _WIN32_WINNT 0x0601             // Windows 7
#endif
#define WIN32_LEAN_AND_MEAN
#include <windows.h>

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <wchar.h>

BOOLEAN NTAPI SystemFunction036(PVOID bytes, ULONG n);      // RtlGenRandom, which headers declare under this name only

// Conversions into heap memory, which the caller frees (os_alloc).  NULL: out of memory.  Bytes that are no UTF-8 become U+FFFD.
wchar_t *windows_wide(const char *text);
char *windows_utf8(const wchar_t *text);

// Returns the path for Windows, on the heap: absolute, with the prefix \\?\ that permits more than 260 characters.  Names of devices become
// \\.\NAME.  The Unix names /dev/null and /dev/stdin are accepted.  NULL: out of memory.
wchar_t *windows_path(const char *path);

wchar_t *windows_join(const wchar_t *a, const wchar_t *b);       // returns both texts as one, on the heap
char *windows_plain_path(const wchar_t *path);                    // returns the path without the prefix \\?\ as UTF-8, on the heap

// Returns false, and sets *why, if the path contains a control character.
bool windows_check_name(const char *path, const char **why);
DWORD windows_attributes(const char *path);                       // GetFileAttributesW

// Opens a file that exists; other programs can use it meanwhile.  Returns the result of CreateFileW.
HANDLE windows_open_existing(const char *path, DWORD access);
// Creates a file that does not exist yet.  Others can read and remove it while it is open, so that a signal can remove it.
// INVALID_HANDLE_VALUE: the reason is in *why.
HANDLE windows_create_new(const char *path, SECURITY_ATTRIBUTES *security, const char **why);
bool windows_write_all(HANDLE file, const void *bytes, size_t n, const char **why);

HANDLE windows_standard_stream(int fd);                           // returns the handle of stdin (0), stdout (1) or stderr (2)

// The sentence of an error of Windows, as POSIX systems word it.  windows_set_reason stores that of GetLastError, windows_set_no_memory
// stores "out of memory"; both return false.
const char *windows_reason(DWORD error);
bool windows_set_reason(const char **why);
bool windows_set_no_memory(const char **why);

// Handles as the int of os.h: Windows uses only 32 bits of a handle.
static inline int windows_number(HANDLE handle) { return (int)(intptr_t)handle; }
static inline HANDLE windows_handle(int number) { return (HANDLE)(intptr_t)number; }

// Fills a security descriptor that gives access to this user alone; the caller frees *acl with LocalFree.  Returns false if that fails.
bool windows_private_security(SECURITY_ATTRIBUTES *attributes, SECURITY_DESCRIPTOR *descriptor, ACL **acl);

// Ends running partners and removes folders that could not be removed while they ran.  Called when a signal ends the process.
void windows_end_processes(void);

#endif
