// SPDX-License-Identifier: Apache-2.0
// A file with recorded data, which the caller of the compiler supplies: libsmc opens no file itself.  A file is read from its start as often
// as it is opened, and several readers can be open at once.
#ifndef SMC_DATA_FILE_H
#define SMC_DATA_FILE_H

#include <stdbool.h>
#include <stddef.h>

// An open file.
typedef struct DataStream DataStream;
struct DataStream {
    void *self;               // for the implementation alone, like `at`
    size_t at;
    // Reads up to n bytes and stores their number in *got; 0 at the end of the file.  Returns false and sets *why to a phrase on an error.
    bool (*read)(DataStream *s, char *into, size_t n, size_t *got, const char **why);
    void (*close)(DataStream *s);
};

typedef struct DataFile {
    const char *name;         // the name shown in messages
    void *context;
    // Opens the file at its start.  Returns false and sets *why to a phrase, such as "it is a folder", if it cannot be read.
    bool (*open)(const struct DataFile *file, DataStream *stream, const char **why);
} DataFile;

// A file that is `size` bytes in memory.  `name` and `bytes` must outlast it.
typedef struct DataMemory { DataFile file; const char *bytes; size_t size; } DataMemory;
void data_memory_init(DataMemory *m, const char *name, const char *bytes, size_t size);

#endif
