// SPDX-License-Identifier: Apache-2.0
#include "compiler/data/data_file.h"

#include <string.h>

// Reads from bytes in memory, as DataStream.read.
static bool read_memory(DataStream *s, char *into, size_t n, size_t *got, const char **why)
{
    const DataMemory *m = s->self;
    const size_t left = m->size - s->at;

    (void)why;
    *got = n < left ? n : left;
    if (*got)
        memcpy(into, m->bytes + s->at, *got);
    s->at += *got;
    return true;
}

static void close_memory(DataStream *s) { (void)s; }

static bool open_memory(const DataFile *file, DataStream *stream, const char **why)
{
    (void)why;
    *stream = (DataStream){file->context, 0, read_memory, close_memory};
    return true;
}

void data_memory_init(DataMemory *m, const char *name, const char *bytes, size_t size)
{
    m->file = (DataFile){name, m, open_memory};
    m->bytes = bytes;
    m->size = size;
}
