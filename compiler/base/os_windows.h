// SPDX-License-Identifier: Apache-2.0
// What the files os_*_windows.c share.  Texts outside them are UTF-8, and Windows receives UTF-16.
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

// Conversions into heap memory, which the caller frees (os_alloc).  NULL: out of memory.  Bytes that are no UTF-8 become U+FFFD.
wchar_t *windows_wide(const char *text);
char *windows_utf8(const wchar_t *text);

// Returns the path for Windows, on the heap: absolute, with the prefix \\?\ that permits more than 260 characters.  Names of devices become
// \\.\NAME.  The Unix names /dev/null and /dev/stdin are accepted.  NULL: out of memory.
wchar_t *windows_path(const char *path);

// The sentence of an error of Windows, as POSIX systems word it.  windows_set_reason stores that of GetLastError and returns false.
const char *windows_reason(DWORD error);
bool windows_set_reason(const char **why);

// Handles as the int of os.h: Windows uses only 32 bits of a handle.
static inline int windows_number(HANDLE handle) { return (int)(intptr_t)handle; }
static inline HANDLE windows_handle(int number) { return (HANDLE)(intptr_t)number; }

// Fills a security descriptor that gives access to this user alone; the caller frees *acl with LocalFree.  Returns false if that fails.
bool windows_private_security(SECURITY_ATTRIBUTES *attributes, SECURITY_DESCRIPTOR *descriptor, ACL **acl);

// Ends running partners and removes folders that could not be removed while they ran.  Called when a signal ends the process.
void windows_end_processes(void);

#endif
