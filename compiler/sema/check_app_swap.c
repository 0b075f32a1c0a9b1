// SPDX-License-Identifier: Apache-2.0
// Checks the path, address or line on which a running application accepts swaps, and its key (docs/config.md 10.25, 10.26).
#include "compiler/sema/app_check.h"

#include <string.h>

enum { USED_SUFFIX = 5 };             // characters of ".used", which the generated code appends to the name of the key

// Reads a decimal number up to `most`, and moves *text after it.
static bool read_number(const char **text, unsigned long most, unsigned long *value)
{
    const char *at = *text;

    *value = 0;
    while (*at >= '0' && *at <= '9' && *value <= most)
        *value = *value * 10 + (unsigned long)(*at++ - '0');
    if (at == *text || *value > most)
        return false;
    *text = at;
    return true;
}

// Reads an address with a port, "10.0.0.5:4711", or only a port, ":4711", which means the loopback address.
static bool read_address(const char *text, AppSwapAt *out)
{
    static const uint8_t loopback[4] = {127, 0, 0, 1};
    unsigned long n;

    memcpy(out->ip, loopback, sizeof out->ip);
    for (int i = 0; i < 4 && *text != ':'; i++) {
        if (!read_number(&text, 255, &n) || *text != (i < 3 ? '.' : ':'))
            return false;
        out->ip[i] = (uint8_t)n;
        text += i < 3;
    }
    if (*text++ != ':' || !read_number(&text, 65535, &n) || n == 0 || *text != '\0')
        return false;
    out->port = (uint16_t)n;
    return true;
}

// Classifies the name in `swap at`: a serial line (/dev/...), a network address (with a colon and no slash) or a path.
static AppPlace classify_place(const char *name)
{
    if (strncmp(name, "/dev/", 5) == 0)
        return APP_AT_LINE;
    return strchr(name, ':') && !strchr(name, '/') ? APP_AT_ADDRESS : APP_AT_PATH;
}

static void check_place(AppCheck *k, const AstAppOption *o, AppSwapAt *out)
{
    out->name = o->file.text;
    out->place = classify_place(out->name->text);
    if (out->place == APP_AT_ADDRESS && !read_address(out->name->text, out))
        diag_report(k->c->diags, DIAG_app_swap_address, o->file.span, out->name->text);
    else if (out->place != APP_AT_ADDRESS)
        check_app_name_length(k, &o->file, &app_ranges[out->place == APP_AT_PATH ? APP_RANGE_swap_path : APP_RANGE_name_length]);
}

void check_app_swap_at(AppCheck *k, const AstAppOption *o)
{
    AppSwapAt *out = &k->app->swap_at;
    AppRange name = app_ranges[APP_RANGE_name_length];
    uint64_t n = 0;

    if (o->kind == AST_APP_swap_at) {
        check_place(k, o, out);
    } else if (o->kind == AST_APP_swap_speed) {
        app_check_amount(k, &o->amount, APP_RANGE_swap_speed, &n);
        out->speed = (uint32_t)n;
    } else {
        name.most -= USED_SUFFIX;
        name.limits = "1 to 122 characters";
        check_app_name_length(k, &o->file, &name);
        out->key = o->file.text;
    }
}

// Reports an option that has no effect, if it exists.
static void report_unused_option(AppCheck *k, AstAppOptionKind kind, DiagCode why)
{
    const AstAppOption *o = app_find_option(k->ast, kind);

    if (o)
        diag_report(k->c->diags, DIAG_app_option_unused, o->name_span, app_option_name(kind), diag_text(k->c->diags, why));
}

void check_app_swap_place(AppCheck *k)
{
    AppSwapAt *at = &k->app->swap_at;

    if (at->place == APP_AT_ADDRESS && at->ip[0] != 127 && at->port != 0 && !at->key)
        diag_report(k->c->diags, DIAG_app_swap_key, app_find_option(k->ast, AST_APP_swap_at)->file.span, at->name->text);
    if (at->place == APP_NOWHERE && !k->ast->lost)
        report_unused_option(k, AST_APP_swap_key, DIAG_part_no_swap_at);
    if (at->place != APP_AT_LINE && !k->ast->lost)
        report_unused_option(k, AST_APP_swap_speed, at->place == APP_NOWHERE ? DIAG_part_no_swap_at : DIAG_part_no_line);
    if (at->speed == 0)
        at->speed = 115200;
}
