// SPDX-License-Identifier: Apache-2.0
// Writes the text of docs/diagnostics.md, before it is wrapped, to standard output.
#include "compiler/diag/diag.h"
#include "tests/unit/host.h"

int main(void)
{
    static Arena arena;
    Buf out;
    bool written;

    HOST_ARENA(&arena);
    buf_init(&out, &arena);
    diags_write_markdown(&out);
    written = fwrite(out.at, 1, out.n, stdout) == out.n;
    arena_free(&arena);
    return written ? 0 : 1;
}
