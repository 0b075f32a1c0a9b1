// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/os_files.h"

#include <stdlib.h>

bool os_read_all(intptr_t file, size_t most, char **text, size_t *len, const char **why)
{
    size_t cap = 16384, n = 0;
    char *buffer = malloc(cap);

    while (buffer) {
        const long got = os_read_some(file, buffer + n, cap - n - 1, why);
        if (got < 0 || n > most) {
            if (got >= 0)
                *why = "the file is too large";
            free(buffer);
            return false;
        }
        if (got == 0) {
            buffer[n] = '\0';
            *text = buffer;
            *len = n;
            return true;
        }
        n += (size_t)got;
        if (cap - n < 2) {
            char *larger = realloc(buffer, cap *= 2);
            if (!larger)
                free(buffer);
            buffer = larger;
        }
    }
    *why = "out of memory";
    return false;
}

// Reads up to n bytes; *got is their number, 0 at the end. Returns false and sets *why if that fails or the file has become shorter.
bool os_reader_get(OsReader *r, void *into, size_t n, size_t *got, const char **why)
{
    const long bytes = os_read_some(r->file, into, n, why);

    *got = bytes > 0 ? (size_t)bytes : 0;
    r->done += *got;
    if (bytes == 0 && r->done < r->size)
        *why = "the file became shorter while it was read";
    return bytes > 0 || (bytes == 0 && r->done >= r->size);
}

// Unregisters a temporary file, so that a signal no longer removes it, and frees its path.
void os_forget_temporary(int number)
{
    char *temp = os_unfinished_path(number);

    os_set_unfinished(number, NULL);
    free(temp);
}

// Writes all outputs or none: to temporary files first, which then replace the targets. Sets *failed_path and *why if that fails.
bool os_write_files(const OsOutput *out, size_t n, const char **failed_path, const char **why)
{
    char *target[OS_OUTPUTS_MOST] = {NULL};
    bool ok = n <= OS_OUTPUTS_MOST;

    *failed_path = n ? out[0].path : "";
    *why = "too many files";
    os_signals_begin();
    for (size_t i = 0; ok && i < n; i++) {
        *failed_path = out[i].path;
        ok = os_write_temporary(&out[i], (int)i, &target[i], why);
    }
    os_signals_delay();                               // a signal cannot interrupt the renames
    for (size_t i = 0; ok && i < n; i++)
        if (target[i]) {
            *failed_path = out[i].path;
            ok = os_replace_file(os_unfinished_path((int)i), target[i], why);
        }
    for (size_t i = 0; i < n && i < OS_OUTPUTS_MOST; i++) {
        if (!ok && os_unfinished_path((int)i))
            os_remove_file(os_unfinished_path((int)i));
        os_forget_temporary((int)i);
        free(target[i]);
    }
    os_signals_resume();
    os_signals_end();
    return ok;
}
