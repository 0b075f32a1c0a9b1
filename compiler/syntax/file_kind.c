// SPDX-License-Identifier: Apache-2.0
// Finds the kind of a source file from its name.
#include <string.h>

#include "compiler/syntax/ast.h"

bool file_kind(const char *path, FileKind *kind)
{
    static const char *const ending[] = {".sv", ".sm", ".ss", ".io", ".app"};         // by FileKind
    const size_t n = strlen(path);

    for (size_t i = 0; i < sizeof ending / sizeof *ending; i++) {
        const size_t m = strlen(ending[i]);
        if (n >= m && strcmp(path + n - m, ending[i]) == 0) {
            *kind = (FileKind)i;
            return true;
        }
    }
    return false;
}
