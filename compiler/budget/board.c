// SPDX-License-Identifier: Apache-2.0
#include "compiler/budget/board.h"

#include <string.h>

#include "compiler/base/buf.h"

static const Board boards[] = {
#define BOARD(mcu, name, image, ram, digital, analog, functions) {mcu, name, image, ram, digital, analog, functions},
#include "compiler/budget/boards.def"
#undef BOARD
};

enum { BOARDS = sizeof boards / sizeof *boards };

const Board *board_find(const char *mcu)
{
    for (size_t i = 0; i < BOARDS; i++)
        if (strcmp(boards[i].mcu, mcu) == 0)
            return &boards[i];
    return NULL;
}

// Returns the first board of the table, sorted by size, that has room for the image and RAM and knows all functions of the set; NULL: none.
const Board *board_smallest(uint32_t image, uint32_t ram, uint32_t functions)
{
    for (size_t i = 0; i < BOARDS; i++)
        if (image <= boards[i].image && ram <= boards[i].ram && (functions & ~boards[i].functions) == 0)
            return &boards[i];
    return NULL;
}

const Board *board_largest(void) { return &boards[BOARDS - 1]; }

// The elementary functions, each with its bit in Board.functions.
static const struct { const char *name; uint32_t bit; } functions[] = {
#define SM_ELEMENTARY(name, arguments, number) {#name, UINT32_C(1) << (number)},
#include "stdlib/elementary.def"
#undef SM_ELEMENTARY
};

bool board_has_function(const Board *b, const char *name)
{
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++)
        if (strcmp(functions[i].name, name) == 0)
            return (b->functions & functions[i].bit) != 0;
    return false;
}

const char *board_list_with_function(Arena *arena, const char *name)
{
    const char *list = NULL;

    for (size_t i = 0; i < BOARDS; i++)
        if (board_has_function(&boards[i], name))
            list = list ? format_in(arena, "%s or a %s", list, boards[i].name) : format_in(arena, "a %s", boards[i].name);
    return list;
}
