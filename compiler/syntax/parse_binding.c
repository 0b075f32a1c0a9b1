// SPDX-License-Identifier: Apache-2.0
// Parses the bindings of a machine: { fire = fireDrogue  armed = armed } (docs/config.md 10.29). Line ends count as blanks.
#include "compiler/syntax/hints.h"
#include "compiler/syntax/parser_app.h"

#define BINDING_EXAMPLE "machine drogue \"channel.sm\" { fire = fireDrogue }"

// Parses `fire = fireDrogue`, and adds it to `into`. Any name can be on the left, also one that is a word of the application elsewhere.
bool app_parse_binding(Parser *p, AstBindings *into)
{
    AstBinding b = {0};
    const uint32_t at = p->tok.at;

    if (p->tok.kind != TOK_NAME) {
        app_report_expected(p, "a name of the machine, or '}'", BINDING_EXAMPLE);
        return false;
    }
    b.name = (AstWord){p->tok.text, parser_token_span(p)};
    parser_advance(p);
    if (p->tok.kind != TOK_ASSIGN) {
        app_report_expected(p, "'='", BINDING_EXAMPLE);
        return false;
    }
    parser_advance(p);
    b.value = parse_value_of(p, false);
    b.span = parser_span_since(p, at);
    if (b.value->kind == AST_NAME)
        b.element = (AstWord){b.value->name, b.value->span};
    if (!p->failed && b.value->kind != AST_ERROR)
        vec_push(p->arena, into, b);
    return !p->failed;
}

// After an error inside the braces: skips to the closing one, or to the next section.
static void skip_braces(Parser *p)
{
    while (p->tok.kind != TOK_RBRACE && p->tok.kind != TOK_HEADER && p->tok.kind != TOK_END)
        parser_advance(p);
    if (p->tok.kind == TOK_RBRACE)
        parser_advance(p);
}

void app_parse_bindings(Parser *p, AstBindings *into)
{
    parser_advance(p);
    if (p->tok.kind == TOK_RBRACE)
        app_report_expected(p, "a name of the machine", BINDING_EXAMPLE);
    while (!p->failed && p->tok.kind != TOK_RBRACE && app_parse_binding(p, into))
        if (p->tok.kind == TOK_COMMA) {
            diag_edit(p->diags, parser_report(p, DIAG_binding_comma, parser_token_span(p)), parser_token_span(p), "");
            parser_advance(p);
        }
    if (p->failed)
        skip_braces(p);
    else
        parser_advance(p);
}
