// SPDX-License-Identifier: Apache-2.0
// Connects two programs by a serial line: two terminal devices, of which each receives every byte that is written to the other.  When this
// program ends, both devices disappear, as if the adapter was unplugged.
//   bridge FILE              writes the names of both devices to FILE, one per line
#define _XOPEN_SOURCE 700
#define _DEFAULT_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <termios.h>
#include <unistd.h>

// Opens a terminal device, and holds its other end open, so that it does not hang up between two programs.
static int open_line(FILE *names)
{
    const int master = posix_openpt(O_RDWR | O_NOCTTY);
    struct termios t;
    int slave;

    if (master < 0 || grantpt(master) != 0 || unlockpt(master) != 0 || (slave = open(ptsname(master), O_RDWR | O_NOCTTY)) < 0 || tcgetattr(slave, &t) != 0) {
        perror("bridge");
        exit(1);
    }
    cfmakeraw(&t);
    tcsetattr(slave, TCSANOW, &t);
    fprintf(names, "%s\n", ptsname(master));
    return master;
}

static void pass_bytes(int from, int to)
{
    char bytes[256];
    const ssize_t n = read(from, bytes, sizeof bytes);

    for (ssize_t at = 0; at < n;) {
        const ssize_t put = write(to, bytes + at, (size_t)(n - at));
        if (put < 0 && errno != EINTR)
            return;
        at += put > 0 ? put : 0;
    }
}

int main(int argc, char **argv)
{
    FILE *names = argc == 2 ? fopen(argv[1], "w") : NULL;
    struct pollfd line[2];

    if (!names)
        return 2;
    for (int i = 0; i < 2; i++)
        line[i] = (struct pollfd){open_line(names), POLLIN, 0};
    fclose(names);
    while (poll(line, 2, -1) >= 0 || errno == EINTR)
        for (int i = 0; i < 2; i++)
            if (line[i].revents & POLLIN)
                pass_bytes(line[i].fd, line[1 - i].fd);
    return 0;
}
