// SPDX-License-Identifier: Apache-2.0
// A cc.exe for Wine: the cross compiler of this system, which Wine cannot start itself.  It writes its arguments to a file in the folder RELAY, and waits
// for the file that cc.sh answers with.
#include <stdio.h>
#include <stdlib.h>
#include <windows.h>

// Copies the compiler's output.
static void print_file(const char *path)
{
    FILE *f = fopen(path, "rb");
    int c;

    while (f && (c = getc(f)) != EOF)
        putchar(c);
    if (f)
        fclose(f);
}

int main(int argc, char **argv)
{
    const char *relay = getenv("RELAY");
    char base[300], path[320], sent[320];
    int code = 1;
    FILE *f;

    if (!relay)
        return 1;
    snprintf(base, sizeof base, "%s/%lu-%lu", relay, (unsigned long)GetCurrentProcessId(), (unsigned long)GetTickCount());
    snprintf(path, sizeof path, "%s.new", base);
    snprintf(sent, sizeof sent, "%s.args", base);
    if ((f = fopen(path, "wb")) == NULL)
        return 1;
    for (int i = 1; i < argc; i++)
        fprintf(f, "%s\n", argv[i]);
    fclose(f);
    rename(path, sent);
    snprintf(path, sizeof path, "%s.code", base);
    while ((f = fopen(path, "rb")) == NULL)
        Sleep(10);
    if (fscanf(f, "%d", &code) != 1)
        code = 1;
    fclose(f);
    snprintf(path, sizeof path, "%s.out", base);
    print_file(path);
    return code;
}
