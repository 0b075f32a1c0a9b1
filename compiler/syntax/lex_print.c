// SPDX-License-Identifier: Apache-2.0
// Prints the tokens of a source: --emit=tokens. Each line has the position, the kind, and the text as written.
#include "compiler/syntax/lex.h"
#include "compiler/syntax/parse.h"

// Prints the tokens of a source, one per line, comments included: --emit=tokens.
void lex_print(StrPool *strings, Diags *diags, const Source *src, FileKind kind, Buf *out)
{
    Lexer l;
    Token t;

    lex_init(&l, strings, diags, src);
    l.keep_comments = true;
    l.config = kind == FILE_IO || kind == FILE_APP || kind == FILE_NET;
    l.addresses = kind == FILE_NET;
    l.requirements = kind == FILE_RQ;
    do {
        LineCol at;
        lex_next(&l, &t);
        at = source_position(src, t.at);
        buf_printf(out, "%lu:%lu\t%s\t", (unsigned long)at.line, (unsigned long)at.col, lex_token_name(t.kind));
        for (uint32_t i = 0; i < t.len; i++) {
            char c = src->text[t.at + i];
            buf_char(out, c == '\n' || c == '\r' || c == '\t' ? ' ' : c);
        }
        buf_char(out, '\n');
    } while (t.kind != TOK_END);
}
